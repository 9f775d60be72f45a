// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility from sums of absorbance: the shaders' own text on the CPU, against the reference in double precision and
// against what theory says.
#include "AbsorbanceShader.h"
#include "MomentBounds.h"
#include "Reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
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
using TestMomentBounds = TestAbsorbance;

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
  const Reference::Visibilities reference = Reference::VisibilitiesOf(
    [share, terms = GetParam().Terms](double at, double before) { return share(terms, at, before); });
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const Absorbers absorbers = RandomAbsorbers(seed, 1 + static_cast<int>(seed % 40), 0.01f, seed % 2 ? 0.3f : 1.0f);
    std::vector<double> depths;
    std::vector<double> alphas;
    for (const Absorber& absorber : absorbers)
    {
      depths.push_back(absorber.Depth);
      alphas.push_back(absorber.Alpha);
    }
    const std::vector<float> visibilities = GetParam()(absorbers);
    const std::vector<double> expected = reference(depths, alphas);
    for (std::size_t i = 0; i < absorbers.size(); ++i)
    {
      EXPECT_NEAR(visibilities[i], expected[i], 1e-4) << "seed " << seed << ", fragment " << i;
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
// A Fourier series rings, and trigonometric moments give no strict bounds; what is told from the other sums never
// rises with depth, as fragments that hide nothing see.
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

//------------------------------------------------------------------------------
// What power moments are mixed with: a share of a distribution that has mass all over (Muenstermann et al. 2018, the
// supplement's moments of it). Without it few fragments leave no freedom, and a solver that rounds finds nothing.
struct Mixture
{
  double Share;
  std::vector<double> Moments;
};

Mixture MixtureOf(int moments)
{
  return moments == 0 ? Mixture{ 5e-7, { 1, 0, 0.375, 0, 0.375 } }
    : moments == 1    ? Mixture{ 5e-6, { 1, 0, 0.48, 0, 0.451, 0, 0.45 } }
                      : Mixture{ 5e-5, { 1, 0, 0.75, 0, 0.67666667, 0, 0.63, 0, 0.6003003 } };
}

/// A pixel of 2 to 12 fragments all over, in the middle fifth, or near both ends, and of some that hide nothing, and
/// only see: in the middle, near an end, and at both.
Absorbers RandomPixel(unsigned int seed)
{
  Absorbers absorbers = RandomAbsorbers(seed, 2 + static_cast<int>(seed % 11), 0.1f, 0.7f);
  const unsigned int place = seed / 11 % 3;
  bool atFarEnd = false;
  for (Absorber& absorber : absorbers)
  {
    absorber.Depth = place == 0 ? absorber.Depth
      : place == 1              ? 0.4f + 0.2f * absorber.Depth
      : atFarEnd                ? 1 - 0.1f * absorber.Depth
                                : 0.1f * absorber.Depth;
    atFarEnd = !atFarEnd;
  }
  for (float depth : { 0.0f, 0.02f, 0.5f, 0.77f, 1.0f })
  {
    absorbers.push_back({ depth, 0 });
  }
  return absorbers;
}

// Of what others absorb, the share in front of a fragment, by the text and by linear programs of the same moments. What
// differs:
// - The text's moments are rounded. How far that moves a bound, the program's slopes say. Sums are rounded by no more
// than
//   TERM_ROUNDING; what the text computes from them is, too: up to 4 times that was seen with 8 moments, less than once
//   with 4 and 6, and 8 times is allowed. So half of all are compared to 9e-6 (4 moments) to 2e-4 (8), and none more
//   loosely than to 0.03: where a fragment is so near to another one that 32 bits hardly tell them apart.
// - Masses as small as the mixture's share are found to some digit. The least of them are less than 2e-6, to which a
// share
//   can be told from visibility.
// - Programs are exact to 1e-7.
TEST_P(TestMomentBounds, AreThoseOfLinearPrograms)
{
  const Mixture mixture = MixtureOf(GetParam().Terms);
  const double rounding = std::ldexp(1.0, -22);
  std::vector<double> tolerances;
  for (unsigned int seed = 0; seed < 33; ++seed)
  {
    const Absorbers absorbers = RandomPixel(seed);
    const std::vector<float> leastHidden = GetParam()(absorbers, 0);
    const std::vector<float> mostHidden = GetParam()(absorbers, 1);
    for (std::size_t i = 0; i < absorbers.size(); ++i)
    {
      double others = 0;
      std::vector<double> moments(mixture.Moments.size());
      std::vector<double> depths;
      for (std::size_t j = 0; j < absorbers.size(); ++j)
      {
        if (j != i && absorbers[j].Alpha > 0)
        {
          depths.push_back(2.0 * absorbers[j].Depth - 1);
          others += Absorbance(absorbers[j]);
          for (std::size_t k = 0; k < moments.size(); ++k)
          {
            moments[k] += Absorbance(absorbers[j]) * std::pow(depths.back(), k);
          }
        }
      }
      const double relativeRounding = rounding * (others + Absorbance(absorbers[i])) / others;
      const double mixed = std::max(relativeRounding, mixture.Share);
      for (std::size_t k = 0; k < moments.size(); ++k)
      {
        moments[k] = (1 - mixed) * moments[k] / others + mixed * mixture.Moments[k];
      }
      const auto compare = [&](const MomentBound& bound, float visibility)
      {
        const double moved = std::accumulate(bound.Slopes.begin(), bound.Slopes.end(), 0.0,
          [](double sum, double slope) { return sum + std::abs(slope); });
        const double tolerance = std::min(8 * relativeRounding * moved + 0.2 * mixture.Share + 2e-6, 0.03);
        EXPECT_NEAR(-std::log(visibility) / others, bound.Mass, tolerance) << "seed " << seed << ", fragment " << i;
        tolerances.push_back(tolerance);
      };
      const double depth = 2.0 * absorbers[i].Depth - 1;
      compare(LeastInFront(moments, depths, depth), leastHidden[i]);
      compare(MostUpTo(moments, depths, depth), mostHidden[i]);
    }
  }
  const auto median = tolerances.begin() + static_cast<std::ptrdiff_t>(tolerances.size() / 2);
  std::nth_element(tolerances.begin(), median, tolerances.end());
  EXPECT_LT(*median, 2e-4) << "most are compared too loosely to tell anything";
}

INSTANTIATE_TEST_SUITE_P(Variants, TestMoments,
  testing::ValuesIn(VariantsWhere(
    [](const AbsorbanceVariant& variant) { return variant.Technique == "Moment" && !IsRounded(variant); })),
  NameOf);
INSTANTIATE_TEST_SUITE_P(Variants, TestPowerMoments,
  testing::ValuesIn(VariantsWhere([](const AbsorbanceVariant& variant)
    { return variant.Technique == "Moment" && !IsTrigonometric(variant) && !IsRounded(variant); })),
  NameOf);
INSTANTIATE_TEST_SUITE_P(Variants, TestMomentBounds,
  testing::ValuesIn(VariantsWhere([](const AbsorbanceVariant& variant)
    { return variant.Technique == "Moment" && !IsTrigonometric(variant) && !variant.Half && variant.Channels == 1; })),
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
