// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility from sums of absorbance: the shaders' own text on the CPU, against the reference in double precision and
// against what theory says.
#include "AbsorbanceShader.h"
#include "Reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using Absorbers = std::vector<Absorber>;

/// Depths of 1/997 lie on no slice's border but 0 and 1.
Absorbers RandomAbsorbers(unsigned int seed, int count, float leastAlpha, float mostAlpha)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> depth(0, 997);
  std::uniform_real_distribution<float> alpha(leastAlpha, mostAlpha);
  Absorbers absorbers;
  for (int i = 0; i < count; ++i)
  {
    absorbers.push_back({ depth(random) / 997.0f, alpha(random) });
  }
  return absorbers;
}

double Absorbance(const Absorber& absorber)
{
  return -std::log(std::max(1.0 - absorber.Alpha, 1.0 / 1024));
}
}

class TestAbsorbance : public testing::TestWithParam<AbsorbanceVariant>
{
};

//------------------------------------------------------------------------------
// Of as many layers as a distribution can have that the moments tell from all others.
TEST(TestMoments, FewLayersAreExact)
{
  for (const AbsorbanceVariant& variant : AbsorbanceVariants())
  {
    const bool power = variant.Technique == "Moment";
    if (!power && variant.Technique != "Trigonometric")
    {
      continue;
    }
    double worst = 0, sum = 0; int n = 0;
    const int most = (power ? variant.Terms / 2 : variant.Terms) + 1;
    for (unsigned int seed = 0; seed < 300; ++seed)
    {
      std::mt19937 random(seed);
      std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
      Absorbers absorbers;
      const int count = 1 + static_cast<int>(seed) % most;
      for (int i = 0; i < count; ++i)
      {
        absorbers.push_back({ (i + 0.2f + 0.6f * uniform(random)) / count, 0.05f + 0.94f * uniform(random) });
      }
      const auto visibilities = variant.GetVisibilities(absorbers);
      double exact = 1;
      for (int i = 0; i < count; ++i)
      {
        worst = std::max(worst, std::abs(visibilities[i] - exact)); sum += std::abs(visibilities[i] - exact); ++n;
        exact *= 1 - absorbers[i].Alpha;
      }
    }
    std::printf("%s %d %d: worst %g mean %g\n", variant.Technique.c_str(), variant.Terms, variant.Channels, worst, sum / n);
  }
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbance, IsThatOfTheReference)
{
  const std::string technique = GetParam().Technique;
  const auto share = technique == "Fourier" ? Reference::FourierShare
    : technique == "Slices"                 ? Reference::SliceShare
                                            : Reference::WaveletShare;
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const Absorbers absorbers = RandomAbsorbers(seed, 1 + static_cast<int>(seed % 40), 0.01f, seed % 2 ? 0.3f : 1.0f);
    const std::vector<float> visibilities = GetParam().GetVisibilities(absorbers);
    for (std::size_t i = 0; i < absorbers.size(); ++i)
    {
      double inFront = 0;
      for (std::size_t j = 0; j < absorbers.size(); ++j)
      {
        inFront +=
          j == i ? 0 : Absorbance(absorbers[j]) * share(GetParam().Terms, absorbers[j].Depth, absorbers[i].Depth);
      }
      EXPECT_NEAR(visibilities[i], std::exp(-std::max(0.0, inFront)), 1e-4) << "seed " << seed << ", fragment " << i;
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbance, NothingHidesItself)
{
  for (float depth : { 0.0f, 0.001f, 0.3f, 0.5f, 0.77f, 1.0f })
  {
    for (float alpha : { 0.001f, 0.5f, 0.999f, 1.0f })
    {
      EXPECT_NEAR(GetParam().GetVisibilities({ { depth, alpha } })[0], 1, 1e-5) << depth << ", " << alpha;
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbance, TransparentFragmentsChangeNothing)
{
  Absorbers absorbers = RandomAbsorbers(1, 10, 0.1f, 0.6f);
  const std::vector<float> before = GetParam().GetVisibilities(absorbers);
  absorbers.push_back({ 0.2f, 0.0f });
  const std::vector<float> after = GetParam().GetVisibilities(absorbers);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_NEAR(before[i], after[i], 1e-6);
  }
}

//------------------------------------------------------------------------------
// Half a range away, more than what the fewest of these terms tell apart.
TEST_P(TestAbsorbance, OpaqueFragmentsHideWhatIsBehind)
{
  const std::vector<float> visibilities = GetParam().GetVisibilities({ { 0.2f, 1.0f }, { 0.8f, 0.5f } });
  if (GetParam().Terms >= 3 || GetParam().Technique == "Wavelet")
  {
    EXPECT_LT(visibilities[1], 1.0f / 255);
  }
  for (float visibility : visibilities)
  {
    EXPECT_TRUE(std::isfinite(visibility));
    EXPECT_LE(visibility, 1);
    EXPECT_GE(visibility, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, TestAbsorbance, testing::ValuesIn(AbsorbanceVariants()),
  [](const auto& info)
  { return info.param.Technique + std::to_string(info.param.Terms) + (info.param.Channels == 3 ? "Colored" : ""); });

//------------------------------------------------------------------------------
// More terms come nearer to the truth: mean distance from the exact visibility over many pixels.
TEST(TestAbsorbanceOf, MoreTermsIsNearerToExact)
{
  for (const std::string technique : { "Fourier", "Slices", "Wavelet" })
  {
    double last = 1;
    for (const AbsorbanceVariant& variant : AbsorbanceVariants())
    {
      if (variant.Technique != technique || variant.Channels != 1)
      {
        continue;
      }
      double sum = 0;
      constexpr int Pixels = 100;
      constexpr int Count = 12;
      for (unsigned int seed = 0; seed < Pixels; ++seed)
      {
        const Absorbers absorbers = RandomAbsorbers(seed, Count, 0.1f, 0.6f);
        const std::vector<float> visibilities = variant.GetVisibilities(absorbers);
        for (std::size_t i = 0; i < absorbers.size(); ++i)
        {
          double exact = 1;
          for (const Absorber& other : absorbers)
          {
            exact *= other.Depth < absorbers[i].Depth ? 1 - other.Alpha : 1;
          }
          sum += std::abs(visibilities[i] - exact);
        }
      }
      const double mean = sum / (Pixels * Count);
      EXPECT_LT(mean, last) << technique << variant.Terms;
      last = mean;
    }
    EXPECT_LT(last, 0.03) << technique;
  }
}

//------------------------------------------------------------------------------
// The first and the last fragment lie at the ends of the grid: nothing is in front of one, everything else in front of
// the other.
TEST(TestAbsorbanceOf, EndsOfTheGridAreExact)
{
  for (const AbsorbanceVariant& variant : AbsorbanceVariants())
  {
    if (variant.Technique == "Slices")
    {
      const std::vector<float> visibilities = variant.GetVisibilities({ { 0, 0.4f }, { 0.6f, 0.3f }, { 1, 0.7f } });
      EXPECT_NEAR(visibilities[0], 1, 1e-6) << variant.Terms;
      EXPECT_NEAR(visibilities[2], 0.6 * 0.7, 1e-6) << variant.Terms;
    }
  }
}
