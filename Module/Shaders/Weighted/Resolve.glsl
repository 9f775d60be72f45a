// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Weighted/Resolve.glsl: a pixel's colour from its sums (Gather.glsl).
//
// The sum (survey, "Weighted Sum") can let through less than nothing of what lies behind: blending takes that for
// nothing. The average lets through what its mean opacity does, applied once a fragment: u = (1 - mean)^n. Blended
// weights let through what is right.
//
// Needs: WEIGHTED_METHOD, TARGET_SAMPLES, TRANSMITTANCE_CHANNELS.
#ifndef WEIGHTED_METHOD
#error "Weighted/Resolve.glsl needs WEIGHTED_METHOD"
#endif
#include "Common/MeanColor.glsl"
#include "Common/Target.glsl"
#include "Weighted/Methods.glsl"

uniform Target weightedTarget0; // as Gather.glsl numbers them
uniform Target weightedTarget1;

#if TRANSMITTANCE_CHANNELS == 3
uniform Target weightedTarget2;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  vec4 colors = fetchTarget(weightedTarget0, pixel);
  vec4 opacities = fetchTarget(weightedTarget1, pixel);
#if WEIGHTED_METHOD == WEIGHTED_SUM
  color = colors.rgb;
  transmittance = 1.0 - opacities.rgb;
  return colors.a > 0.0;
#elif WEIGHTED_METHOD == WEIGHTED_AVERAGE
  float count = colors.a;
  transmittance = pow(max(vec3(0.0), 1.0 - opacities.rgb / max(count, 1.0)), vec3(count));
  color = meanColor(colors.rgb, opacities.rgb, transmittance);
  return count > 0.0;
#else
  vec4 weights = fetchTarget(weightedTarget2, pixel);
  transmittance = vec3(colors.a, opacities.a, weights.a);
  color = meanColor(colors.rgb * opacities.rgb / max(weights.rgb, 1e-30), opacities.rgb, transmittance);
  return weights.r > 0.0;
#endif
}
#else
bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  vec4 sums = fetchTarget(weightedTarget0, pixel);
#if WEIGHTED_METHOD == WEIGHTED_SUM
  color = sums.rgb;
  transmittance = 1.0 - sums.a;
#elif WEIGHTED_METHOD == WEIGHTED_AVERAGE
  float count = fetchTarget(weightedTarget1, pixel).r;
  transmittance = pow(max(0.0, 1.0 - sums.a / max(count, 1.0)), count);
  color = meanColor(sums.rgb, sums.a, transmittance);
#else
  transmittance = fetchTarget(weightedTarget1, pixel).r;
  color = meanColor(sums.rgb, sums.a, transmittance);
#endif
  return sums.a > 0.0;
}
#endif

#include "Common/Composite.glsl"
