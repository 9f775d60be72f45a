// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Range.glsl: between which depths the terms tell fragments apart.
//
// - ABSORBANCE_BOUNDS_FRAGMENTS: those of the nearest and of the farthest fragment of the pixel, or the sample.
// - ABSORBANCE_BOUNDS_PROPS: those of the boxes of all translucent props, from rangeNear to rangeFar.
//
// Terms are spread evenly over
// - DEPTH_WARP_LINEAR: linear depth (Common/LinearDepth.glsl), since in a perspective half of the window's depths lie
//   between the near plane and twice its distance;
// - DEPTH_WARP_LOGARITHMIC: the logarithm of the distance from the viewer. A parallel projection has no viewer, and its
//   near and far "distances" are the same: there it is linear, too.
//
// Needs: ABSORBANCE_BOUNDS, DEPTH_WARP.  Gives: spreadDepth, propsRange, and the values of both.
#ifndef Range_glsl
#define Range_glsl
#ifndef ABSORBANCE_BOUNDS
#error "Absorbance/Range.glsl needs ABSORBANCE_BOUNDS"
#endif
#ifndef DEPTH_WARP
#error "Absorbance/Range.glsl needs DEPTH_WARP"
#endif
#include "Common/LinearDepth.glsl"

#define ABSORBANCE_BOUNDS_FRAGMENTS 0
#define ABSORBANCE_BOUNDS_PROPS 1

#define DEPTH_WARP_LINEAR 0
#define DEPTH_WARP_LOGARITHMIC 1

// Of a linear depth. It stays between 0 and 1, where all fragments lie.
float warpDepth(float z)
{
#if DEPTH_WARP == DEPTH_WARP_LOGARITHMIC
  float farther = frameClipping.y / frameClipping.x;
  return farther > 1.0 ? log(1.0 + z * (farther - 1.0)) / log(farther) : z;
#else
  return z;
#endif
}

// Of a window's depth.
float spreadDepth(float depth)
{
  return warpDepth(linearDepth(depth));
}

#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_PROPS
uniform float rangeNear;
uniform float rangeFar;

vec2 propsRange()
{
  return vec2(warpDepth(rangeNear), warpDepth(rangeFar));
}
#endif

#endif
