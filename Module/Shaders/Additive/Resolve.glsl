// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Additive/Resolve.glsl: the sum of a pixel's fragments, behind which everything is seen:
//     colour = sum of opacity * colour + what lies behind
//
// Needs: TARGET_SAMPLES, TRANSMITTANCE_CHANNELS.
#include "Common/Channels.glsl"
#include "Common/Target.glsl"

uniform Target additiveSum;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  vec4 sum = fetchTarget(additiveSum, pixel);
  color = sum.rgb;
  return sum.a > 0.0;
}

#include "Common/Composite.glsl"
