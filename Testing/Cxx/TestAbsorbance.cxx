// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility from sums of absorbance: the shaders' own text on the CPU, against the reference in double precision and
// against what theory says.
#include "AbsorbanceShader.h"
#include "Reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
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

namespace
{
bool IsRounded(const AbsorbanceVariant& variant)
{
  return variant.Half || variant.Shared;
}
}

class TestAbsorbance : public testing::TestWithParam<AbsorbanceVariant>
{
};

using TestLinearAbsorbance = TestAbsorbance;
using TestMoments = TestAbsorbance;
using TestPowerMoments = TestAbsorbance;

bool IsTrigonometric(const AbsorbanceVariant& variant)
{
  return variant.Technique == "Moment" && variant.Terms >= 3;
}

std::vector<AbsorbanceVariant> VariantsWhere(const std::function<bool(const AbsorbanceVariant&)>& isMeant)
{
  std::vector<AbsorbanceVariant> variants;
  std::copy_if(AbsorbanceVariants().begin(), AbsorbanceVariants().end(), std::back_inserter(variants), isMeant);
  return variants;
}

std::string NameOf(const testing::TestParamInfo<AbsorbanceVariant>& info)
{
  const AbsorbanceVariant& variant = info.param;
  return variant.Technique + std::to_string(variant.Terms) + (variant.Channels == 3 ? "Colored" : "") +
    (variant.Half ? "Half" : "") + (variant.Shared ? "Shared" : "");
}

/// The layers that these moments tell from any others: half as many as there are power moments, or as many as there
/// are trigonometric ones, and the fragment itself.
int LayersOfMoments(int moments)
{
  return (moments < 3 ? 2 + moments : moments - 1) + 1;
}

//------------------------------------------------------------------------------
TEST_P(TestLinearAbsorbance, IsThatOfTheReference)
{
  const std::string technique = GetParam().Technique;
  const auto share = technique == "Fourier" ? Reference::FourierShare
    : technique == "Slices"                 ? Reference::SliceShare
                                            : Reference::WaveletShare;
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const Absorbers absorbers = RandomAbsorbers(seed, 1 + static_cast<int>(seed % 40), 0.01f, seed % 2 ? 0.3f : 1.0f);
    const std::vector<float> visibilities = GetParam()(absorbers);
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
      EXPECT_NEAR(GetParam()({ { depth, alpha } })[0], 1,
        GetParam().Shared   ? 1e-2
          : GetParam().Half ? 1.0 / 255
                            : 1e-5)
        << depth << ", " << alpha;
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbance, TransparentFragmentsChangeNothing)
{
  Absorbers absorbers = RandomAbsorbers(1, 10, 0.1f, 0.6f);
  const std::vector<float> before = GetParam()(absorbers);
  absorbers.push_back({ 0.2f, 0.0f });
  const std::vector<float> after = GetParam()(absorbers);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_NEAR(before[i], after[i], GetParam().Shared ? 1e-2 : 1e-6); // transparent in the last channel only
  }
}

