// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// HalfFloat.glsl: packHalf2x16 and its inverse for numbers that are never negative, in a third of the steps.
//
// Drivers without an instruction for it (llvmpipe) write packHalf2x16 out for every sign, infinity and NaN, some 25
// steps a number; of a scene that costs nothing to shade, that was a tenth of the frame's time. On a GPU these eight
// steps are no loss: a gather waits for memory. Nor would an instruction do the same: GLSL does not say how
// packHalf2x16 rounds, AMD's cuts off what does not fit, and what is below HALF_SMALLEST_NORMAL may become 0 both ways.
// Pictures would depend on the GPU, and what the CPU's tests say of this text would not hold there
// (Documentation/Drivers.md).
//
// Numbers that a half float can't hold, above HALF_LARGEST, become that; negative ones and NaN become 0. Below
// HALF_SMALLEST_NORMAL halves are multiples of 2^-24, as they should: adding that number to one of them shifts its bits
// to where they belong.
//
// Needs: nothing.  Gives: floatToHalf (to the nearest; halfway between two, the larger), halfToFloat (exact), and for
// four of them in two words: packHalves, unpackHalves.
#ifndef HalfFloat_glsl
#define HalfFloat_glsl

#define HALF_LARGEST 65504.0f
#define HALF_SMALLEST_NORMAL 6.103515625e-5f // 2^-14
#define HALF_MANTISSA_SHIFT 13u              // a float has 23 bits, a half 10
#define HALF_EXPONENT_BIAS 0x38000000u       // 127 - 15, in a float's exponent
#define HALF_EXPONENT_STEP 0x00800000u       // 1, in a float's exponent
#define HALF_ROUND_UP 0x00001000u            // half of a half float's last bit

// Each result in the lower 16 bits of a word.
uvec4 floatToHalf(vec4 number)
{
  vec4 held = mix(vec4(0.0f), min(number, vec4(HALF_LARGEST)), greaterThan(number, vec4(0.0f)));
  bvec4 subnormal = lessThan(held, vec4(HALF_SMALLEST_NORMAL));
  uvec4 bits = floatBitsToUint(held + vec4(subnormal) * HALF_SMALLEST_NORMAL);
  return (bits - uvec4(subnormal) * HALF_EXPONENT_STEP - (HALF_EXPONENT_BIAS - HALF_ROUND_UP)) >>
    HALF_MANTISSA_SHIFT;
}

// Each half float in the bits from HALF_MANTISSA_SHIFT on, the other bits 0.
vec4 halfToFloat(uvec4 shifted)
{
  bvec4 subnormal = lessThan(shifted, uvec4(HALF_EXPONENT_STEP));
  uvec4 bits = shifted + HALF_EXPONENT_BIAS + uvec4(subnormal) * HALF_EXPONENT_STEP;
  return uintBitsToFloat(bits) - vec4(subnormal) * HALF_SMALLEST_NORMAL;
}

uvec2 packHalves(vec4 numbers)
{
  uvec4 halves = floatToHalf(numbers);
  return uvec2(halves.x | (halves.y << 16u), halves.z | (halves.w << 16u));
}

vec4 unpackHalves(uvec2 words)
{
  uvec4 halves = uvec4(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu, words.y >> 16u);
  return halfToFloat(halves << HALF_MANTISSA_SHIFT);
}

#endif
