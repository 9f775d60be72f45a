// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpacityShadowMap/Slices.glsl: absorbance along a ray on a uniform grid (Kim and Neumann 2001, "Opacity shadow maps").
//
// Each of SLICES slices of equal depth sums the absorbance of the fragments in it. In front of a depth are all slices
// before its own, and of its own the part that the depth has passed: between the planes of the grid absorbance is
// interpolated.
//
// Valid C++, too.
//
// Needs: SLICES (1 to 32).  Gives: TERM_VECTORS, what Absorbance/Linear.glsl gives, basisAt, prepareTerms.
#ifndef Slices_glsl
#define Slices_glsl
#ifndef SLICES
#error "OpacityShadowMap/Slices.glsl needs SLICES"
#endif

#define TERM_VECTORS ((SLICES + 3) / 4)
#include "Absorbance/Linear.glsl"

void basisAt(float depth, OUT(Basis) basis)
{
  float x = depth * float(SLICES);
  float slice = min(floor(x), float(SLICES - 1));
  vec4 first = vec4(0.0f, 1.0f, 2.0f, 3.0f);
#define SET_SLICES(i) \
  basis.density[i] = vec4(equal(first + float(4 * i), vec4(slice))); \
  basis.integral[i] = clamp(vec4(x) - (first + float(4 * i)), 0.0f, 1.0f);
  EACH_VECTOR(SET_SLICES)
  basis.own = x - slice;
}

// Slices are weighed by what the depth has passed of them, and by nothing else.
void prepareTerms(INOUT(Terms) terms)
{
  terms.offset = Channels(0.0f);
}

#endif
