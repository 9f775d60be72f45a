// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFragmentCounter
 *
 * Counts the fragments of cells where the driver keeps the order of drawing. Shaders count only the units that are
 * taken there, which costs less than an atomic operation a fragment: a fragment lies wherever a unit is not free.
 */
#ifndef vtkFragmentCounter_h
#define vtkFragmentCounter_h

#include "vtkFragmentStorage.h" // for Rectangle

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyBuffer;

class vtkFragmentCounter
{
public:
  /// Of some entries of the table: the places for fragments that their pixels have taken and not filled.
  using CountFree = std::function<unsigned int(const unsigned int* entries, int count)>;

  /// Fills in how many fragments each cell of a tile holds (Shaders/Storage/CellLayout.glsl), of units of that length.
  void Count(std::vector<unsigned int>& cells, const vtkFragmentStorage::Rectangle& tile, int length,
    const vtkTranslucencyBuffer& table, const CountFree& countFree);

private:
  std::vector<unsigned int> Entries; // the table's, as they were last counted
};
VTK_ABI_NAMESPACE_END

#endif
