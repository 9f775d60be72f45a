// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Range.glsl: between which depths the terms tell fragments apart.
//
// - ABSORBANCE_BOUNDS_FRAGMENTS: those of the nearest and of the farthest fragment of the pixel, or the sample.
// - ABSORBANCE_BOUNDS_PROPS: those of the boxes of all translucent props, from rangeNear to rangeFar.
//
// Depths are linear (Common/LinearDepth.glsl): terms are spread evenly over them, and in a perspective half of the
// window's depths lie between the near plane and twice its distance.
//
// Needs: ABSORBANCE_BOUNDS.  Gives: propsRange, and the values of ABSORBANCE_BOUNDS.
#ifndef Range_glsl
#define Range_glsl
#ifndef ABSORBANCE_BOUNDS
#error "Absorbance/Range.glsl needs ABSORBANCE_BOUNDS"
#endif
#include "Common/LinearDepth.glsl"

#define ABSORBANCE_BOUNDS_FRAGMENTS 0
#define ABSORBANCE_BOUNDS_PROPS 1

#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_PROPS
uniform float rangeNear;
uniform float rangeFar;

vec2 propsRange()
{
  return vec2(rangeNear, rangeFar);
}
#endif

#endif
