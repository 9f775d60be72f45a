// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStorageTable
 *
 * The storages that there are: the choices of the option storage, and what the tests of all storages find.
 */
#ifndef vtkStorageTable_h
#define vtkStorageTable_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkTranslucencyABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFragmentStorage;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkStorageTable
{
public:
  /// linked-list, t-buffer, r-buffer, m-buffer: vtkFragmentStorage::GetName of each.
  static const std::vector<std::string>& GetNames();

  /// A new one, by its place among the names.
  static vtkSmartPointer<vtkFragmentStorage> New(int index);
};
VTK_ABI_NAMESPACE_END

#endif
