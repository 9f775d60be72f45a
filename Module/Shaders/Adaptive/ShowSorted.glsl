// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/ShowSorted.glsl: a pixel that is drawn exactly, by sorting its fragments: no error, and as many nodes as
// there can be.
//
// Needs: SHOW, COLOR_FORMAT.
#define FRAGMENTS_READ_ONLY 1
#include "Adaptive/Show.glsl"
#include "Common/Fragment.glsl"
#include "Common/FinishPixel.glsl"
#include "Storage/Selected.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  uint count = 0u;
  Fragment fragment;
  uint cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    count += fragment.color != PackedColor(0u) ? 1u : 0u;
  }
  showPixel(0.0, 64, color, transmittance);
  finishPixel(pixel, count);
  return count > 0u;
}

#include "Common/Resolve.glsl"
