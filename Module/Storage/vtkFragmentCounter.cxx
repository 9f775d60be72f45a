// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFragmentCounter.h"

#include "Storage/CellLayout.glsl"
#include "vtkCellRoom.h"
#include "vtkTranslucencyBuffer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkFragmentCounter::Count(std::vector<unsigned int>& cells, const vtkFragmentStorage::Rectangle& tile, int length,
  const vtkTranslucencyBuffer& table, const CountFree& countFree)
{
  for (std::size_t first = 0; first < cells.size(); first += CELL_WORDS)
  {
    unsigned int* words = &cells[first];
    words[CELL_FRAGMENTS] =
      (words[CELL_NEXT] - words[CELL_FIRST] + words[CELL_PIXELS]) * static_cast<unsigned int>(length);
  }
  const int width = tile[2];
  const int shift = vtkCellRoom::GetCellShift(tile);
  const int across = vtkCellRoom::GetCells(tile)[0];
  this->Entries.resize(static_cast<std::size_t>(width) * tile[3]);
  table.Download(this->Entries.data(), static_cast<vtkTypeInt64>(this->Entries.size() * sizeof(unsigned int)));
  for (int y = 0; y < tile[3]; ++y)
  {
    for (int column = 0; column < across; ++column)
    {
      const int x = column << shift;
      const int pixels = std::min(1 << shift, width - x);
      const std::size_t cell = static_cast<std::size_t>(y >> shift) * across + column;
      cells[cell * CELL_WORDS + CELL_FRAGMENTS] -=
        countFree(&this->Entries[static_cast<std::size_t>(y) * width + x], pixels);
    }
  }
}
VTK_ABI_NAMESPACE_END