//------------------------------------------------------------------------------
// Half a range away, more than what the fewest of these terms tell apart.
TEST_P(TestAbsorbance, OpaqueFragmentsHideWhatIsBehind)
{
  const std::vector<float> visibilities = GetParam()({ { 0.2f, 1.0f }, { 0.8f, 0.5f } });
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

//------------------------------------------------------------------------------
// Whatever there is: many fragments, all at one place, all opaque, at the ends.
TEST_P(TestAbsorbance, IsANumberFromZeroToOne)
{
  std::vector<Absorbers> pixels;
  for (float alpha : { 0.0f, 1e-7f, 1e-3f, 0.5f, 0.999f, 1.0f })
  {
    for (int count : { 1, 2, 3, 10, 1000 })
    {
      for (float spread : { 0.0f, 1e-7f, 1e-3f, 1.0f })
      {
        Absorbers absorbers;
        for (int i = 0; i < count; ++i)
        {
          absorbers.push_back(
            { (1 - spread) * 0.37f + spread * static_cast<float>(i) / static_cast<float>(count), alpha });
        }
        pixels.push_back(absorbers);
        absorbers.back().Depth = 1;
        absorbers.front().Alpha = 1;
        pixels.push_back(absorbers);
      }
    }
  }
  for (const Absorbers& absorbers : pixels)
  {
    for (float visibility : GetParam()(absorbers))
    {
      ASSERT_TRUE(std::isfinite(visibility)) << absorbers.size() << " of " << absorbers.back().Alpha;
      ASSERT_GE(visibility, 0);
      ASSERT_LE(visibility, 1);
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbance, OrderChangesNothingButRounding)
{
  Absorbers absorbers = RandomAbsorbers(3, 20, 0.05f, 0.4f);
  const std::vector<float> before = GetParam()(absorbers);
  std::reverse(absorbers.begin(), absorbers.end());
  const std::vector<float> after = GetParam()(absorbers);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    // Nine bits for all channels are those of the one that absorbs most, here several times as much.
    EXPECT_NEAR(before[i], after[before.size() - 1 - i],
      GetParam().Shared   ? 2.5e-2
        : GetParam().Half ? 1e-2
                          : 1e-3)
      << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, TestAbsorbance, testing::ValuesIn(AbsorbanceVariants()), NameOf);
INSTANTIATE_TEST_SUITE_P(Variants, TestLinearAbsorbance,
  testing::ValuesIn(VariantsWhere(
    [](const AbsorbanceVariant& variant) { return variant.Technique != "Moment" && !IsRounded(variant); })),
  NameOf);

//------------------------------------------------------------------------------
// A Fourier series rings, and masses of trigonometric moments may lie where no depths are; what is told from the other
// sums never rises with depth, as fragments that hide nothing see.
class TestMonotoneAbsorbance : public TestAbsorbance
{
};

TEST_P(TestMonotoneAbsorbance, NothingFartherSeesMore)
{
  for (unsigned int seed = 0; seed < 50; ++seed)
  {
    Absorbers absorbers = RandomAbsorbers(seed, 1 + static_cast<int>(seed % 20), 0.05f, seed % 2 ? 0.3f : 1.0f);
    const std::size_t first = absorbers.size();
    constexpr int Probes = 200;
    for (int i = 0; i <= Probes; ++i)
    {
      absorbers.push_back({ static_cast<float>(i) / Probes, 0 });
    }
    const std::vector<float> visibilities = GetParam()(absorbers);
    for (std::size_t i = first + 1; i < absorbers.size(); ++i)
    {
      ASSERT_LE(visibilities[i], visibilities[i - 1] + (GetParam().Technique == "Moment" ? 1e-3 : 1e-6))
        << "seed " << seed << ", depth " << absorbers[i].Depth;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, TestMonotoneAbsorbance,
  testing::ValuesIn(VariantsWhere([](const AbsorbanceVariant& variant)
    { return variant.Technique != "Fourier" && !IsTrigonometric(variant) && !IsRounded(variant); })),
  NameOf);

//------------------------------------------------------------------------------
// No other distribution has the same moments: closed forms are the products of what lies in front.
TEST_P(TestMoments, FewLayersAreExact)
{
  const AbsorbanceVariant& variant = GetParam();
  const bool most = variant.Terms == 2 || variant.Terms == 5; // power-8, trigonometric-4
  double worst = 0;
  for (unsigned int seed = 0; seed < 300; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    Absorbers absorbers;
    const int count = 1 + static_cast<int>(seed) % LayersOfMoments(variant.Terms);
    for (int i = 0; i < count; ++i)
    {
      absorbers.push_back({ (static_cast<float>(i) + 0.2f + 0.6f * uniform(random)) / static_cast<float>(count),
        0.05f + 0.94f * uniform(random) });
    }
    const std::vector<float> visibilities = variant(absorbers);
    double exact = 1;
    for (int i = 0; i < count; ++i)
    {
      worst = std::max(worst, std::abs(visibilities[i] - exact));
      exact *= 1 - absorbers[i].Alpha;
    }
  }
  EXPECT_LT(worst, most ? 1e-3 : 1e-4);
}

//------------------------------------------------------------------------------
// The trap of these techniques: matrices of few fragments are singular. Each of two sees the share of the other that
// Overestimation says, and a lone one is not hidden at all (NothingHidesItself).
TEST_P(TestMoments, CoincidentFragmentsHideEachOtherAlike)
{
  for (float depth : { 0.0f, 0.1f, 0.5f, 0.73f, 1.0f })
  {
    for (float alpha : { 0.01f, 0.3f, 0.9f, 1.0f })
    {
      const std::vector<float> visibilities = GetParam()({ { depth, alpha }, { depth, alpha } });
      const double expected = std::exp(-0.25 * Absorbance({ depth, alpha }));
      EXPECT_NEAR(visibilities[0], expected, 1.0 / 255) << depth << ", " << alpha;
      EXPECT_NEAR(visibilities[1], expected, 1.0 / 255) << depth << ", " << alpha;
    }
  }
}

//------------------------------------------------------------------------------
// No distribution with the same moments can have less in front of a fragment, or more, than its bounds: the fragments
// themselves are such a distribution.
TEST_P(TestPowerMoments, BoundsHoldTheTruth)
{
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const Absorbers absorbers = RandomAbsorbers(seed, 2 + static_cast<int>(seed % 12), 0.1f, 0.8f);
    const std::vector<float> most = GetParam()(absorbers, 0);
    const std::vector<float> least = GetParam()(absorbers, 1);
    for (std::size_t i = 0; i < absorbers.size(); ++i)
    {
      double before = 1;
      double upTo = 1;
      for (std::size_t j = 0; j < absorbers.size(); ++j)
      {
        before *= j != i && absorbers[j].Depth < absorbers[i].Depth ? 1 - absorbers[j].Alpha : 1;
        upTo *= j != i && absorbers[j].Depth <= absorbers[i].Depth ? 1 - absorbers[j].Alpha : 1;
      }
      EXPECT_LE(before, most[i] + 2e-3) << "seed " << seed << ", fragment " << i;
      EXPECT_GE(upTo, least[i] - 2e-3) << "seed " << seed << ", fragment " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, TestMoments,
  testing::ValuesIn(VariantsWhere(
    [](const AbsorbanceVariant& variant) { return variant.Technique == "Moment" && !IsRounded(variant); })),
  NameOf);
INSTANTIATE_TEST_SUITE_P(Variants, TestPowerMoments,
  testing::ValuesIn(VariantsWhere([](const AbsorbanceVariant& variant)
    { return variant.Technique == "Moment" && !IsTrigonometric(variant) && !IsRounded(variant); })),
  NameOf);

//------------------------------------------------------------------------------
// More terms come nearer to the truth: mean distance from the exact visibility over many pixels.
TEST(TestAbsorbanceOf, MoreTermsIsNearerToExact)
{
  for (const std::string technique : { "Fourier", "Slices", "Wavelet" })
  {
    double last = 1;
    for (const AbsorbanceVariant& variant : AbsorbanceVariants())
    {
      if (variant.Technique != technique || variant.Channels != 1 || IsRounded(variant))
      {
        continue;
      }
      double sum = 0;
      constexpr int Pixels = 100;
      constexpr int Count = 12;
      for (unsigned int seed = 0; seed < Pixels; ++seed)
      {
        const Absorbers absorbers = RandomAbsorbers(seed, Count, 0.1f, 0.6f);
        const std::vector<float> visibilities = variant(absorbers);
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
      const std::vector<float> visibilities = variant({ { 0, 0.4f }, { 0.6f, 0.3f }, { 1, 0.7f } });
      const double rounding = IsRounded(variant) ? 1e-3 : 1e-6;
      EXPECT_NEAR(visibilities[0], 1, rounding) << variant.Terms;
      EXPECT_NEAR(visibilities[2], 0.6 * 0.7, rounding) << variant.Terms;
    }
  }
}
