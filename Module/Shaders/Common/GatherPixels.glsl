// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// GatherPixels.glsl: gives each fragment to the records of the samples that it covers, one fragment of a pixel at a
// time. The technique's file includes it last.
//
// Needs: updatePixel(record, color, depth).  Gives: gatherFragment.
#include "Common/Coverage.glsl"
#include "Common/Pixels.glsl"

#if RECORD_TARGETS
void gatherFragment(vec4 color, float depth)
{
  updatePixel(pixelRecord(ivec2(gl_FragCoord.xy), 0), color, depth);
  drawRecord();
}
#else
void updateSamples(ivec2 pixel, vec4 color, float depth)
{
  uint coverage = coveredSamples();
  for (int index = 0; index < SAMPLES; ++index)
  {
    if (((coverage >> uint(index)) & 1u) != 0u)
    {
      updatePixel(pixelRecord(pixel, index), color, depth);
    }
  }
}

void gatherFragment(vec4 color, float depth)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (inTile(pixel))
  {
    CRITICAL_SECTION(pixel, updateSamples(pixel, color, depth))
  }
}
#endif
