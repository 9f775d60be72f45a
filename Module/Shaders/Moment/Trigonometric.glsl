// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/Trigonometric.glsl: absorbance along a ray by its trigonometric moments (Muenstermann, Krumpen, Klein, Peters
// 2018, "Moment-based order-independent transparency").
//
// The same as Moment/Power.glsl with angles: depth x, 0 to 1, is the angle f = x (2 pi - GAP) on a circle, of which the
// rest, GAP, lies half in front of all depths and half behind them. The terms are
//   b[0] = sum a[i],   b[k] = sum a[i] e^(i k f[i]),   k = 1 to TRIGONOMETRIC_MOMENTS.
// The distribution that the moments are mixed with is the one that is the same at all angles: of it all moments but the
// 0th are 0, and all D[k] are 1. Orthogonal polynomials on a circle follow from each other (Szego 1939):
//   P[k + 1](w) = w P[k](w) - conj(r[k]) Q[k](w),   Q[k](w) = w^k conj(P[k](w)) where |w| is 1,
//   D[k + 1] = D[k] (1 - |r[k]|^2).
// Angles are measured from that of the fragment, d. K(1, e^(i d)) is a polynomial of t = cot(d / 2), with real
// coefficients and zeros, and K(1, 1) for the leading one.
//
// Valid C++, too.
//
// Needs: TRIGONOMETRIC_MOMENTS (2 to 4), MOMENT_BIAS, OVERESTIMATION.  Gives: TERM_VECTORS, Basis, basisAt,
// prepareTerms, absorbanceInFront.
#ifndef Trigonometric_glsl
#define Trigonometric_glsl
#ifndef TRIGONOMETRIC_MOMENTS
#error "Moment/Trigonometric.glsl needs TRIGONOMETRIC_MOMENTS"
#endif

#define TERM_VECTORS ((2 * TRIGONOMETRIC_MOMENTS + 1 + 3) / 4)
#include "Absorbance/Terms.glsl"

#define MOMENT_ZEROS TRIGONOMETRIC_MOMENTS
#include "Moment/Zeros.glsl"

#define WHOLE_CIRCLE 6.2831853f
#define GAP 0.31415927f
#define SINE_OF_HALF_GAP 0.15643447f
#define COSINE_OF_HALF_GAP 0.98768834f

struct Basis
{
  vec4 density[TERM_VECTORS];
  float angle;
};

