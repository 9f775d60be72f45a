// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fourier/Series.glsl: absorbance along a ray as a Fourier series (Jansen and Bavoil 2010, "Fourier opacity mapping").
//
// Fragments of absorbance a[i] at depths x[i] between 0 and 1 are peaks of density. Its series has the coefficients sum
// a[i],  sum a[i] cos(2 pi k x[i]),  sum a[i] sin(2 pi k x[i]),  k = 1 to FOURIER_COEFFICIENTS and its integral from 0
// to x, term by term, is what lies in front of x: x sum a[i]  +  sin(2 pi k x) / (pi k) sum a[i] cos(2 pi k x[i])  +
// (1 - cos(2 pi k x)) / (pi k) sum a[i] sin(2 pi k x[i]).
//
// A series is periodic: at 0 it takes the farthest fragments for neighbours of the nearest ones. So depths are mapped
// to leave a margin at both ends, half as wide as what the last term can tell apart.
//
// Valid C++, too.
//
// Needs: FOURIER_COEFFICIENTS (1 to 15): pairs of cosine and sine.  Gives: TERM_VECTORS, what Absorbance/Linear.glsl
// gives, basisAt, prepareTerms.
#ifndef Series_glsl
#define Series_glsl
#ifndef FOURIER_COEFFICIENTS
#error "Fourier/Series.glsl needs FOURIER_COEFFICIENTS"
#endif

#define TERM_VECTORS ((2 * FOURIER_COEFFICIENTS + 1 + 3) / 4)
#include "Absorbance/Linear.glsl"

#define FOURIER_MARGIN (0.5f / float(FOURIER_COEFFICIENTS + 1))
#define FOURIER_PI 3.14159265358979f

// Cosine and sine of pi * x, for x from 0 to 1: -sin and cos of pi * (x - 1/2), by their Taylor polynomials of degree
// 11 and 12, off by less than 1e-7. Drivers without an instruction for it take some 60 steps instead of these, and a
// square root. Constants are reciprocals, since compilers keep divisions by others.
vec2 halfAngle(float x)
{
  float y = FOURIER_PI * (x - 0.5f);
  float s = y * y;
  float sine = y *
    (1.0f - s * (1.0f / 6.0f - s * (1.0f / 120.0f - s * (1.0f / 5040.0f -
      s * (1.0f / 362880.0f - s * (1.0f / 39916800.0f))))));
  float cosine = 1.0f -
    s * (0.5f - s * (1.0f / 24.0f - s * (1.0f / 720.0f - s * (1.0f / 40320.0f -
      s * (1.0f / 3628800.0f - s * (1.0f / 479001600.0f))))));
  return vec2(-sine, cosine);
}

// What the last vector holds: the last pair, if it has no partner, and behind it the mean.
#if FOURIER_COEFFICIENTS % 2 == 0
#define FOURIER_LAST_PAIR vec4(0.0f)
#define FOURIER_MEAN vec4(1.0f, 0.0f, 0.0f, 0.0f)
#else
#define FOURIER_LAST_PAIR vec4(1.0f, 1.0f, 0.0f, 0.0f)
#define FOURIER_MEAN vec4(0.0f, 0.0f, 1.0f, 0.0f)
#endif

// Of the k-th pair's integral.
#define FOURIER_WEIGHT(k) ((k) <= FOURIER_COEFFICIENTS ? 1.0f / (FOURIER_PI * float(k)) : 0.0f)

// A vector holds the cosine and sine of k times the angle, and of k + 1 times. Those of the next one follow from the
// two before (Chebyshev): cos((k + 2) a) = 2 cos(2 a) cos(k a) - cos((k - 2) a), and the same for sines. What a pair
// weighs of itself is the sum of cos sin and (1 - cos) sin, a sine.
void basisAt(float depth, OUT(Basis) basis)
{
  float x = FOURIER_MARGIN + (1.0f - 2.0f * FOURIER_MARGIN) * depth;
  vec2 halfway = halfAngle(x);
  vec2 once = vec2(2.0f * halfway.x * halfway.x - 1.0f, 2.0f * halfway.x * halfway.y);
  vec2 twice = vec2(2.0f * once.x * once.x - 1.0f, 2.0f * once.x * once.y);
  vec4 before = vec4(once.x, -once.y, 1.0f, 0.0f);
  vec4 waves = vec4(once, twice);
  vec4 next;
  basis.own = x;
#define SET_PAIRS(i) \
  basis.density[i] = waves; \
  basis.integral[i] = vec4(waves.y, waves.x, waves.w, waves.z); \
  basis.own += FOURIER_WEIGHT(2 * i + 1) * waves.y + FOURIER_WEIGHT(2 * i + 2) * waves.w; \
  next = 2.0f * twice.x * waves - before; \
  before = waves; \
  waves = next;
  EACH_VECTOR(SET_PAIRS)
  basis.density[TERM_VECTORS - 1] = FOURIER_LAST_PAIR * basis.density[TERM_VECTORS - 1] + FOURIER_MEAN;
  basis.integral[TERM_VECTORS - 1] = FOURIER_LAST_PAIR * basis.integral[TERM_VECTORS - 1] + x * FOURIER_MEAN;
}

// The weights of sin(2 pi k x) and of cos(2 pi k x) in the integral, and what it has in front of every x.
void prepareTerms(INOUT(Terms) terms)
{
  vec4 weights;
  terms.offset = Channels(0.0f);
#define WEIGH_PAIRS(i) \
  weights = vec4(vec2(FOURIER_WEIGHT(2 * i + 1)), vec2(FOURIER_WEIGHT(2 * i + 2))) * vec4(1.0f, -1.0f, 1.0f, -1.0f); \
  terms.offset -= integrate(terms.sums[i], weights * vec4(0.0f, 1.0f, 0.0f, 1.0f)); \
  terms.sums[i] = weighted(terms.sums[i], weights + (i == TERM_VECTORS - 1 ? FOURIER_MEAN : vec4(0.0f)));
  EACH_VECTOR(WEIGH_PAIRS)
}

#endif
