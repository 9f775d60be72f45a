// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/Zeros.glsl: the zeros of polynomials all of whose zeros are real.
//
// Valid C++, too.
//
// Needs: MOMENT_ZEROS (2 to 4), the degree.  Gives: Zeros (a vector), zerosOf: of the polynomial whose coefficients are
// 1 and those that it is given, from the second one on; sensitivityOf: how far rounding may move each, but for a
// factor.
#ifndef Zeros_glsl
#define Zeros_glsl
#ifndef MOMENT_ZEROS
#error "Moment/Zeros.glsl needs MOMENT_ZEROS"
#endif

#define LEAST_SLOPE 1e-20f

// The zeros of t^2 + b t + c, which are real.
vec2 zerosOfSquare(float b, float c)
{
  float middle = 0.5f * b;
  float root = sqrt(max(middle * middle - c, 0.0f));
  float larger = -(middle + (middle < 0.0f ? -root : root));
  return vec2(larger, larger != 0.0f ? c / larger : 0.0f);
}

// The same of t^3 + a t^2 + b t + c, by cosines of a third of an angle.
vec3 zerosOfCube(float a, float b, float c)
{
  float middle = a * (1.0f / 3.0f);
  float square = max(middle * middle - b * (1.0f / 3.0f), 0.0f);
  float radius = sqrt(square);
  float cube = square * radius;
  float product = middle * middle * middle + 0.5f * (c - middle * b);
  float third = acos(cube > 0.0f ? clamp(product / cube, -1.0f, 1.0f) : 0.0f) * (1.0f / 3.0f);
  vec3 cosines = vec3(cos(third), cos(third + 2.0943951f), cos(third - 2.0943951f));
  return -2.0f * radius * cosines - vec3(middle);
}

#if MOMENT_ZEROS == 2
#define Zeros vec2
Zeros zerosOf(vec4 c)
{
  return zerosOfSquare(c.x, c.y);
}

Zeros sensitivityOf(Zeros zeros)
{
  return Zeros(1.0f);
}
#elif MOMENT_ZEROS == 3
#define Zeros vec3
Zeros zerosOf(vec4 c)
{
  vec3 t = zerosOfCube(c.x, c.y, c.z);
  // Newton's step, to where the slope is not lost in rounding.
  vec3 value = ((t + vec3(c.x)) * t + vec3(c.y)) * t + vec3(c.z);
  vec3 slope = (3.0f * t + vec3(2.0f * c.x)) * t + vec3(c.y);
  return t - vec3(slope.x != 0.0f ? value.x / slope.x : 0.0f, slope.y != 0.0f ? value.y / slope.y : 0.0f,
               slope.z != 0.0f ? value.z / slope.z : 0.0f);
}

// One over the slope at the zero.
Zeros sensitivityOf(Zeros t)
{
  vec3 differences = abs(vec3(t.x - t.y, t.y - t.z, t.z - t.x));
  return 1.0f / max(differences * vec3(differences.z, differences.x, differences.y), vec3(LEAST_SLOPE));
}
#else
#define Zeros vec4

// Nearer to the zeros of a polynomial, all at once and never two to one (Aberth 1973).
float approachZero(vec4 c, float t, float u, float v, float w)
{
  float value = (((t + c.x) * t + c.y) * t + c.z) * t + c.w;
  float slope = ((4.0f * t + 3.0f * c.x) * t + 2.0f * c.y) * t + c.z;
  float others = (t != u ? 1.0f / (t - u) : 0.0f) + (t != v ? 1.0f / (t - v) : 0.0f) + (t != w ? 1.0f / (t - w) : 0.0f);
  float rest = slope - value * others;
  return rest != 0.0f ? t - value / rest : t;
}

// A zero at one end of them: from where none lies beyond (Samuelson 1968), in the steps of Laguerre, which don't go too
// far where all zeros are real.
float outermostZero(vec4 c)
{
  float mean = -0.25f * c.x;
  float extent = sqrt(max(3.0f * (3.0f / 16.0f * c.x * c.x - 0.5f * c.y), 0.0f));
  float t = mean + (mean < 0.0f ? -extent : extent);
  for (int i = 0; i < 3; ++i)
  {
    float value = (((t + c.x) * t + c.y) * t + c.z) * t + c.w;
    float slope = ((4.0f * t + 3.0f * c.x) * t + 2.0f * c.y) * t + c.z;
    float curvature = (12.0f * t + 6.0f * c.x) * t + 2.0f * c.y;
    float root = sqrt(max(3.0f * (3.0f * slope * slope - 4.0f * value * curvature), 0.0f));
    float divisor = slope + (slope < 0.0f ? -root : root);
    t -= divisor != 0.0f ? 4.0f * value / divisor : 0.0f;
  }
  return t;
}

// The outermost one, and those of the cube that is left without it: its coefficients from the last one on, which keeps
// what is small exact.
Zeros zerosOf(vec4 c)
{
  float outermost = outermostZero(c);
  vec3 cube = vec3(c.x, c.y, c.z);
  if (outermost != 0.0f)
  {
    cube.z = -c.w / outermost;
    cube.y = (cube.z - c.z) / outermost;
    cube.x = (cube.y - c.y) / outermost;
  }
  Zeros t = Zeros(outermost, zerosOfCube(cube.x, cube.y, cube.z));
  t.x = approachZero(c, t.x, t.y, t.z, t.w);
  t.y = approachZero(c, t.y, t.x, t.z, t.w);
  t.z = approachZero(c, t.z, t.x, t.y, t.w);
  t.w = approachZero(c, t.w, t.x, t.y, t.z);
  return t;
}

// One over the slope at the zero.
Zeros sensitivityOf(Zeros t)
{
  vec4 next = abs(t - vec4(t.y, t.z, t.w, t.x));
  vec4 last = vec4(next.w, next.x, next.y, next.z);
  vec2 across = abs(vec2(t.x - t.z, t.y - t.w));
  return 1.0f / max(next * last * vec4(across, across), vec4(LEAST_SLOPE));
}
#endif

#endif
