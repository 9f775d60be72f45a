// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The reference against what can be computed by hand, and against itself: its three ways to a colour have to meet where
// the paper says that they do.
#include "Reference.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <random>

using namespace Reference;

namespace
{
constexpr double Rounding = 1e-12;

rc::Gen<std::vector<Fragment>> Fragments()
{
  // Few depths, so that equal ones are common.
  const auto depth = rc::gen::map(rc::gen::inRange(0, 32), [](int i) { return i / 32.0; });
  const auto unit = rc::gen::map(rc::gen::inRange(0, 1001), [](int i) { return i / 1000.0; });
  return rc::gen::container<std::vector<Fragment>>(rc::gen::apply(
    [](double z, double r, double g, double b, double a) {
      return Fragment{ z, { { r, g, b } }, a };
    },
    depth, unit, unit, unit, unit));
}

void ExpectNear(const Pixel& a, const Pixel& b)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    RC_ASSERT(std::abs(a.Rgb[c] - b.Rgb[c]) < Rounding);
  }
  RC_ASSERT(std::abs(a.Transmittance - b.Transmittance) < Rounding);
}

/// Root of the mean square over all channels of random pixels: 64 fragments each, uniform in depth, colour and opacity.
double WorstCase(int nodeCount, Removal removal, bool corrected)
{
  constexpr int Pixels = 4000;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_real_distribution<double> opacity(0.02, 0.3);
  double squares = 0;
  for (int i = 0; i < Pixels; ++i)
  {
    std::vector<Fragment> fragments(64);
    for (Fragment& fragment : fragments)
    {
      fragment = { unit(random), { { unit(random), unit(random), unit(random) } }, opacity(random) };
    }
    const Pixel exact = CompositeExact(fragments);
    const Pixel adaptive = CompositeAdaptive(fragments, nodeCount, removal, corrected);
    for (std::size_t c = 0; c < 3; ++c)
    {
      squares += std::pow(adaptive.Rgb[c] - exact.Rgb[c], 2);
    }
  }
  return std::sqrt(squares / (3 * Pixels));
}
}

//------------------------------------------------------------------------------
TEST(Reference, BlendsTwoByHand)
{
  const Fragment red{ 0.25, { { 1, 0, 0 } }, 0.5 };
  const Fragment blue{ 0.75, { { 0, 0, 1 } }, 0.25 };
  for (const std::vector<Fragment>& drawn : { std::vector<Fragment>{ red, blue }, { blue, red } })
  {
    for (const Pixel& pixel :
      { CompositeExact(drawn), CompositeIterative(drawn), CompositeAdaptive(drawn, 2, Removal::Underestimate) })
    {
      EXPECT_DOUBLE_EQ(pixel.Rgb[0], 0.5);
      EXPECT_DOUBLE_EQ(pixel.Rgb[1], 0);
      EXPECT_DOUBLE_EQ(pixel.Rgb[2], 0.125);
      EXPECT_DOUBLE_EQ(pixel.Transmittance, 0.375);
    }
  }
}

//------------------------------------------------------------------------------
TEST(Reference, PutsTheLaterDrawnInFrontAtEqualDepth)
{
  const std::vector<Fragment> drawn = { { 0.5, { { 1, 0, 0 } }, 0.5 }, { 0.5, { { 0, 1, 0 } }, 0.5 } };
  for (const Pixel& pixel :
    { CompositeExact(drawn), CompositeIterative(drawn), CompositeAdaptive(drawn, 2, Removal::Underestimate) })
  {
    EXPECT_DOUBLE_EQ(pixel.Rgb[0], 0.25);
    EXPECT_DOUBLE_EQ(pixel.Rgb[1], 0.5);
  }
}

