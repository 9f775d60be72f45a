// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/Resolve.glsl: the colour of a pixel by its compressed visibility function (Salvi 2011, section 4.1).
//
// Two walks over the pixel's list: build vis(z), then sum the fragments weighted by it (Eq. 2). The total transmittance
// is that of all fragments: no rule of removal changes it. Where nodes were removed the sum is corrected (Weigh.glsl,
// Common/AlphaCorrection.glsl); elsewhere it is exact, but for rounding, and stays as it is.
//
// Fragments of equal depth are composited one behind the other, which takes more steps for every fragment. EQUAL_DEPTHS
// 0 does without and leaves pixels that have such fragments to EQUAL_DEPTHS_LEVEL, which is this shader with
// EQUAL_DEPTHS 1. Pixels whose loops the driver ends are left to UNFINISHED_LEVEL, which sorts.
//
// TOLERANCE 1: pixels with a larger estimate of their error than errorTolerance are left to FINER_LEVEL.
//
// Where samples of a pixel differ, both are decided for each of them: two triangles that meet in the pixel are often of
// one depth there, but seldom cover the same sample.
//
// SHOW other than SHOW_PICTURE: the second walk gives way to Adaptive/Show.glsl.
//
// Needs: NODE_COUNT, NODE_REMOVAL, EQUAL_DEPTHS, EQUAL_DEPTHS_LEVEL, UNFINISHED_LEVEL, TOLERANCE, FINER_LEVEL, SHOW,
// ALPHA_CORRECTION, COLOR_FORMAT, TRANSMITTANCE_CHANNELS.
#ifndef EQUAL_DEPTHS
#error "Adaptive/Resolve.glsl needs EQUAL_DEPTHS"
#endif
#ifndef TOLERANCE
#error "Adaptive/Resolve.glsl needs TOLERANCE"
#endif
#define FRAGMENTS_READ_ONLY 1
#include "Adaptive/Show.glsl"
#define ESTIMATE_ERROR (TOLERANCE || SHOW == SHOW_ERROR)
#include "Adaptive/Weigh.glsl"
#include "Common/AlphaCorrection.glsl"
#include "Common/Fragment.glsl"
#include "Common/FinishPixel.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

#define BEHIND_ALL_NODES 3.0

#if TOLERANCE
uniform float errorTolerance;
#endif

// A fragment that hides nothing may add light.
bool covers(Fragment fragment)
{
  return fragment.color != PackedColor(0u);
}

// Fragments that don't cover the sample take no node: nothing moves for what lies behind all of them.
float nodeDepth(Fragment fragment)
{
  return covers(fragment) ? fragment.depth : BEHIND_ALL_NODES;
}

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  Visibility visibility;
  clearVisibility(visibility);
  int count = 0;
  Fragment fragment;
  uint cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    Channels opacity = unpackColor(fragment.color).opacity;
    transmittance *= 1.0 - opacity;
    insertFragment(visibility, nodeDepth(fragment), opacity, count);
    count += covers(fragment) ? 1 : 0;
  }
#if !EQUAL_DEPTHS
  if (coincide(visibility) && samplesAgree())
  {
    leaveToLevel(pixel, EQUAL_DEPTHS_LEVEL);
    return false;
  }
#endif
#if ESTIMATE_ERROR
  float error = estimateError(visibility.lost, visibility.nearest, visibility.farthest);
#else
  float error = 0.0;
#endif
#if TOLERANCE
  if (error > errorTolerance && samplesAgree())
  {
    leaveToLevel(pixel, FINER_LEVEL);
    return false;
  }
#endif
  uint unread = cursor;
#if SHOW == SHOW_PICTURE
  WeightedSums sums;
  clearWeights(sums);
  cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    float depth = nodeDepth(fragment);
    Surface surface = unpackColor(fragment.color);
    addWeighted(sums, surface.color, surface.opacity,
      visibilityAt(visibility, depth, surface.opacity, count > NODE_COUNT));
#if EQUAL_DEPTHS
    passNode(visibility, depth);
#endif
  }
  color = count > NODE_COUNT ? correctedColor(sums, transmittance) : sums.color;
#else
  showPixel(error, min(count, NODE_COUNT), color, transmittance);
#endif
  if (unread != 0u || cursor != 0u)
  {
    leaveToLevel(pixel, UNFINISHED_LEVEL);
    return false;
  }
  finishPixel(pixel, uint(count));
  return count > 0;
}

#include "Common/Resolve.glsl"
