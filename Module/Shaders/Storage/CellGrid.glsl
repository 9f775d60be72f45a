// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CellGrid.glsl: which cell of the tile a pixel lies in, and where its entry and its cell's counters are.
//
// Needs: nothing.  Gives: cellShift, cellUnits, headIndex, counterOfCell, counterOf.
#ifndef CellGrid_glsl
#define CellGrid_glsl
#include "Common/Bindings.glsl"
#include "Common/Frame.glsl"
#include "Storage/CellLayout.glsl"

layout(std140, binding = UNIFORM_BINDING_STORAGE) uniform StorageLayout
{
  uint cellShift;
  uint cellUnits; // of all cells
};

uint headIndex(ivec2 pixel)
{
  ivec2 at = pixel - frameTile.xy;
  return uint(at.y * frameTile.z + at.x);
}

uint counterOfCell(uvec2 cell)
{
  uint cellsPerRow = (uint(frameTile.z - 1) >> cellShift) + 1u;
  return (cell.y * cellsPerRow + cell.x) * CELL_WORDS;
}

uint counterOf(ivec2 pixel)
{
  return counterOfCell(uvec2(pixel - frameTile.xy) >> cellShift);
}

#endif
