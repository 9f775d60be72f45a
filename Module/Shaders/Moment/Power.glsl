// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/Power.glsl: absorbance along a ray by its power moments (Muenstermann, Krumpen, Klein, Peters 2018,
// "Moment-based order-independent transparency"; Sharpe 2018, "Moment transparency").
//
// Fragments of absorbance a[i] at depths z[i] between -1 and 1 are masses. The terms are their moments,
//   b[k] = sum a[i] z[i]^k,   k = 0 to MOMENTS.
// One of all distributions of mass that have these moments has a mass at a given depth z and at most MOMENTS / 2
// others. No other has less in front of z, nor more than this one has there with the mass at z (Chebyshev, Markov,
// Stieltjes). Of the mass at z the share OVERESTIMATION is taken to be in front.
//
// How this is computed differs from the papers, so that 32 bits do for lone and coincident fragments, too:
// - A fragment's own moments are taken out first. One that is alone has nothing in front of it.
// - The moments are mixed with some of a distribution that has mass all over (BIAS): the matrix of the moments is then
//   regular, and no pivot of its factorization is less than the same share of that distribution's own. What is less was
//   lost by rounding, and is set to that.
// - P[k], the polynomials of degree k that are orthogonal to each other in the distribution, follow from the
//   factorization, with their squares' means D[k]. K(x, y) = sum P[k](x) P[k](y) / D[k] is the kernel: 1 / K(z, z) is
//   the mass at z, and the zeros of K(z, x) are where the others are. They are found as t = 1 / (x - z), for which the
//   leading coefficient is K(z, z), never small; a mass far away has t = 0.
// - The mass at each is 1 / K(x, x), too, never negative. What is missing in their sum, 1, is given to those whose
//   zeros may be farthest off: two near each other, which are on one side of z.
//
// Valid C++, too.
//
// Needs: MOMENTS (4, 6 or 8), MOMENT_BIAS, OVERESTIMATION.  Gives: TERM_VECTORS, Basis, basisAt, prepareTerms,
// absorbanceInFront.
#ifndef Power_glsl
#define Power_glsl
#ifndef MOMENTS
#error "Moment/Power.glsl needs MOMENTS"
#endif

#define TERM_VECTORS (MOMENTS / 4 + 1)
#include "Absorbance/Terms.glsl"

#define MOMENT_ZEROS (MOMENTS / 2)
#include "Moment/Zeros.glsl"

struct Basis
{
  vec4 density[TERM_VECTORS];
  float depth; // -1 to 1
};

void basisAt(float depth, OUT(Basis) basis)
{
  float z = 2.0f * depth - 1.0f;
  float square = z * z;
  vec4 powers = vec4(1.0f, z, square, square * z);
  basis.depth = z;
  basis.density[0] = powers;
#if MOMENTS == 4
  basis.density[1] = vec4(square * square, 0.0f, 0.0f, 0.0f);
#else
  basis.density[1] = square * square * powers;
#endif
#if MOMENTS == 8
  basis.density[2] = vec4(square * square * square * square, 0.0f, 0.0f, 0.0f);
#endif
}

void prepareTerms(INOUT(Terms) terms)
{
  terms.offset = Channels(0.0f);
}

// Moments of a distribution that has mass all over, and the squares' means of its own polynomials (the paper's
// supplement has the moments).
#if MOMENTS == 4
#define SPREAD_LOW vec4(1.0f, 0.0f, 0.375f, 0.0f)
#define SPREAD_HIGH vec4(0.375f, 0.0f, 0.0f, 0.0f)
#define SPREAD_LAST 0.0f
#define SPREAD_PIVOTS vec4(0.375f, 0.234375f, 0.0f, 0.0f)
#elif MOMENTS == 6
#define SPREAD_LOW vec4(1.0f, 0.0f, 0.48f, 0.0f)
#define SPREAD_HIGH vec4(0.451f, 0.0f, 0.45f, 0.0f)
#define SPREAD_LAST 0.0f
#define SPREAD_PIVOTS vec4(0.48f, 0.2206f, 0.026247917f, 0.0f)
#else
#define SPREAD_LOW vec4(1.0f, 0.0f, 0.75f, 0.0f)
#define SPREAD_HIGH vec4(0.67666667f, 0.0f, 0.63f, 0.0f)
#define SPREAD_LAST 0.6003003f
#define SPREAD_PIVOTS vec4(0.75f, 0.11416667f, 0.0194963f, 0.0109836f)
#endif

// Of P[k](x) = x^k - sum factors[k][j] P[j](x), and 1 / D[k], k from 1 on.
struct Polynomials
{
  float first0;
  vec2 second;
  vec3 third;
  vec4 fourth;
  vec4 reciprocals;
};

