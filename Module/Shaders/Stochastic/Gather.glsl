// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Stochastic/Gather.glsl: stochastic transparency (Enderton et al. 2010; Salvi et al. 2011, section 4).
//
// Stage 0: blending keeps the least depth of each of the pixel's DEPTH_SAMPLES depth samples, four a buffer; a fragment
// covers a random part of them (Mask.glsl). Stage 1: the part of the samples in which nothing nearer lies is the
// fragment's visibility, vis(z) = (number of samples with depth >= z) / DEPTH_SAMPLES, on average the product of 1 -
// opacity of the fragments in front. Blending adds vis * opacity * colour and vis * opacity, and multiplies 1 -
// opacity: only in the first of several rounds (stochasticAttenuation is 1, else 0), since total transmittance is no
// matter of chance.
//
// Needs: DEPTH_SAMPLES, PATTERNS, TARGET_SAMPLES.  Gives: gatherFragment.
#define DEPTH_BUFFERS ((DEPTH_SAMPLES + 3) / 4)
#define VECTOR_COUNT DEPTH_BUFFERS
#include "Common/EachVector.glsl"
#include "Common/Target.glsl"
#include "Stochastic/Mask.glsl"

#define GATHER_OUTPUTS (DEPTH_BUFFERS > 2 ? DEPTH_BUFFERS : 2)

uniform Target stochasticDepths[DEPTH_BUFFERS];
uniform int gatherStage;
uniform float stochasticAttenuation;

vec4 coverSamples(uint covered, float depth)
{
  bvec4 covers = notEqual((uvec4(covered) >> uvec4(0u, 1u, 2u, 3u)) & 1u, uvec4(0u));
  return mix(vec4(1.0), vec4(depth), covers);
}

float visibility(ivec2 pixel, float depth)
{
  vec4 visible = vec4(0.0);
#define SEE(i) visible += vec4(lessThanEqual(vec4(depth), fetchTarget(stochasticDepths[i], pixel)));
  EACH_VECTOR(SEE)
  return dot(visible, vec4(1.0 / float(DEPTH_SAMPLES)));
}

void gatherFragment(vec4 color, float depth, out vec4 outputs[GATHER_OUTPUTS])
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  outputs[1] = vec4(0.0);
  if (gatherStage == 0)
  {
    uint covered = coveredDepths(pixel, color, depth);
#define COVER(i) outputs[i] = coverSamples(covered >> uint(4 * (i)), depth);
    EACH_VECTOR(COVER)
  }
  else
  {
    float weight = visibility(pixel, depth) * color.a;
    outputs[0] = vec4(weight * color.rgb, stochasticAttenuation * color.a);
    outputs[1] = vec4(weight);
  }
}
