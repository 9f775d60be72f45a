// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Stochastic/Mask.glsl: which of a pixel's depth samples a fragment covers (Enderton et al. 2010, section 3).
//
// Of DEPTH_SAMPLES samples S it covers floor(opacity * S + x), for a random x from 0 to 1: opacity * S on average.
// Which ones is a stipple pattern from a table, a row for each number of samples covered. A pattern is turned by a
// random number of places, so that every sample is covered equally often, whatever the table holds: that makes the
// method unbiased. The patterns make neighbouring samples independent, which keeps its noise low.
//
// Random numbers depend on the seed, on the pixel (and sample of it), and on what tells its fragments apart: depth, and
// colour for fragments of equal depth. They do not depend on the order of drawing. gl_PrimitiveID would: it starts anew
// with each actor.
//
// Needs: DEPTH_SAMPLES (up to 32), PATTERNS (in a row), TARGET_SAMPLES, SHADES_SAMPLES.  Gives: coveredDepths.
#ifndef Mask_glsl
#define Mask_glsl
#include "Common/Target.glsl"
#ifndef DEPTH_SAMPLES
#error "Stochastic/Mask.glsl needs DEPTH_SAMPLES"
#endif
#ifndef PATTERNS
#error "Stochastic/Mask.glsl needs PATTERNS"
#endif

uniform usampler2D stochasticPatterns; // a row for each number of samples that are covered
uniform int stochasticSeed;

// Of three numbers two that look random: the rounds of pcg3d (Jarzynski and Olano, "Hash functions for GPU rendering",
// JCGT 2020).
uvec2 randomWords(uvec3 v)
{
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  return v.xy;
}

// One bit a sample.
uint coveredDepths(ivec2 pixel, vec4 color, float depth)
{
  uvec4 words = floatBitsToUint(color) * uvec4(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du, 0x27d4eb2fu);
  uint content = words.x + words.y + words.z + words.w;
  uint place = uint(pixel.x) | (uint(pixel.y) << 16u);
#if TARGET_SAMPLES > 1
  content += uint(TARGET_SAMPLE) * 0x165667b1u;
#endif
  uvec2 random = randomWords(uvec3(place, floatBitsToUint(depth), content + uint(stochasticSeed)));

  float fraction = float(random.x >> 8u) * (1.0 / 16777216.0);
  uint count = min(uint(color.a * float(DEPTH_SAMPLES) + fraction), uint(DEPTH_SAMPLES));
  uint pattern = texelFetch(stochasticPatterns, ivec2(int(random.y) & (PATTERNS - 1), int(count)), 0).r;
  uint places = ((random.y >> 16u) * uint(DEPTH_SAMPLES)) >> 16u; // 0 to DEPTH_SAMPLES - 1
  // A bit pushed out at the top comes in at the bottom. Two steps of at most 31 places: a shift by 32 is undefined.
  return (pattern << places) | ((pattern >> 1u) >> (uint(DEPTH_SAMPLES - 1) - places));
}

#endif
