// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CompositeColors.glsl: the weighted colours and the total transmittance that blending has added up and multiplied,
// over the opaque picture.
//
// Needs: ALPHA_CORRECTION, TARGET_SAMPLES, TRANSMITTANCE_CHANNELS.
#include "Common/AlphaCorrection.glsl"
#include "Common/Target.glsl"

uniform Target gatheredColors; // rgb: colour; a: total transmittance, of three channels that of red
#if TRANSMITTANCE_CHANNELS == 3
uniform Target gatheredWeights; // rgb: the weights; a: the total transmittance of green
uniform Target gatheredLight;   // rgb: light, hidden or not; a: that of blue
#elif ALPHA_CORRECTION
uniform Target gatheredWeights; // r: the weights
#endif

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  vec4 gathered = fetchTarget(gatheredColors, pixel);
  WeightedSums sums;
  clearWeights(sums);
  sums.color = gathered.rgb;
#if TRANSMITTANCE_CHANNELS == 3
  vec4 weights = fetchTarget(gatheredWeights, pixel);
  vec4 light = fetchTarget(gatheredLight, pixel);
  sums.weights = weights.rgb;
  sums.light = light.rgb;
  transmittance = vec3(gathered.a, weights.a, light.a);
#else
  transmittance = gathered.a;
#if ALPHA_CORRECTION
  sums.weights = fetchTarget(gatheredWeights, pixel).r;
#endif
#endif
  color = correctedColor(sums, transmittance);
  return color != vec3(0.0) || transmittance != Channels(1.0);
}

#include "Common/Composite.glsl"
