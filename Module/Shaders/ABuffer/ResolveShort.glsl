// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ABuffer/ResolveShort.glsl: pixels of up to BLOCK_SIZE fragments, which never leave the registers.
//
// Longer lists are left to LONGER_LEVEL, and with EQUAL_DEPTHS 0 those with fragments of equal depth to
// EQUAL_DEPTHS_LEVEL, which is this shader with EQUAL_DEPTHS 1.
//
// Where fragments cover only some samples of a pixel, its list is read and sorted once, and blended once a sample.
//
// Needs: BLOCK_SIZE, EQUAL_DEPTHS, LONGER_LEVEL, EQUAL_DEPTHS_LEVEL, COLOR_FORMAT, FRAGMENT_ORDER, SAMPLES.
#ifndef LONGER_LEVEL
#error "ABuffer/ResolveShort.glsl needs LONGER_LEVEL"
#endif
#ifndef EQUAL_DEPTHS_LEVEL
#error "ABuffer/ResolveShort.glsl needs EQUAL_DEPTHS_LEVEL"
#endif
#define FRAGMENTS_READ_ONLY 1
#include "ABuffer/Blend.glsl"
#include "ABuffer/LoadBlock.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"
#if SAMPLES > 1
#include "Common/SampleColors.glsl"

void blendSamples(ivec2 pixel, Block block)
{
  if (!samplesAgree())
  {
    vec3 color[SAMPLES];
    Channels transmittance[SAMPLES];
    for (int index = 0; index < SAMPLES; ++index)
    {
      color[index] = vec3(0.0);
      transmittance[index] = Channels(1.0);
    }
    for (int i = 0; i < BLOCK_SIZE; ++i)
    {
      Surface surface = unpackColor(block.color[i]);
      for (int index = 0; index < SAMPLES; ++index)
      {
        float covers = float((block.carried[i] >> uint(index)) & 1u);
        blendBehind(color[index], transmittance[index], Surface(covers * surface.color, covers * surface.opacity));
      }
    }
    for (int index = 0; index < SAMPLES; ++index)
    {
      storeSample(pixel, index, color[index], transmittance[index]);
    }
    leaveToLevel(pixel, LEVEL_SAMPLES);
  }
}
#endif

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
  sortBlock(block);
#if !EQUAL_DEPTHS
  if (hasEqualDepths(block))
  {
    leaveToLevel(pixel, EQUAL_DEPTHS_LEVEL);
    return false;
  }
#endif
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    blendBehind(color, transmittance, block.color[i]); // an empty element is transparent
  }
#if SAMPLES > 1
  blendSamples(pixel, block);
#endif
  recordFragments(count);
  dropFragments(pixel);
  return count > 0u;
}

#include "Common/Resolve.glsl"
