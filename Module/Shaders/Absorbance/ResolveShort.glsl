// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/ResolveShort.glsl: the same as Resolve.glsl for lists of up to BLOCK_SIZE fragments, which are read once,
// into registers. Longer ones are left to LONGER_LEVEL. The technique's file includes it last.
//
// Needs: what Absorbance/Weigh.glsl needs, BLOCK_SIZE, EQUAL_DEPTHS 0, LONGER_LEVEL, COLOR_FORMAT.
#ifndef LONGER_LEVEL
#error "Absorbance/ResolveShort.glsl needs LONGER_LEVEL"
#endif
#define FRAGMENTS_READ_ONLY 1
#include "ABuffer/LoadBlock.glsl"
#include "Absorbance/Weigh.glsl"
#include "Common/FinishPixel.glsl"
#include "Common/Statistics.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  Block block;
  uint count;
  uint unread;
  loadBlock(pixel, block, count, unread);
  if (unread != 0u)
  {
    leaveToLevel(pixel, LONGER_LEVEL);
    return false;
  }
  Surface surfaces[BLOCK_SIZE];
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    surfaces[i] = unpackColor(block.color[i]);
    // An empty element is transparent, and lies behind all that can be computed with.
    block.depth[i] = min(block.depth[i], 1.0);
  }
  Sums sums;
  clearSums(sums);
#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_FRAGMENTS
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    bound(sums, block.depth[i], surfaces[i]);
  }
#endif
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    absorb(sums, block.depth[i], surfaces[i].opacity);
  }
  prepareTerms(sums.terms);
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    weigh(sums, block.depth[i], surfaces[i]);
  }
  transmittance = sums.transmittance;
  color = colorOf(sums);
  finishPixel(pixel, count);
  return count > 0u;
}

#include "Common/Resolve.glsl"
