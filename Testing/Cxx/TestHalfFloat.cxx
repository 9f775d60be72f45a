// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Half floats: the shader's own text on the CPU, against GLM's. Runs under AddressSanitizer and
// UndefinedBehaviorSanitizer.
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace glm;
#include "Common/HalfFloat.glsl"

constexpr uint LargestHalf = 0x7bff;

/// Through the second of the four channels, so that a mixed-up one is noticed.
uint ToHalf(float number)
{
  const uvec4 halves = floatToHalf(vec4(1.0f, number, 0.25f, 0.0f));
  EXPECT_EQ(halves.x, 0x3c00u);
  EXPECT_EQ(halves.z, 0x3400u);
  EXPECT_EQ(halves.w, 0u);
  return halves.y;
}

float FromHalf(uint half)
{
  return halfToFloat(uvec4(0u, half, 0u, 0u) << HALF_MANTISSA_SHIFT).y;
}
}

//------------------------------------------------------------------------------
TEST(TestHalfFloat, EveryHalfComesBack)
{
  for (uint half = 0; half <= LargestHalf; ++half)
  {
    const float number = FromHalf(half);
    ASSERT_EQ(number, unpackHalf1x16(static_cast<std::uint16_t>(half))) << half;
    ASSERT_EQ(ToHalf(number), half);
  }
}

//------------------------------------------------------------------------------
RC_GTEST_PROP(TestHalfFloat, NumbersBecomeTheNearestHalf, ())
{
  // As many far below the smallest normal half as above it.
  const float mantissa = 1.0f + static_cast<float>(*rc::gen::inRange(0, 1 << 23)) / (1 << 23);
  const float number = std::ldexp(mantissa, *rc::gen::inRange(-30, 15));
  const uint half = ToHalf(number);
  RC_ASSERT(half <= LargestHalf);
  const float error = std::abs(FromHalf(half) - number);
  RC_ASSERT(half == 0 || error <= std::abs(FromHalf(half - 1) - number));
  RC_ASSERT(half == LargestHalf || error <= std::abs(FromHalf(half + 1) - number));
}

//------------------------------------------------------------------------------
TEST(TestHalfFloat, WhatAHalfCannotHoldBecomesTheNextThatItCan)
{
  using Limits = std::numeric_limits<float>;
  EXPECT_EQ(ToHalf(65519.0f), LargestHalf);
  EXPECT_EQ(ToHalf(Limits::max()), LargestHalf);
  EXPECT_EQ(ToHalf(Limits::infinity()), LargestHalf);
  EXPECT_EQ(ToHalf(-1.0f), 0u);
  EXPECT_EQ(ToHalf(-0.0f), 0u);
  EXPECT_EQ(ToHalf(-Limits::infinity()), 0u);
  EXPECT_EQ(ToHalf(Limits::quiet_NaN()), 0u);
  EXPECT_EQ(ToHalf(Limits::denorm_min()), 0u);
}

//------------------------------------------------------------------------------
TEST(TestHalfFloat, FourComeBackInTheirPlaces)
{
  const vec4 numbers(1.0f, 0.25f, 1e-6f, 65504.0f);
  const uvec2 words = packHalves(numbers);
  EXPECT_EQ(words.x, packHalf2x16(vec2(numbers.x, numbers.y)));
  EXPECT_EQ(words.y, packHalf2x16(vec2(numbers.z, numbers.w)));
  const vec4 back = unpackHalves(words);
  EXPECT_EQ(back.x, numbers.x);
  EXPECT_EQ(back.y, numbers.y);
  EXPECT_EQ(back.z, unpackHalf1x16(packHalf1x16(numbers.z)));
  EXPECT_EQ(back.w, numbers.w);
}
