// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SharedExponent.glsl: three numbers, none of them negative, in 32 bits: 9 bits each, and 5 of an exponent that they
// share (OpenGL 4.6, section 8.25, which calls it RGB9_E5). The largest one is kept to 1/512, the others to as much of
// that one. What is more than 65408 becomes that.
//
// Valid C++, too.
//
// Needs: nothing.  Gives: packShared, unpackShared.
#ifndef SharedExponent_glsl
#define SharedExponent_glsl

#define SHARED_BIAS 15
#define SHARED_MANTISSA_BITS 9
#define SHARED_MANTISSA 511.0f
#define MOST_SHARED 65408.0f

uint packShared(vec3 numbers)
{
  numbers = clamp(numbers, vec3(0.0f), vec3(MOST_SHARED));
  float largest = max(numbers.x, max(numbers.y, numbers.z));
  // One more than that of the largest number, whose mantissa has no leading 1 here.
  int exponent = max(int(floatBitsToUint(largest) >> 23u) - 127 + 1, -SHARED_BIAS);
  float unit = exp2(float(exponent - SHARED_MANTISSA_BITS));
  if (floor(largest / unit + 0.5f) > SHARED_MANTISSA) // it was rounded up to the next power of two
  {
    exponent += 1;
    unit *= 2.0f;
  }
  uvec3 mantissas = uvec3(floor(numbers / unit + vec3(0.5f)));
  return uint(exponent + SHARED_BIAS) << 27u | mantissas.z << 18u | mantissas.y << 9u | mantissas.x;
}

vec3 unpackShared(uint word)
{
  float unit = exp2(float(int(word >> 27u) - SHARED_BIAS - SHARED_MANTISSA_BITS));
  return unit * vec3(float(word & 511u), float(word >> 9u & 511u), float(word >> 18u & 511u));
}

#endif