//------------------------------------------------------------------------------
TEST(Reference, RemovesByHand)
{
  // Four nodes of opacity one half, room for three.
  const auto nodesLeft = [](Removal rule, std::array<double, 4> depths)
  {
    VisibilityFunction visibility(3, rule);
    for (double depth : depths)
    {
      visibility.Insert(depth, 0.5);
    }
    return visibility.GetNodes();
  };
  // Steps of 1/4, 1/8, 1/16 move forward by 0.1, 0.4, 0.2: the last loses least, and the one before it is lowered.
  const std::vector<Node> under = nodesLeft(Removal::Underestimate, { { 0.05, 0.15, 0.55, 0.75 } });
  ASSERT_EQ(under.size(), 3u);
  EXPECT_EQ(under[2].Depth, 0.55);
  EXPECT_EQ(under[2].Transmittance, 1.0 / 16);

  // Steps of 1/2, 1/4, 1/8 move back by 0.05, 0.45, 0.4: the first loses least.
  const std::array<double, 4> closeInFront{ { 0.05, 0.1, 0.55, 0.95 } };
  const std::vector<Node> over = nodesLeft(Removal::Overestimate, closeInFront);
  ASSERT_EQ(over.size(), 3u);
  EXPECT_EQ(over[0].Depth, 0.1);
  EXPECT_EQ(over[0].Transmittance, 1.0 / 4);

  // Of both, moving the second step forward, 1/4 * 0.05, loses least.
  const std::vector<Node> mixed = nodesLeft(Removal::Mixed, closeInFront);
  ASSERT_EQ(mixed.size(), 3u);
  EXPECT_EQ(mixed[0].Depth, 0.05);
  EXPECT_EQ(mixed[0].Transmittance, 1.0 / 4);
}

//------------------------------------------------------------------------------
TEST(Reference, IterativeIsRecursive)
{
  EXPECT_TRUE(rc::check("Eq. 2 gives what Eq. 3 gives",
    []
    {
      const std::vector<Fragment> drawn = *Fragments();
      ExpectNear(CompositeIterative(drawn), CompositeExact(drawn));
    }));
}

//------------------------------------------------------------------------------
TEST(Reference, AdaptiveIsExactWithEnoughNodes)
{
  EXPECT_TRUE(rc::check("as many nodes as fragments lose nothing",
    []
    {
      const std::vector<Fragment> drawn = *Fragments();
      const int nodes = std::max(1, static_cast<int>(drawn.size()));
      const auto rule = static_cast<Removal>(*rc::gen::inRange(0, 3));
      ExpectNear(CompositeAdaptive(drawn, nodes, rule), CompositeExact(drawn));
    }));
}

//------------------------------------------------------------------------------
struct WorstCaseBound
{
  int NodeCount;
  Removal Rule;
  double Paper; // without correction
  double Corrected;
};

class TestWorstCase : public testing::TestWithParam<WorstCaseBound>
{
};

TEST_P(TestWorstCase, StaysWithinItsBound)
{
  for (const auto& [corrected, bound] : { std::pair(false, GetParam().Paper), std::pair(true, GetParam().Corrected) })
  {
    const double rmse = WorstCase(GetParam().NodeCount, GetParam().Rule, corrected);
    RecordProperty(corrected ? "corrected" : "paper", std::to_string(rmse));
    EXPECT_LE(rmse, bound);
    EXPECT_GE(rmse, 0.5 * bound) << "the bound is so wide that it says nothing";
  }
}

INSTANTIATE_TEST_SUITE_P(Reference, TestWorstCase,
  testing::Values(WorstCaseBound{ 4, Removal::Underestimate, 0.21, 0.024 },
    WorstCaseBound{ 8, Removal::Underestimate, 0.085, 0.008 },
    WorstCaseBound{ 16, Removal::Underestimate, 0.025, 0.0017 },
    WorstCaseBound{ 32, Removal::Underestimate, 0.006, 0.0001 },
    WorstCaseBound{ 4, Removal::Overestimate, 0.44, 0.041 }, WorstCaseBound{ 8, Removal::Overestimate, 0.14, 0.0195 },
    WorstCaseBound{ 16, Removal::Overestimate, 0.037, 0.0061 },
    WorstCaseBound{ 32, Removal::Overestimate, 0.0048, 0.00045 }, WorstCaseBound{ 4, Removal::Mixed, 0.085, 0.032 },
    WorstCaseBound{ 8, Removal::Mixed, 0.034, 0.0145 }, WorstCaseBound{ 16, Removal::Mixed, 0.012, 0.0035 },
    WorstCaseBound{ 32, Removal::Mixed, 0.0026, 0.0002 }));
