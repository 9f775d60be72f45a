// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SectionsInOrder.glsl: the T-buffer and the M-buffer (Storage/SectionPlaces.glsl) where the driver keeps the order of
// drawing: nobody else is at the pixel's entry. How many fragments there are the entries tell (vtkFragmentCounter).
//
// Needs: what Storage/SectionPlaces.glsl needs.
// Gives: what Shaders/README.md asks of a storage.
#ifndef SectionsInOrder_glsl
#define SectionsInOrder_glsl
#include "Common/MergeSamples.glsl"
#include "Storage/SectionPlaces.glsl"

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
  uint at = headIndex(pixel);
  uint entry = heads[at];
#if MERGES_SAMPLES
  uint last = lastOf(entry);
  if (last != 0u && last <= placeRoom())
  {
    Fragment stored = readPlace(last - 1u);
    if (mayMerge(stored, fragment, depthExtent))
    {
      writePlace(last - 1u, mergeFragments(stored, fragment));
      return;
    }
  }
#endif
  uint counter = counterOf(pixel);
  COUNT_STORE(counter);
  uint taken = 0u;
  uint place; // beyond the last one where there is no room: the frame is counted to its end
  heads[at] = claimFrom(entry, at, counter, taken, place);
  countPixel(entry, counter);
  if (place < placeRoom())
  {
    writePlace(place, fragment);
  }
}

#endif
