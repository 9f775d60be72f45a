// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Weighted/Gather.glsl: sums over the fragments of a pixel in which their order does not matter.
//
// - WEIGHTED_SUM (Meshkin 2007): sum of opacity * colour, and of opacity.
// - WEIGHTED_AVERAGE (Bavoil and Myers 2008): the same, and the number of fragments.
// - WEIGHTED_BLENDED (McGuire and Bavoil 2013, Eq. 6): sum of weight * opacity * colour, of weight * opacity, and the
//   product of 1 - opacity, for which the blending of target 1 multiplies.
//
// With three channels (Common/Channels.glsl) the opacities are those of red, green and blue, and the targets hold
// - of sum and average: opacity * colour and the number of fragments; opacities;
// - of blended: weight * opacity * colour; opacities; weight * opacities; and each in its alpha, one channel of the
//   product, for which blending multiplies there. A fragment that hides nothing of a channel adds its light all the
//   same. Where all do that, their weights have no opacity to be weighed against: LEAST_HIDDEN of what a fragment
//   covers is counted, but not multiplied.
//
// The weights are those of the 2013 paper, made for distances of 0.1 to 500: depths are mapped linearly from the
// clipping range to weightNear .. weightFar. Eq. 10 takes the window's depth as it is.
//
// Needs: WEIGHTED_METHOD, WEIGHTED_TARGETS (how many there are), TRANSMITTANCE_CHANNELS, and for WEIGHTED_BLENDED
// WEIGHT_FUNCTION.
// Gives: gatherFragment.
#ifndef WEIGHTED_METHOD
#error "Weighted/Gather.glsl needs WEIGHTED_METHOD"
#endif
#ifndef WEIGHTED_TARGETS
#error "Weighted/Gather.glsl needs WEIGHTED_TARGETS"
#endif
#include "Common/LinearDepth.glsl"
#include "Common/Opacity.glsl"
#include "Weighted/Methods.glsl"

#if WEIGHTED_METHOD == WEIGHTED_BLENDED
#ifndef WEIGHT_FUNCTION
#error "Weighted/Gather.glsl needs WEIGHT_FUNCTION"
#endif

uniform float weightNear;
uniform float weightFar;

float cube(float x)
{
  return x * x * x;
}

float square(float x)
{
  return x * x;
}

float weight(float depth)
{
#if WEIGHT_FUNCTION == 10
  return max(1e-2, 3e3 * cube(1.0 - depth));
#else
  float z = mix(weightNear, weightFar, linearDepth(depth));
#if WEIGHT_FUNCTION == 7
  float w = 10.0 / (1e-5 + square(z / 5.0) + square(cube(z / 200.0)));
#elif WEIGHT_FUNCTION == 8
  float w = 10.0 / (1e-5 + cube(z / 10.0) + square(cube(z / 200.0)));
#else
  float w = 0.03 / (1e-5 + square(square(z / 200.0)));
#endif
  return clamp(w, 1e-2, 3e3);
#endif
}
#endif

#define LEAST_HIDDEN 1e-12

void gatherFragment(vec4 color, float depth, out vec4 outputs[WEIGHTED_TARGETS])
{
#if TRANSMITTANCE_CHANNELS == 3
  vec3 opacity = opacityOf(color);
#if WEIGHTED_METHOD == WEIGHTED_BLENDED
  float w = weight(depth);
  vec3 counted = max(opacity, LEAST_HIDDEN * color.a);
  outputs[0] = vec4(w * color.a * color.rgb, opacity.r);
  outputs[1] = vec4(counted, opacity.g);
  outputs[2] = vec4(w * counted, opacity.b);
#else
  outputs[0] = vec4(color.a * color.rgb, 1.0);
  outputs[1] = vec4(opacity, 0.0);
#endif
#elif WEIGHTED_METHOD == WEIGHTED_BLENDED
  outputs[0] = weight(depth) * color.a * vec4(color.rgb, 1.0);
  outputs[1] = vec4(color.a);
#else
  outputs[0] = color.a * vec4(color.rgb, 1.0);
#if WEIGHTED_METHOD == WEIGHTED_AVERAGE
  outputs[1] = vec4(1.0);
#endif
#endif
}
