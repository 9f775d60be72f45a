// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sorted/Resolve.glsl: what the under operator has gathered, front to back, over what lies behind:
//     colour += transmittance * opacity * colour of the fragment, then transmittance *= 1 - opacity
//
// Needs: TARGET_SAMPLES, TRANSMITTANCE_CHANNELS.
#include "Common/Channels.glsl"
#include "Common/Target.glsl"

#if TRANSMITTANCE_CHANNELS == 3
uniform Target sortedRed;
uniform Target sortedGreen;
uniform Target sortedBlue;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  vec4 red = fetchTarget(sortedRed, pixel);
  vec4 green = fetchTarget(sortedGreen, pixel);
  vec4 blue = fetchTarget(sortedBlue, pixel);
  color = vec3(red.r, green.r, blue.r);
  transmittance = vec3(red.a, green.a, blue.a);
  return color != vec3(0.0) || transmittance != vec3(1.0);
}
#else
uniform Target sortedLayers;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  vec4 layers = fetchTarget(sortedLayers, pixel);
  color = layers.rgb;
  transmittance = layers.a;
  return transmittance < 1.0;
}
#endif

#include "Common/Composite.glsl"
