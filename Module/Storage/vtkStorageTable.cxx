// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStorageTable.h"

#include "vtkLinkedListStorage.h"
#include "vtkMBufferStorage.h"
#include "vtkRBufferStorage.h"
#include "vtkTBufferStorage.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using NewFunction = vtkSmartPointer<vtkFragmentStorage> (*)();

template <typename Storage>
vtkSmartPointer<vtkFragmentStorage> NewStorage()
{
  return vtkSmartPointer<Storage>::New();
}

// In the order of vtkFragmentListPass::StorageDesignType, which has names for the first of them.
const std::vector<NewFunction> Storages{ NewStorage<vtkLinkedListStorage>, NewStorage<vtkTBufferStorage>,
  NewStorage<vtkRBufferStorage>, NewStorage<vtkMBufferStorage> };
}

//------------------------------------------------------------------------------
const std::vector<std::string>& vtkStorageTable::GetNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> found;
    for (NewFunction create : Storages)
    {
      found.emplace_back(create()->GetName());
    }
    return found;
  }();
  return names;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFragmentStorage> vtkStorageTable::New(int index)
{
  return Storages.at(static_cast<std::size_t>(index))();
}
VTK_ABI_NAMESPACE_END
