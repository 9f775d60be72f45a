// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Resolve.glsl: the main function of every resolve; the technique's file includes it last.
//
// A shader can't write different colours to the samples of a pixel: where they differ, they wait in sampleColors for
// Common/CompositeSamples.glsl.
//
// Needs: resolvePixel(pixel, color, transmittance), false where a pixel holds nothing; TRANSMITTANCE_CHANNELS.  Gives:
// main.
#include "Common/Output.glsl"
#include "Common/SampleColors.glsl"
#include "Common/Samples.glsl"
#include "Common/Statistics.glsl"

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = vec3(0.0);
  Channels transmittance = Channels(1.0);
  bool drawn = inTile(pixel) && resolvePixel(pixel, color, transmittance);
#if SAMPLES > 1
  if (drawn && resolveSample >= 0)
  {
    storeSample(pixel, resolveSample, color, transmittance);
    leaveToLevel(pixel, LEVEL_SAMPLES);
    drawn = false;
  }
#endif
  if (!drawn || !samplesAgree())
  {
    discard;
  }
  writeOutput(color, transmittance);
}