vec2 timesComplex(vec2 a, vec2 b)
{
  return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// Rises with a vector's angle from 0 to the whole circle, from 0 to 4.
float angleOrder(vec2 a)
{
  float x = a.x / (abs(a.x) + abs(a.y));
  return a.y < 0.0f ? 3.0f + x : 1.0f - x;
}

vec2 conjugate(vec2 a)
{
  return vec2(a.x, -a.y);
}

void basisAt(float depth, OUT(Basis) basis)
{
  basis.angle = depth * (WHOLE_CIRCLE - GAP);
  vec2 once = vec2(cos(basis.angle), sin(basis.angle));
  vec2 twice = timesComplex(once, once);
  basis.density[0] = vec4(1.0f, once, twice.x);
#if TRIGONOMETRIC_MOMENTS == 2
  basis.density[1] = vec4(twice.y, 0.0f, 0.0f, 0.0f);
#else
  vec2 thrice = timesComplex(once, twice);
  basis.density[1] = vec4(twice.y, thrice, 0.0f);
#endif
#if TRIGONOMETRIC_MOMENTS == 4
  vec2 fourth = timesComplex(twice, twice);
  basis.density[1].w = fourth.x;
  basis.density[2] = vec4(fourth.y, 0.0f, 0.0f, 0.0f);
#endif
}

void prepareTerms(INOUT(Terms) terms)
{
  terms.offset = Channels(0.0f);
}

#define POLYNOMIALS (TRIGONOMETRIC_MOMENTS + 1)
#define COEFFICIENT(polynomial, power) ((polynomial) * POLYNOMIALS + (power))

// The coefficients of P[0] to P[n], each by powers of w, conj(r[k]), and 1 / D[k].
struct Polynomials
{
  vec2 coefficients[POLYNOMIALS * POLYNOMIALS];
  vec2 reflections[TRIGONOMETRIC_MOMENTS];
  float reciprocals[POLYNOMIALS];
};

// moments[k - 1] is the k-th of a distribution whose 0th is 1.
struct CircleMoments
{
  vec2 values[TRIGONOMETRIC_MOMENTS];
};

void orthogonalize(INOUT(CircleMoments) moments, float bias, OUT(Polynomials) p)
{
  float mean = 1.0f;
  for (int k = 0; k <= TRIGONOMETRIC_MOMENTS; ++k)
  {
    for (int j = 0; j <= TRIGONOMETRIC_MOMENTS; ++j)
    {
      p.coefficients[COEFFICIENT(k, j)] = vec2(0.0f);
    }
  }
  p.coefficients[COEFFICIENT(0, 0)] = vec2(1.0f, 0.0f);
  p.reciprocals[0] = 1.0f;
  for (int k = 0; k < TRIGONOMETRIC_MOMENTS; ++k)
  {
    // The mean of w P[k](w), to which Q[k] brings D[k].
    vec2 product = vec2(0.0f);
    for (int j = 0; j <= k; ++j)
    {
      product += timesComplex(p.coefficients[COEFFICIENT(k, j)], moments.values[j]);
    }
    vec2 reflection = product / mean;
    // No D is less than the share of the one that is the same all over.
    float most = max(1.0f - bias / mean, 0.0f);
    float square = dot(reflection, reflection);
    reflection *= square > most ? sqrt(most / square) : 1.0f;
    p.reflections[k] = reflection;
    mean *= 1.0f - min(square, most);
    p.reciprocals[k + 1] = 1.0f / mean;
    for (int j = 0; j <= k + 1; ++j)
    {
      vec2 shifted = j > 0 ? p.coefficients[COEFFICIENT(k, j > 0 ? j - 1 : 0)] : vec2(0.0f);
      vec2 reversed = j <= k ? conjugate(p.coefficients[COEFFICIENT(k, j <= k ? k - j : 0)]) : vec2(0.0f);
      p.coefficients[COEFFICIENT(k + 1, j)] = shifted - timesComplex(reflection, reversed);
    }
  }
}

// K(w, w)
float kernelAt(INOUT(Polynomials) p, vec2 w)
{
  vec2 value = vec2(1.0f, 0.0f);
  vec2 power = vec2(1.0f, 0.0f);
  float kernel = 1.0f;
  for (int k = 0; k < TRIGONOMETRIC_MOMENTS; ++k)
  {
    value = timesComplex(w, value) - timesComplex(p.reflections[k], timesComplex(power, conjugate(value)));
    power = timesComplex(power, w);
    kernel += dot(value, value) * p.reciprocals[k + 1];
  }
  return kernel;
}

// K(1, w) w^(-n / 2) as a polynomial of t = cot(d / 2), over its leading coefficient: the sum of q[j] (t + i)^j
// (t - i)^(n - j).
vec4 coefficientsOf(INOUT(Polynomials) p)
{
  vec2 q[POLYNOMIALS];
  for (int j = 0; j <= TRIGONOMETRIC_MOMENTS; ++j)
  {
    q[j] = vec2(0.0f);
  }
  for (int k = 0; k <= TRIGONOMETRIC_MOMENTS; ++k)
  {
    vec2 here = vec2(0.0f);
    for (int j = 0; j <= k; ++j)
    {
      here += p.coefficients[COEFFICIENT(k, j)];
    }
    for (int j = 0; j <= k; ++j)
    {
      q[j] += timesComplex(conjugate(here), p.coefficients[COEFFICIENT(k, j)]) * p.reciprocals[k];
    }
  }
  // Of (t + i)^j (t - i)^(n - j) the coefficients are real and imaginary in turn.
#if TRIGONOMETRIC_MOMENTS == 2
  float leading = q[0].x + q[1].x + q[2].x;
  return vec4(2.0f * (q[0].y - q[2].y), q[1].x - q[0].x - q[2].x, 0.0f, 0.0f) / leading;
#elif TRIGONOMETRIC_MOMENTS == 3
  float leading = q[0].x + q[1].x + q[2].x + q[3].x;
  return vec4(3.0f * (q[0].y - q[3].y) + q[1].y - q[2].y, q[1].x + q[2].x - 3.0f * (q[0].x + q[3].x),
           q[1].y - q[2].y - q[0].y + q[3].y, 0.0f) / leading;
#else
  float leading = q[0].x + q[1].x + q[2].x + q[3].x + q[4].x;
  return vec4(4.0f * (q[0].y - q[4].y) + 2.0f * (q[1].y - q[3].y), 2.0f * q[2].x - 6.0f * (q[0].x + q[4].x),
           4.0f * (q[4].y - q[0].y) + 2.0f * (q[1].y - q[3].y), q[0].x + q[4].x + q[2].x - q[1].x - q[3].x) / leading;
#endif
}

// Of a mass at an angle from the middle of the gap, how much is in front of a fragment at another. The gap has no
// fragments, but masses may lie there: in front at its end, behind at its beginning, and in between by shares, so that
// no visibility jumps where a mass comes to an end of the depths.
float shareInFront(vec2 mass, vec2 fragment)
{
  float passed = 0.5f + 0.5f * mass.y * (1.0f / SINE_OF_HALF_GAP);
  return mass.x > COSINE_OF_HALF_GAP ? passed : angleOrder(mass) < angleOrder(fragment) ? 1.0f : 0.0f;
}

// What all but a fragment have in front of an angle, from their moments. total is what it has absorbed itself, too: by
// that much the moments are rounded.
float absorbanceBefore(INOUT(CircleMoments) moments, float absorbance, float total, float angle)
{
  if (!(absorbance > 4.0f * max(TERM_ROUNDING * total, TERM_LEAST)))
  {
    return 0.0f;
  }
  float bias = clamp(TERM_ROUNDING * total / absorbance, MOMENT_BIAS, 1.0f);
  vec2 turn = vec2(cos(angle), -sin(angle));
  vec2 turned = turn;
  for (int k = 0; k < TRIGONOMETRIC_MOMENTS; ++k)
  {
    moments.values[k] = timesComplex(turned, moments.values[k]) * ((1.0f - bias) / absorbance);
    turned = timesComplex(turned, turn);
  }
  Polynomials p;
  orthogonalize(moments, bias, p);
  float here = 1.0f / kernelAt(p, vec2(1.0f, 0.0f));
  float missing = 1.0f - here;
  float inFront = OVERESTIMATION * here;
  float sensitivityInFront = 0.0f;
  // From the middle of the gap to the fragment: half the gap more than the angle.
  vec2 toMiddle = timesComplex(conjugate(turn), vec2(COSINE_OF_HALF_GAP, SINE_OF_HALF_GAP));
  Zeros zeros = zerosOf(coefficientsOf(p));
  Zeros sensitivity = sensitivityOf(zeros);
  for (int i = 0; i < MOMENT_ZEROS; ++i)
  {
    float t = zeros[i];
    vec2 there = vec2(t * t - 1.0f, 2.0f * t) / (t * t + 1.0f); // (t + i) / (t - i)
    float mass = 1.0f / kernelAt(p, there);
    float share = shareInFront(timesComplex(there, toMiddle), toMiddle);
    missing -= mass;
    inFront += mass * share;
    sensitivityInFront += sensitivity[i] * share;
  }
  inFront += missing * sensitivityInFront / dot(sensitivity, Zeros(1.0f));
  return absorbance * clamp(inFront, 0.0f, 1.0f);
}

float absorbanceBefore(vec4 first, vec4 second, float last, float total, float angle)
{
  CircleMoments moments;
  moments.values[0] = vec2(first.y, first.z);
  moments.values[1] = vec2(first.w, second.x);
#if TRIGONOMETRIC_MOMENTS >= 3
  moments.values[2] = vec2(second.y, second.z);
#endif
#if TRIGONOMETRIC_MOMENTS >= 4
  moments.values[3] = vec2(second.w, last);
#endif
  return absorbanceBefore(moments, first.x, total, angle);
}

#if TRIGONOMETRIC_MOMENTS == 4
#define LAST_OF(vector) (vector).x
#else
#define LAST_OF(vector) 0.0f
#endif
#define LAST_VECTOR (TERM_VECTORS - 1)
#define PLACE_OF(basis) (basis).angle
#include "Moment/InFront.glsl"

#endif
