// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// AlphaCorrection.glsl: sums over a pixel's fragments whose weights add up to what is hidden.
//
// With exact visibilities, the weights vis(z) * opacity of a pixel's fragments add up to 1 - total transmittance.
// ALPHA_CORRECTION 1 scales the colour so that those of approximate ones do, too (the alpha correction of Enderton et
// al. 2010). Where nothing is hidden nothing is scaled.
//
// With three channels a fragment may add light without hiding anything, and then has no part in the weights by which
// light is scaled: of a few surfaces close behind it, each of which seems to hide the others, they may be so small that
// it would dazzle. So no channel gets more light than all fragments give together.
//
// Valid C++, too.
//
// Needs: ALPHA_CORRECTION, TRANSMITTANCE_CHANNELS.  Gives: WeightedSums, clearWeights, addWeighted, correctedColor.
#ifndef AlphaCorrection_glsl
#define AlphaCorrection_glsl
#ifndef ALPHA_CORRECTION
#error "AlphaCorrection.glsl needs ALPHA_CORRECTION"
#endif
#include "Common/Channels.glsl"
#include "Common/Language.glsl"

struct WeightedSums
{
  vec3 color;       // vis(z) * opacity * colour
  Channels weights; // vis(z) * opacity
#if TRANSMITTANCE_CHANNELS == 3
  vec3 light; // opacity * colour
#endif
};

void clearWeights(OUT(WeightedSums) sums)
{
  sums.color = vec3(0.0f);
  sums.weights = Channels(0.0f);
#if TRANSMITTANCE_CHANNELS == 3
  sums.light = vec3(0.0f);
#endif
}

// color is multiplied by the opacity.
void addWeighted(INOUT(WeightedSums) sums, vec3 color, Channels opacity, Channels visibility)
{
  sums.color += visibility * color;
  sums.weights += visibility * opacity;
#if TRANSMITTANCE_CHANNELS == 3
  sums.light += color;
#endif
}

float correctionOf(float weights, float transmittance)
{
  return weights > 0.0f ? (1.0f - transmittance) / weights : 1.0f;
}

#if TRANSMITTANCE_CHANNELS == 3
vec3 correctionOf(vec3 weights, vec3 transmittance)
{
  return vec3(correctionOf(weights.r, transmittance.r),
    correctionOf(weights.g, transmittance.g), correctionOf(weights.b, transmittance.b));
}
#endif

vec3 correctedColor(WeightedSums sums, Channels transmittance)
{
  vec3 color = ALPHA_CORRECTION == 1 ? sums.color * correctionOf(sums.weights, transmittance) : sums.color;
#if TRANSMITTANCE_CHANNELS == 3
  color = min(color, sums.light);
#endif
  return color;
}

#endif
