// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ABuffer/Iterative.glsl: weight each fragment with the transmittance of all in front of it (Salvi 2011, Eq. 2 and 4),
// found by walking the list again: n^2 steps, no sorting, no memory.
//
// GROUP fragments are weighted in one walk, which reads the list so much less often. Where a driver ends the loops of a
// very deep pixel before they are done, the pixel is left to UNFINISHED_LEVEL, which sorts.
//
// Needs: UNFINISHED_LEVEL, COLOR_FORMAT, FRAGMENT_ORDER.
#ifndef UNFINISHED_LEVEL
#error "ABuffer/Iterative.glsl needs UNFINISHED_LEVEL"
#endif
#define FRAGMENTS_READ_ONLY 1
#include "Common/Fragment.glsl"
#include "Common/Order.glsl"
#include "Common/FinishPixel.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

#define GROUP 16
#define FRAGMENTS_A_ROUND 4

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  uint first = firstFragment(pixel);
  uint cursor = first;
  uint other = 0u;
  uint count = 0u;
  while (cursor != 0u)
  {
    Fragment group[GROUP];
    Channels visibility[GROUP];
    for (int i = 0; i < GROUP; ++i)
    {
      Fragment fragment = EMPTY_FRAGMENT(0.0); // transparent, where the list has ended
      if (cursor != 0u)
      {
        nextFragment(cursor, fragment);
      }
      group[i] = fragment;
      visibility[i] = Channels(1.0);
    }
    other = first;
    uint age = 0u;
    while (other != 0u)
    {
      for (int round = 0; round < FRAGMENTS_A_ROUND; ++round)
      {
        Fragment fragment;
        if (nextFragment(other, fragment))
        {
          Channels passes = 1.0 - unpackColor(fragment.color).opacity;
          for (int i = 0; i < GROUP; ++i)
          {
            bool before = inFront(fragment.depth, fragment.color, age, group[i].depth,
              group[i].color, count + uint(i));
            visibility[i] *= before ? passes : Channels(1.0);
          }
          ++age;
        }
      }
    }
    for (int i = 0; i < GROUP; ++i)
    {
      Surface surface = unpackColor(group[i].color);
      color += visibility[i] * surface.color;
      transmittance *= 1.0 - surface.opacity;
    }
    count = min(count + uint(GROUP), age);
  }
  if (cursor != 0u || other != 0u)
  {
    leaveToLevel(pixel, UNFINISHED_LEVEL);
    return false;
  }
  finishPixel(pixel, count);
  return count > 0u;
}

#include "Common/Resolve.glsl"
