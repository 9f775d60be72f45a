// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Visibility.glsl: what a technique of sums is asked for, whatever it reconstructs visibility by.
//
// Valid C++, too.
//
// Needs: Basis, of which density is what a fragment adds to the terms; absorbanceInFront; what Absorbance/Terms.glsl
// gives.  Gives: addToTerms, visibilityOf.
#ifndef Visibility_glsl
#define Visibility_glsl
#include "Absorbance/Terms.glsl"

void addToTerms(INOUT(Terms) terms, INOUT(Basis) basis, Channels absorbance)
{
#define ADD_TO_TERMS(i) terms.sums[i] += spread(basis.density[i], absorbance);
  EACH_VECTOR(ADD_TO_TERMS)
}

// vis at the depth of a fragment that has added this absorbance, from prepared terms.
Channels visibilityOf(INOUT(Terms) terms, INOUT(Basis) basis, Channels absorbance)
{
  return exp(-max(absorbanceInFront(terms, basis, absorbance), 0.0f)); // a reconstruction may fall below 0
}

#endif
