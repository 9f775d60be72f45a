// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Statistics.glsl: what a resolve learns about the frame and leaves for the application and for later resolves.
//
// A resolve may leave pixels to a later one: it marks their square of RESOLVE_SQUARE x RESOLVE_SQUARE pixels with the
// later one's level, and only squares so marked are drawn then (see ResolveSquares.glsl). Code for long lists so never
// runs, and never takes registers, where lists are short.
//
// Needs: nothing.  Gives: recordFragments, recordUnfinished, leaveToLevel, squareLevels.
#ifndef Statistics_glsl
#define Statistics_glsl
#include "Common/Bindings.glsl"
#include "Common/Frame.glsl"

layout(std430, binding = STORAGE_BINDING_STATISTICS) buffer TranslucencyStatistics
{
  uint deepestPixel; // fragments, of all tiles so far
  uint unfinished;   // not 0 if a list was not read to its end
  // Of this tile:
  uint cellsOverflowed; // not 0 if fragments did not fit: Storage/SumCells.glsl
  uint cellsFragments;
  uint cellsUnits;
  uint fullestCell; // fragments
  uint leftLevels;  // bit n is set if a pixel was left to level n
  uint unused;
  uint squareLevels[]; // the same for each square, row by row
};

uint squareOf(ivec2 pixel)
{
  ivec2 square = (pixel - frameTile.xy) / RESOLVE_SQUARE;
  int squaresAcross = (frameTile.z + RESOLVE_SQUARE - 1) / RESOLVE_SQUARE;
  return uint(square.y * squaresAcross + square.x);
}

// Called once a pixel with the number of its fragments. The plain read spares most pixels the atomic operation.
void recordFragments(uint count)
{
  if (count > deepestPixel)
  {
    atomicMax(deepestPixel, count);
  }
}

// Called where a loop over a list has ended: drivers may end a loop that takes too long, and say nothing.
void recordUnfinished(uint cursor)
{
  if (cursor != 0u)
  {
    unfinished = 1u;
  }
}

void leaveToLevel(ivec2 pixel, uint level)
{
  uint square = squareOf(pixel);
  uint mark = 1u << level;
  if ((squareLevels[square] & mark) == 0u)
  {
    atomicOr(squareLevels[square], mark);
    atomicOr(leftLevels, mark);
  }
}

#endif
