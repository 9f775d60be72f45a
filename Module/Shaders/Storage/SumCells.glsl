// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SumCells.glsl: adds up what the cells of a tile hold, an invocation a cell, so that the application reads a few words
// instead of all counters.
//
// Needs: UNITS_ARE_FRAGMENTS.  Gives: main.
#include "Common/Statistics.glsl"
#include "Storage/SquareFragments.glsl"

out vec4 fragOutput0;

void main()
{
  uint counter = counterOfCell(uvec2(ivec2(gl_FragCoord.xy) - frameTile.xy));
  uint next = cellWord(counter, CELL_NEXT);
  uint fragments = cellFragments(counter);
  if (next > cellWord(counter, CELL_END))
  {
    cellsOverflowed = 1u;
  }
  if (fragments > 0u)
  {
    atomicAdd(cellsFragments, fragments);
    atomicAdd(cellsUnits, next - cellWord(counter, CELL_FIRST));
    atomicMax(fullestCell, fragments);
  }
  fragOutput0 = vec4(0.0);
}
