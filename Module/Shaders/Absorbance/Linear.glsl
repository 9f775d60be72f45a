// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Linear.glsl: reconstruction by a scalar product.
//
// Once all fragments have added to the terms, the technique's prepareTerms makes them weights and an offset. The
// absorbance in front of z is the offset and the scalar product of the weights with integral(z).
//
// Valid C++, too.
//
// Needs: what Absorbance/Terms.glsl gives.  Gives: Basis, absorbanceInFront.
#ifndef Linear_glsl
#define Linear_glsl
#include "Absorbance/Terms.glsl"

// Of a depth. What is not in use of the last vector is 0. own is how much of what is added at this depth seems to lie
// in front of it.
struct Basis
{
  vec4 density[TERM_VECTORS];
  vec4 integral[TERM_VECTORS];
  float own;
};

// In front of a fragment that has added this absorbance.
Channels absorbanceInFront(INOUT(Terms) terms, INOUT(Basis) basis, Channels absorbance)
{
  Channels inFront = terms.offset - basis.own * absorbance;
#define ADD_IN_FRONT(i) inFront += integrate(terms.sums[i], basis.integral[i]);
  EACH_VECTOR(ADD_IN_FRONT)
  return inFront;
}

#endif
