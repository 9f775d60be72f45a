// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sections.glsl: the T-buffer and the M-buffer (Storage/SectionPlaces.glsl).
//
// A place is claimed by compare and swap of the pixel's whole entry: whoever finds its section full takes another one
// from its cell, writes which one came before, and then offers it; the others read that only behind the application's
// barrier. No invocation waits for another one: a swap fails only if another one's has succeeded. Helper invocations,
// whose swaps change nothing and give undefined results, would not come to an end by that: they store nothing. Taking
// the old entry for the new one of another section is not possible, since sections are not given back. Who has taken a
// section, but found a place in somebody else's, leaves its own empty until the next frame: room is lost, no fragment
// ever. Sections behind the one that is being filled are full.
//
// Where a driver keeps the order of drawing, SectionsInOrder.glsl is used instead.
//
// Needs: what Storage/SectionPlaces.glsl needs, GL_ARB_ES3_1_compatibility.
// Gives: what Shaders/README.md asks of a storage.
#ifndef Sections_glsl
#define Sections_glsl
#include "Storage/SectionPlaces.glsl"

// A place for a fragment; beyond the last one where there is no room: the frame is counted to its end.
uint claimPlace(uint at, uint counter)
{
  uint taken = 0u;
  uint place;
  uint entry = atomicAdd(heads[at], 0u); // what others have written by now
  for (;;)
  {
    uint claimed = claimFrom(entry, at, counter, taken, place);
    uint found = atomicCompSwap(heads[at], entry, claimed);
    if (found == entry)
    {
      break;
    }
    entry = found;
  }
  countPixel(entry, counter);
  return place;
}

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
  if (gl_HelperInvocation)
  {
    return;
  }
  uint counter = counterOf(pixel);
  atomicAdd(cells[counter + CELL_FRAGMENTS], 1u);
  COUNT_STORE(counter);
  uint place = claimPlace(headIndex(pixel), counter);
  if (place < placeRoom())
  {
    writePlace(place, fragment);
  }
}

#endif
