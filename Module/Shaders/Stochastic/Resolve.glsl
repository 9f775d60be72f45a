// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Stochastic/Resolve.glsl: a pixel's colour from its sums (Gather.glsl) over some rounds.
//
// With ALPHA_CORRECTION 1 (Enderton et al. 2010) the weights vis * opacity are scaled to add up to 1 - total
// transmittance, which is what they do on average: colour = sum(vis * opacity * colour) * (1 - transmittance) / sum(vis
// * opacity) Noise is then left only where colours differ. With ALPHA_CORRECTION 0 the sums are taken as they are, and
// have the right expectation.
//
// Needs: ALPHA_CORRECTION, TARGET_SAMPLES.
#ifndef ALPHA_CORRECTION
#error "Stochastic/Resolve.glsl needs ALPHA_CORRECTION"
#endif
#include "Common/Target.glsl"

uniform Target stochasticColors;
#if ALPHA_CORRECTION
uniform Target stochasticWeights;
#else
uniform float stochasticShare; // of a round in the picture
#endif

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 sums = fetchTarget(stochasticColors, pixel);
  transmittance = sums.a;
#if ALPHA_CORRECTION
  float weights = fetchTarget(stochasticWeights, pixel).r;
  color = sums.rgb * (1.0 - transmittance) / max(weights, 1e-30);
#else
  color = sums.rgb * stochasticShare;
#endif
  return transmittance < 1.0;
}

#include "Common/Composite.glsl"
