// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// MergeSamples.glsl: one node for the fragments of neighbouring triangles that share a pixel of a multi-sampled window.
//
// Inside a surface, each triangle that touches a pixel has a fragment of its own there, for some of the samples: where
// triangles are as small as pixels that is nearly three times the fragments of one sample a pixel, and no pixel in
// which all samples agree. A fragment joins the one that was stored before it in its pixel if they cover different
// samples, have the same opacity and much the same colour, and are as near each other as the depth of one fragment
// reaches within a pixel. The colour becomes the mean over the samples.
//
// Each sample still has one fragment of that opacity at that place. The mean over the pixel's samples stays what it
// was, except where another edge goes through the pixel: there it is off by at most a quarter of the tolerance, 1/128.
//
// Reading what other fragments of the pixel have stored takes a driver that shades them one after the other: this is
// for storages in order.
//
// Needs: SAMPLES, COLOR_FORMAT, TRANSMITTANCE_CHANNELS.  Gives: MERGES_SAMPLES, and if that is 1:
// mayMerge, mergeFragments.
#ifndef MergeSamples_glsl
#define MergeSamples_glsl
#include "Common/Fragment.glsl"

#if SAMPLES > 1
#define MERGES_SAMPLES 1

// A channel is compared and averaged as it is packed. The bits of half floats are in the order of their values and
// nearly linear in between. MERGE_TOLERANCE is in units of the last bit.
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
#define OPACITY_BITS uvec3(0xff000000u, 0xffffffffu, 0xffffffffu)
#define CHANNELS_OF(words) ivec3((words).x & 0xffu, ((words).x >> 8u) & 0xffu, ((words).x >> 16u) & 0xffu)
#define MERGE_TOLERANCE(larger) ivec3(8)
#else
#define OPACITY_BITS uvec3(0u, 0xffff0000u, 0xffffffffu)
#define CHANNELS_OF(words) ivec3((words).x & 0xffffu, (words).x >> 16u, (words).y & 0xffffu)
// 1/32 has 64 of those units at 0.5, where the exponent is 14, and twice as many for each exponent below, but not more
// than an exponent. The sign is not the number's (Absorption/Medium.glsl).
#define MERGE_TOLERANCE(larger) (ivec3(1024) >> clamp(((larger & 0x7fff) >> 10) - 10, ivec3(0), ivec3(10)))
#endif

// depthExtent is how far the fragment's depth reaches within a pixel.
bool mayMerge(Fragment stored, Fragment fragment, float depthExtent)
{
  ivec3 a = CHANNELS_OF(stored.color);
  ivec3 b = CHANNELS_OF(fragment.color);
  return (stored.coverage & fragment.coverage) == 0u && abs(stored.depth - fragment.depth) <= depthExtent &&
    (stored.color & PackedColor(OPACITY_BITS)) == (fragment.color & PackedColor(OPACITY_BITS)) &&
    all(lessThanEqual(abs(a - b), MERGE_TOLERANCE(max(a, b))));
}

// The depth is that of the stored one.
Fragment mergeFragments(Fragment stored, Fragment fragment)
{
  uint coverage = stored.coverage | fragment.coverage;
  float share = float(bitCount(fragment.coverage)) / float(bitCount(coverage));
  ivec3 before = CHANNELS_OF(stored.color);
  uvec3 mean = uvec3(before + ivec3(round(share * vec3(CHANNELS_OF(fragment.color) - before))));
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  uvec3 color = uvec3(mean.r | mean.g << 8u | mean.b << 16u, 0u, 0u);
#else
  uvec3 color = uvec3(mean.r | mean.g << 16u, mean.b, 0u);
#endif
  return Fragment(stored.depth, PackedColor(color) | (stored.color & PackedColor(OPACITY_BITS)), coverage);
}

#else
#define MERGES_SAMPLES 0
#endif

#endif
