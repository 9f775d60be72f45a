// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Terms.glsl: visibility from sums over the fragments of a pixel.
//
// A fragment's absorbance is -ln(1 - opacity): those of the fragments in front add up, and vis(z) = exp(-sum) (Salvi
// 2011, Eq. 4). Which of them are in front is told from a fixed number of sums, the terms: a fragment of absorbance a
// at depth z adds a * density(z) to them. When they are complete, integrateTerms makes them weights and an offset, and
// the absorbance in front of z is the offset and the scalar product of the weights with integral(z). A technique gives
// these vectors (Fourier/Series.glsl, OpacityShadowMap/Slices.glsl). Since all of this is linear, what a fragment has
// added itself is taken out again before it asks: nothing hides itself (H(0) = 0 in Eq. 5).
//
// An opaque fragment would absorb without end. No absorbance is more than ln(1024): what is behind shows through by
// less than a quarter of 1/255.
//
// With three channels (Common/Channels.glsl) there are as many absorbances, sums and visibilities, of one basis.
//
// Valid C++, too.
//
// Needs: TERM_VECTORS (1 to 8), of four terms each; TRANSMITTANCE_CHANNELS.  Gives: Basis, Terms, TermVector,
// integrate, weighted, absorbanceOf, relativeDepth, clearTerms, addToTerms, visibilityOf.
#ifndef Terms_glsl
#define Terms_glsl
#define VECTOR_COUNT TERM_VECTORS
#include "Common/EachVector.glsl"
#include "Common/Channels.glsl"
#include "Common/Language.glsl"

#define LEAST_TRANSMITTANCE (1.0f / 1024.0f)

// Of a depth. What is not in use of the last vector is 0. own is how much of what is added at this depth seems to lie
// in front of it.
struct Basis
{
  vec4 density[TERM_VECTORS];
  vec4 integral[TERM_VECTORS];
  float own;
};

// Four sums of each channel, what a fragment adds to them, the scalar product of each channel's with four of a basis,
// and each times a weight of its own.
#if TRANSMITTANCE_CHANNELS == 3
#define TermVector mat3x4

TermVector spread(vec4 density, Channels absorbance)
{
  return outerProduct(density, absorbance);
}

Channels integrate(TermVector sums, vec4 integral)
{
  return integral * sums;
}

TermVector weighted(TermVector sums, vec4 weights)
{
  return TermVector(sums[0] * weights, sums[1] * weights, sums[2] * weights);
}
#else
#define TermVector vec4

TermVector spread(vec4 density, Channels absorbance)
{
  return absorbance * density;
}

Channels integrate(TermVector sums, vec4 integral)
{
  return dot(sums, integral);
}

TermVector weighted(TermVector sums, vec4 weights)
{
  return sums * weights;
}
#endif

struct Terms
{
  TermVector sums[TERM_VECTORS];
  Channels offset; // of integrated terms
};

Channels absorbanceOf(Channels alpha)
{
  return -log(max(1.0f - alpha, LEAST_TRANSMITTANCE));
}

// 0 at the near end of a range of depths, 1 at its far end. Where they are the same everything is in the middle.
float relativeDepth(float depth, vec2 range)
{
  float extent = range.y - range.x;
  // One division for all fragments of a pixel.
  return extent > 0.0f ? clamp((depth - range.x) * (1.0f / extent), 0.0f, 1.0f) : 0.5f;
}

void clearTerms(OUT(Terms) terms)
{
#define CLEAR_TERMS(i) terms.sums[i] = TermVector(0.0f);
  EACH_VECTOR(CLEAR_TERMS)
}

void addToTerms(INOUT(Terms) terms, INOUT(Basis) basis, Channels absorbance)
{
#define ADD_TO_TERMS(i) terms.sums[i] += spread(basis.density[i], absorbance);
  EACH_VECTOR(ADD_TO_TERMS)
}

// vis at the depth of a fragment that has added this absorbance, from integrated terms.
Channels visibilityOf(INOUT(Terms) terms, INOUT(Basis) basis, Channels absorbance)
{
  Channels inFront = terms.offset - basis.own * absorbance;
#define ADD_IN_FRONT(i) inFront += integrate(terms.sums[i], basis.integral[i]);
  EACH_VECTOR(ADD_IN_FRONT)
  return exp(-max(inFront, 0.0f)); // a truncated series may fall below 0
}

#endif
