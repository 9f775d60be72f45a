// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SquareFragments.glsl: how many fragments a cell holds, and the pixels of a square, for vertex shaders, too.
//
// The counters are fetched as texels of their buffer. A vertex shader declares no storage block: drivers need not have
// any there, and Mesa takes the wrong blocks of a fragment shader for written if the vertex shader has some of them,
// too (Documentation/Drivers.md).
//
// Needs: UNITS_ARE_FRAGMENTS (1: a unit is a fragment, and none is taken in vain).  Gives: cellWord, cellFragments,
// squareFragments.
#ifndef SquareFragments_glsl
#define SquareFragments_glsl
#ifndef UNITS_ARE_FRAGMENTS
#error "Storage/SquareFragments.glsl needs UNITS_ARE_FRAGMENTS"
#endif
#include "Storage/CellGrid.glsl"

uniform usamplerBuffer counterTexels;

uint cellWord(uint counter, uint word)
{
  return texelFetch(counterTexels, int(counter + word)).x;
}

uint cellFragments(uint counter)
{
#if UNITS_ARE_FRAGMENTS
  uint drawn = cellWord(counter, CELL_NEXT) - cellWord(counter, CELL_FIRST);
#else
  uint drawn = cellWord(counter, CELL_FRAGMENTS);
#endif
  return drawn + cellWord(counter, CELL_INSERTED);
}

// About as many fragments as a pixel of the square that begins at this one holds: the mean of its cell, rounded up. 0
// only if no pixel of the square holds a fragment; a cell is a whole number of squares.
uint squareFragments(ivec2 pixel)
{
  uint pixels = 1u << (2u * cellShift);
  return (cellFragments(counterOf(pixel)) + pixels - 1u) / pixels;
}

#endif
