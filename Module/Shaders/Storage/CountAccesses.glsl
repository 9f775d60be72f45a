// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CountAccesses.glsl: reads each pixel's fragments once, counts what that accesses, and how many they are.
//
// Needs: what the storage needs.
#define FRAGMENTS_READ_ONLY 1
#define COUNT_ACCESSES 1
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

#define FRAGMENTS_A_ROUND 8 // drivers may limit the rounds of a loop

layout(std430, binding = STORAGE_BINDING_READ_BACK) buffer PixelFragments
{
  uint pixelFragments[];
};

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  uint count = 0u;
  uint cursor = firstFragment(pixel);
  while (cursor != 0u)
  {
    for (int i = 0; i < FRAGMENTS_A_ROUND; ++i)
    {
      Fragment fragment;
      count += nextFragment(cursor, fragment) ? 1u : 0u;
    }
  }
  recordUnfinished(cursor);
  pixelFragments[headIndex(pixel)] = count;
  uint counter = counterOf(pixel);
  addAccesses(counter, CELL_READS, readAccesses);
  addAccesses(counter, CELL_TABLE, tableAccesses);
  return false;
}

#include "Common/Resolve.glsl"
