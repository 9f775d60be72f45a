// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Resolve.glsl: visibility from sums, from lists of all fragments (Salvi 2011, section 4.1). The technique's
// file includes it last.
//
// Walks over a pixel's list: for the bounds of its depths, for the terms, and for the fragments weighted by their
// visibility. Pixels whose loops the driver ends are left to UNFINISHED_LEVEL, which sorts.
//
// Needs: what Absorbance/Weigh.glsl needs, UNFINISHED_LEVEL, COLOR_FORMAT.
#ifndef UNFINISHED_LEVEL
#error "Absorbance/Resolve.glsl needs UNFINISHED_LEVEL"
#endif
#define FRAGMENTS_READ_ONLY 1
#include "Absorbance/Weigh.glsl"
#include "Common/FinishPixel.glsl"
#include "Common/Fragment.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  Sums sums;
  clearSums(sums);
  Fragment fragment;
  uint unread = 0u;
  uint cursor;
#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_FRAGMENTS
  cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    bound(sums, fragment.depth, unpackColor(fragment.color));
  }
  unread |= cursor;
#endif
  uint count = 0u;
  cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    Surface surface = unpackColor(fragment.color);
    absorb(sums, fragment.depth, surface.opacity);
    count += isThere(surface) ? 1u : 0u;
  }
  unread |= cursor;
  prepareTerms(sums.terms);
  cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    weigh(sums, fragment.depth, unpackColor(fragment.color));
  }
  if (unread != 0u || cursor != 0u)
  {
    leaveToLevel(pixel, UNFINISHED_LEVEL);
    return false;
  }
  transmittance = sums.transmittance;
  color = colorOf(sums);
  finishPixel(pixel, count);
  return count > 0u;
}

#include "Common/Resolve.glsl"
