// Fourier/Series.glsl: absorbance along a ray as a Fourier series (Jansen and Bavoil 2010, "Fourier opacity mapping").
//
// Fragments of absorbance a[i] at depths x[i] between 0 and 1 are peaks of density. Its series has the coefficients
//     sum a[i],  sum a[i] cos(2 pi k x[i]),  sum a[i] sin(2 pi k x[i]),  k = 1 to FOURIER_COEFFICIENTS
// and its integral from 0 to x, term by term, is what lies in front of x:
//     x sum a[i]  +  sin(2 pi k x) / (pi k) sum a[i] cos(2 pi k x[i])  +  (1 - cos(2 pi k x)) / (pi k) sum a[i] sin(2 pi k x[i]).
//
// A series is periodic: at 0 it takes the farthest fragments for neighbours of the nearest ones. So depths are mapped to leave a margin at both
// ends, half as wide as what the last term can tell apart.
//
// Valid C++, too.
//
// Needs: FOURIER_COEFFICIENTS (1 to 15): pairs of cosine and sine.  Gives: TERM_VECTORS, what Absorbance/Terms.glsl gives, basisAt.
#ifndef Series_glsl
#define Series_glsl
#ifndef FOURIER_COEFFICIENTS
#error "Fourier/Series.glsl needs FOURIER_COEFFICIENTS"
#endif

#define TERM_VECTORS ((2 * FOURIER_COEFFICIENTS + 1 + 3) / 4)
#include "Absorbance/Terms.glsl"

#define FOURIER_MARGIN (0.5f / float(FOURIER_COEFFICIENTS + 1))
#define FOURIER_PI 3.14159265358979f

// Angles are given by cosine and sine.
vec2 addAngles(vec2 a, vec2 b)
{
  return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// Cosine and sine of pi * x, for x from 0 to 1: -sin and cos of pi * (x - 1/2), by their Taylor polynomials of degree 11 and 12, off by less
// than 1e-7. Drivers without an instruction for it take some 60 steps instead of these, and a square root.
vec2 halfAngle(float x)
{
  float y = FOURIER_PI * (x - 0.5f);
  float s = y * y;
  float sine = y * (1.0f - s * (1.0f / 6.0f - s * (1.0f / 120.0f - s * (1.0f / 5040.0f - s * (1.0f / 362880.0f - s / 39916800.0f)))));
  float cosine =
    1.0f - s * (0.5f - s * (1.0f / 24.0f - s * (1.0f / 720.0f - s * (1.0f / 40320.0f - s * (1.0f / 3628800.0f - s / 479001600.0f)))));
  return vec2(-sine, cosine);
}

// What a pair of terms weighs in the integral, from cosine and sine of k times the angle.
vec2 integralOf(vec2 wave, int k)
{
  return vec2(wave.y, 1.0f - wave.x) / (FOURIER_PI * float(k));
}

// A vector holds two pairs of cosine and sine. Behind the last pair is the mean.
void basisAt(float depth, OUT(Basis) basis)
{
  float x = mix(FOURIER_MARGIN, 1.0f - FOURIER_MARGIN, depth);
  vec2 halfway = halfAngle(x);
  vec2 once = addAngles(halfway, halfway);
  vec2 twice = addAngles(once, once);
  vec2 odd = once;
  vec2 even = twice;
#define SET_PAIRS(i) \
  basis.density[i] = vec4(odd, even); \
  basis.integral[i] = vec4(integralOf(odd, 2 * i + 1), integralOf(even, 2 * i + 2)); \
  odd = addAngles(odd, twice); \
  even = addAngles(even, twice);
  EACH_VECTOR(SET_PAIRS)
#if FOURIER_COEFFICIENTS % 2 == 0
  basis.density[TERM_VECTORS - 1] = vec4(1.0f, 0.0f, 0.0f, 0.0f);
  basis.integral[TERM_VECTORS - 1] = vec4(x, 0.0f, 0.0f, 0.0f);
#else
  basis.density[TERM_VECTORS - 1] *= vec4(1.0f, 1.0f, 0.0f, 0.0f);
  basis.density[TERM_VECTORS - 1].z = 1.0f;
  basis.integral[TERM_VECTORS - 1] *= vec4(1.0f, 1.0f, 0.0f, 0.0f);
  basis.integral[TERM_VECTORS - 1].z = x;
#endif
}

#endif