void orthogonalize(vec4 low, vec4 high, float last, float bias, OUT(Polynomials) p)
{
  vec4 least = bias * SPREAD_PIVOTS;
  vec4 pivots = vec4(1.0f);
  p.reciprocals = vec4(0.0f); // of polynomials that there are not
  p.first0 = low.y;
  p.second.x = low.z;
  pivots.x = max(low.z - low.y * low.y, least.x);
  p.reciprocals.x = 1.0f / pivots.x;
  p.second.y = (low.w - low.y * low.z) * p.reciprocals.x;
  pivots.y = max(high.x - low.z * low.z - p.second.y * p.second.y * pivots.x, least.y);
  p.reciprocals.y = 1.0f / pivots.y;
#if MOMENTS >= 6
  p.third.x = low.w;
  p.third.y = (high.x - low.y * low.w) * p.reciprocals.x;
  p.third.z = (high.y - low.z * low.w - p.second.y * p.third.y * pivots.x) * p.reciprocals.y;
  pivots.z = max(
    high.z - low.w * low.w - p.third.y * p.third.y * pivots.x - p.third.z * p.third.z * pivots.y, least.z);
  p.reciprocals.z = 1.0f / pivots.z;
#endif
#if MOMENTS >= 8
  p.fourth.x = high.x;
  p.fourth.y = (high.y - low.y * high.x) * p.reciprocals.x;
  p.fourth.z = (high.z - low.z * high.x - p.second.y * p.fourth.y * pivots.x) * p.reciprocals.y;
  p.fourth.w = (high.w - low.w * high.x - p.third.y * p.fourth.y * pivots.x - p.third.z * p.fourth.z * pivots.y) *
    p.reciprocals.z;
  pivots.w = max(last - high.x * high.x - p.fourth.y * p.fourth.y * pivots.x - p.fourth.z * p.fourth.z * pivots.y -
      p.fourth.w * p.fourth.w * pivots.z,
    least.w);
  p.reciprocals.w = 1.0f / pivots.w;
#endif
}

// P[1] to P[4] at x, as far as there are such.
vec4 polynomialsAt(INOUT(Polynomials) p, float x)
{
  vec4 values = vec4(0.0f);
  float square = x * x;
  values.x = x - p.first0;
  values.y = square - p.second.x - p.second.y * values.x;
#if MOMENTS >= 6
  values.z = square * x - p.third.x - p.third.y * values.x - p.third.z * values.y;
#endif
#if MOMENTS >= 8
  values.w = square * square - p.fourth.x - p.fourth.y * values.x - p.fourth.z * values.y - p.fourth.w * values.z;
#endif
  return values;
}

// What all but a fragment have in front of z, from their moments. total is what it has absorbed itself, too: by that
// much the moments are rounded.
float absorbanceBefore(vec4 low, vec4 high, float last, float total, float z)
{
  float absorbance = low.x;
  if (!(absorbance > 4.0f * max(TERM_ROUNDING * total, TERM_LEAST)))
  {
    return 0.0f;
  }
  float bias = clamp(TERM_ROUNDING * total / absorbance, MOMENT_BIAS, 1.0f);
  float scale = (1.0f - bias) / absorbance;
  low = scale * low + bias * SPREAD_LOW;
  high = scale * high + bias * SPREAD_HIGH;
  last = scale * last + bias * SPREAD_LAST;
  Polynomials p;
  orthogonalize(low, high, last, bias, p);

  // The coefficients of K(z, x) as a polynomial of x, from the last one on, and of x - z.
  vec4 here = polynomialsAt(p, z);
  vec4 weighted = here * p.reciprocals;
  float kernel = 1.0f + dot(here, weighted);
#if MOMENTS == 4
  float c2 = weighted.y;
  float c1 = weighted.x - p.second.y * c2;
  vec4 coefficients = vec4(c1 + 2.0f * z * c2, c2, 0.0f, 0.0f);
#elif MOMENTS == 6
  float c3 = weighted.z;
  float c2 = weighted.y - p.third.z * c3;
  float c1 = weighted.x - p.second.y * c2 - p.third.y * c3;
  vec4 coefficients = vec4(c1 + z * (2.0f * c2 + 3.0f * z * c3), c2 + 3.0f * z * c3, c3, 0.0f);
#else
  float c4 = weighted.w;
  float c3 = weighted.z - p.fourth.w * c4;
  float c2 = weighted.y - p.third.z * c3 - p.fourth.z * c4;
  float c1 = weighted.x - p.second.y * c2 - p.third.y * c3 - p.fourth.y * c4;
  vec4 coefficients = vec4(c1 + z * (2.0f * c2 + z * (3.0f * c3 + 4.0f * z * c4)), c2 + z * (3.0f * c3 + 6.0f * z * c4),
    c3 + 4.0f * z * c4, c4);
#endif
  Zeros zeros = zerosOf(coefficients / kernel);

  Zeros sensitivity = sensitivityOf(zeros);
  float missing = 1.0f - 1.0f / kernel;
  float inFront = OVERESTIMATION / kernel;
  float sensitivities = 0.0f;
  float sensitivityInFront = 0.0f;
  for (int i = 0; i < MOMENT_ZEROS; ++i)
  {
    const float nearest = 1e-6f; // 1 / t of what is farther away has no mass
    float t = zeros[i];
    if (abs(t) > nearest)
    {
      vec4 there = polynomialsAt(p, z + 1.0f / t);
      float mass = 1.0f / (1.0f + dot(there, there * p.reciprocals));
      missing -= mass;
      inFront += t < 0.0f ? mass : 0.0f;
      sensitivities += sensitivity[i];
      sensitivityInFront += t < 0.0f ? sensitivity[i] : 0.0f;
    }
  }
  inFront += sensitivities > 0.0f ? missing * sensitivityInFront / sensitivities : 0.0f;
  return absorbance * clamp(inFront, 0.0f, 1.0f);
}

#if MOMENTS == 8
#define LAST_OF(vector) (vector).x
#else
#define LAST_OF(vector) 0.0f
#endif
#define LAST_VECTOR (TERM_VECTORS - 1)

#define PLACE_OF(basis) (basis).depth
#include "Moment/InFront.glsl"

#endif
