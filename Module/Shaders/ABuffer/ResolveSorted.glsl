// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ABuffer/ResolveSorted.glsl: long lists, last step: they are in order and are blended.
//
// Eight fragments a round: drivers may limit the rounds of a loop.
//
// Needs: COLOR_FORMAT.
#define FRAGMENTS_READ_ONLY 1
#include "ABuffer/Blend.glsl"
#include "Common/FinishPixel.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  uint cursor = firstFragment(pixel);
  bool holdsFragments = cursor != 0u;
  while (cursor != 0u)
  {
    for (int i = 0; i < 8; ++i)
    {
      Fragment fragment;
      if (nextFragment(cursor, fragment))
      {
        blendBehind(color, transmittance, fragment.color);
      }
    }
  }
  recordUnfinished(cursor);
  finishPixel(pixel, 0u); // Common/SortRuns.glsl has counted them
  return holdsFragments;
}

#include "Common/Resolve.glsl"
