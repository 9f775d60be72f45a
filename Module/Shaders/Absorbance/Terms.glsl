// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Terms.glsl: sums over the fragments of a pixel, from which visibility is reconstructed.
//
// A fragment's absorbance is -ln(1 - opacity): those of the fragments in front add up, and vis(z) = exp(-sum) (Salvi
// 2011, Eq. 4). Which of them are in front is told from a fixed number of sums, the terms: a fragment of absorbance a
// at depth z adds a * density(z) to them, a vector that a technique gives. When they are complete, the technique
// reconstructs from them what lies in front of a depth: linearly (Absorbance/Linear.glsl), or in a way of its own, as
// from moments. Where that is linear, what a fragment has added itself is taken out again before it asks: nothing hides
// itself (H(0) = 0 in Eq. 5).
//
// An opaque fragment would absorb without end. No absorbance is more than ln(1024): what is behind shows through by
// less than a quarter of 1/255.
//
// With three channels (Common/Channels.glsl) there are as many absorbances, sums and visibilities, of one basis.
//
// TERM_PRECISION: the sums are held in floats of 32 bits, or of 16, or in words (Absorbance/StoredTerms.glsl). Each
// addition rounds them.
//
// Valid C++, too.
//
// Needs: TERM_VECTORS (1 to 8, or 16), of four terms each; TERM_PRECISION; TRANSMITTANCE_CHANNELS.  Gives: Terms,
// TermVector, spread, integrate, weighted, absorbanceOf, relativeDepth, clearTerms, and TERM_ROUNDING, a bound of what
// rounding makes of a sum, as a share of it, if it is no less than TERM_LEAST.
#ifndef Terms_glsl
#define Terms_glsl
#define VECTOR_COUNT TERM_VECTORS
#include "Common/EachVector.glsl"
#include "Common/Channels.glsl"
#include "Common/Language.glsl"

#ifndef TERM_PRECISION
#error "Terms.glsl needs TERM_PRECISION"
#endif
#define TERM_PRECISION_SINGLE 0
#define TERM_PRECISION_HALF 1
#define TERM_PRECISION_SHARED_EXPONENT 2
#if TERM_PRECISION == TERM_PRECISION_HALF
#define TERM_ROUNDING 9.765625e-4f // 2^-10
#define TERM_LEAST 6.1035156e-5f
#else
#define TERM_ROUNDING 2.384186e-7f // 2^-22
#define TERM_LEAST 0.0f
#endif

#define LEAST_TRANSMITTANCE (1.0f / 1024.0f)

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
  Channels offset; // of reconstructions that have one
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

#endif
