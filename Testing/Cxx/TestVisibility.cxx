// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The visibility function of adaptive transparency: the shaders' own text on the CPU, against the reference and against
// what the paper says must hold. Runs under AddressSanitizer and UndefinedBehaviorSanitizer.
#include "Reference.h"
#include "VisibilityShader.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>

using namespace Reference;

namespace
{
/// Single precision against double, over some dozens of products.
constexpr double Rounding = 1e-5;

struct Step
{
  float Depth;
  float Alpha;
};

void showValue(const Step& step, std::ostream& os)
{
  os << "{" << step.Depth << ", " << step.Alpha << "}";
}

/// Any steps, equal depths rare.
rc::Gen<std::vector<Step>> Steps()
{
  const auto unit = rc::gen::map(rc::gen::inRange(0, 1 << 20), [](int i) { return static_cast<float>(i) / (1 << 20); });
  return rc::gen::container<std::vector<Step>>(rc::gen::apply(
    [](float z, float a) {
      return Step{ z, a };
    },
    unit, unit));
}

/// Steps whose depths, transmittances and areas are all exact in single precision, so that ties, of depths and of
/// areas, are common and are ties in the shader as in the reference. Widened areas have 8 bits more: fewer steps.
rc::Gen<std::vector<Step>> ExactSteps(const VisibilityVariant& variant)
{
  const std::size_t most = variant.Corrected ? 12 : 19;
  const auto depth = rc::gen::map(rc::gen::inRange(0, 16), [](int i) { return static_cast<float>(i) / 16; });
  const auto alpha = rc::gen::element(0.0f, 0.5f, 0.5f, 0.5f);
  return rc::gen::resize(static_cast<int>(most),
    rc::gen::container<std::vector<Step>>(rc::gen::apply(
      [](float z, float a) {
        return Step{ z, a };
      },
      depth, alpha)));
}

std::vector<Step> RandomSteps(std::mt19937& random, std::size_t count)
{
  std::uniform_real_distribution<float> unit(0, 1);
  std::uniform_real_distribution<float> opacity(0.02f, 0.3f);
  std::vector<Step> steps(count);
  for (Step& step : steps)
  {
    step = { unit(random), opacity(random) };
  }
  return steps;
}

bool NearerThan(const Step& a, const Step& b)
{
  return a.Depth < b.Depth;
}

bool AtEqualDepth(const Step& a, const Step& b)
{
  return a.Depth == b.Depth;
}

/// The integral of |a - b| between the nearest and the farthest of their depths, and behind all of them the height.
double AreaBetween(const std::vector<Node>& a, const std::vector<Node>& b)
{
  std::map<double, std::pair<double, double>> steps;
  const auto at = [](const std::vector<Node>& nodes, double z)
  {
    double t = 1;
    for (const Node& node : nodes)
    {
      t = node.Depth <= z ? node.Transmittance : t;
    }
    return t;
  };
  for (const auto* nodes : { &a, &b })
  {
    for (const Node& node : *nodes)
    {
      steps[node.Depth] = { at(a, node.Depth), at(b, node.Depth) };
    }
  }
  double area = 0;
  for (auto step = steps.begin(); step != steps.end(); ++step)
  {
    const auto next = std::next(step);
    const double width = next == steps.end() ? 0 : next->first - step->first;
    area += width * std::abs(step->second.first - step->second.second);
  }
  return area;
}

double Product(const std::vector<Step>& steps)
{
  double product = 1;
  for (const Step& step : steps)
  {
    product *= 1 - static_cast<double>(step.Alpha);
  }
  return product;
}

/// What each fragment, in the order of insertion, is weighted with.
std::vector<double> Weights(const VisibilityVariant& variant, const std::vector<Step>& steps)
{
  const auto shader = variant.New();
  for (const Step& step : steps)
  {
    shader->Insert(step.Depth, step.Alpha);
  }
  std::vector<double> weights;
  for (const Step& step : steps)
  {
    weights.push_back(shader->TransmittanceBefore(step.Depth));
  }
  return weights;
}

/// The same with alpha correction, not scaled.
std::vector<double> CorrectedWeights(const VisibilityVariant& variant, const std::vector<Step>& steps)
{
  const auto shader = variant.New();
  for (const Step& step : steps)
  {
    shader->Insert(step.Depth, step.Alpha);
  }
  std::vector<double> weights;
  for (const Step& step : steps)
  {
    weights.push_back(shader->VisibilityAt(step.Depth, step.Alpha));
  }
  return weights;
}

VisibilityFunction ReferenceOf(const VisibilityVariant& variant)
{
  return VisibilityFunction(variant.NodeCount, variant.Rule, variant.Corrected);
}

std::vector<double> ReferenceWeights(VisibilityFunction visibility, const std::vector<Step>& steps)
{
  for (const Step& step : steps)
  {
    visibility.Insert(step.Depth, step.Alpha);
  }
  std::vector<double> weights;
  for (const Step& step : steps)
  {
    weights.push_back(visibility.BeforeNext(step.Depth));
  }
  return weights;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}
}

class TestVisibility : public testing::TestWithParam<VisibilityVariant>
{
protected:
  static std::vector<VisibilityVariant> Variants(bool corrected)
  {
    std::vector<VisibilityVariant> variants;
    std::copy_if(VisibilityVariants().begin(), VisibilityVariants().end(), std::back_inserter(variants),
      [corrected](const VisibilityVariant& variant) { return variant.Corrected == corrected; });
    return variants;
  }
};

/// As in the paper.
class TestPaperVisibility : public TestVisibility
{
public:
  static std::vector<VisibilityVariant> Variants() { return TestVisibility::Variants(false); }
};

/// With alpha correction.
class TestCorrectedVisibility : public TestVisibility
{
public:
  static std::vector<VisibilityVariant> Variants() { return TestVisibility::Variants(true); }
};

//------------------------------------------------------------------------------
TEST_P(TestVisibility, IsAStepFunctionBetweenOneAndZero)
{
  EXPECT_TRUE(rc::check("front to back, falling, within [0, 1]",
    []
    {
      const auto shader = GetParam().New();
      for (const Step& step : *Steps())
      {
        shader->Insert(step.Depth, step.Alpha);
        const std::vector<Node> nodes = shader->GetNodes();
        Node before{ 0, 1 };
        for (const Node& node : nodes)
        {
          RC_ASSERT(node.Depth >= before.Depth);
          RC_ASSERT(node.Transmittance <= before.Transmittance);
          RC_ASSERT(node.Transmittance >= 0);
          before = node;
        }
      }
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, RemovesWhatTheReferenceRemoves)
{
  EXPECT_TRUE(rc::check("the same nodes, where single precision is exact",
    []
    {
      const auto shader = GetParam().New();
      VisibilityFunction reference = ReferenceOf(GetParam());
      for (const Step& step : *ExactSteps(GetParam()))
      {
        shader->Insert(step.Depth, step.Alpha);
        reference.Insert(step.Depth, step.Alpha);
        const std::vector<Node> nodes = shader->GetNodes();
        RC_ASSERT(nodes.size() == reference.GetNodes().size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          RC_ASSERT(nodes[i].Depth == reference.GetNodes()[i].Depth);
          RC_ASSERT(nodes[i].Transmittance == reference.GetNodes()[i].Transmittance);
        }
      }
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestPaperVisibility, LosesTheLeastArea)
{
  EXPECT_TRUE(rc::check("no more area than the reference loses from the same nodes",
    []
    {
      const auto shader = GetParam().New();
      for (const Step& step : *Steps())
      {
        VisibilityFunction full(GetParam().NodeCount + 1, GetParam().Rule, GetParam().Corrected, shader->GetNodes());
        VisibilityFunction reference(GetParam().NodeCount, GetParam().Rule, GetParam().Corrected, shader->GetNodes());
        full.Insert(step.Depth, step.Alpha);
        reference.Insert(step.Depth, step.Alpha);
        shader->Insert(step.Depth, step.Alpha);
        RC_ASSERT(shader->GetNodes().size() == reference.GetNodes().size());
        RC_ASSERT(AreaBetween(full.GetNodes(), shader->GetNodes()) <=
          AreaBetween(full.GetNodes(), reference.GetNodes()) + Rounding);
      }
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, WeighsAsTheReferenceDoes)
{
  // Equal depths are IsExactWithEnoughNodes' matter: once nodes go, which fragment of a depth still has one is
  // arbitrary.
  EXPECT_TRUE(rc::check("the same weights, where single precision is exact",
    []
    {
      std::vector<Step> steps = *ExactSteps(GetParam());
      std::stable_sort(steps.begin(), steps.end(), NearerThan);
      steps.erase(std::unique(steps.begin(), steps.end(), AtEqualDepth), steps.end());
      std::shuffle(steps.begin(), steps.end(), std::mt19937(*rc::gen::arbitrary<unsigned int>()));
      RC_ASSERT(Weights(GetParam(), steps) == ReferenceWeights(ReferenceOf(GetParam()), steps));
    }));
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i)
  {
    const std::vector<Step> steps = RandomSteps(random, 96);
    EXPECT_LT(
      LargestDifference(Weights(GetParam(), steps), ReferenceWeights(ReferenceOf(GetParam()), steps)), Rounding);
  }
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, IsExactWithEnoughNodes)
{
  EXPECT_TRUE(rc::check("no more fragments than nodes: nothing is lost, equal depths neither",
    []
    {
      std::vector<Step> steps = *rc::gen::oneOf(Steps(), ExactSteps(GetParam()));
      steps.resize(std::min<std::size_t>(steps.size(), static_cast<std::size_t>(GetParam().NodeCount)));
      const std::vector<double> weights = Weights(GetParam(), steps);
      for (std::size_t i = 0; i < steps.size(); ++i)
      {
        double inFront = 1;
        for (std::size_t j = 0; j < steps.size(); ++j)
        {
          const bool before = steps[j].Depth < steps[i].Depth || (steps[j].Depth == steps[i].Depth && j < i);
          inFront *= before ? 1 - static_cast<double>(steps[j].Alpha) : 1;
        }
        RC_ASSERT(std::abs(weights[i] - inFront) < Rounding);
      }
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, KnowsOfEqualDepthsWhoseNodesWent)
{
  const float alpha = 0.01f;
  std::vector<Step> steps{ { 0.125f, alpha }, { 0.125f, alpha } };
  for (int i = 1; i < GetParam().NodeCount; ++i) // one fragment too many; the two together lose least
  {
    steps.push_back({ 0.25f + 0.5f * static_cast<float>(i) / static_cast<float>(GetParam().NodeCount), 0.02f });
  }
  const std::vector<double> weights = Weights(GetParam(), steps);
  EXPECT_NEAR(weights[0], 1, Rounding);
  EXPECT_LE(weights[1], 1 - alpha + Rounding);
  EXPECT_GE(weights[1], (1 - alpha) * (1 - alpha) - Rounding);
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, KeepsTheTotal)
{
  // The paper promises it of Underestimate; the others keep it because they never drop the last node.
  EXPECT_TRUE(rc::check("the last node is the product of all",
    []
    {
      const std::vector<Step> steps = *Steps();
      const auto shader = GetParam().New();
      for (const Step& step : steps)
      {
        shader->Insert(step.Depth, step.Alpha);
      }
      RC_ASSERT(std::abs(shader->GetTotal() - Product(steps)) < Rounding);
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, LosesNothingToFragmentsThatDontCoverTheSample)
{
  EXPECT_TRUE(rc::check("the nodes and the estimate are those without them, bit for bit",
    []
    {
      const auto with = GetParam().New();
      const auto without = GetParam().New();
      for (const Step& step : *rc::gen::resize(200, Steps()))
      {
        with->InsertUncovered();
        with->Insert(step.Depth, step.Alpha);
        without->Insert(step.Depth, step.Alpha);
      }
      with->InsertUncovered();
      const std::vector<Node> nodes = with->GetNodes();
      const std::vector<Node> expected = without->GetNodes();
      RC_ASSERT(nodes.size() == expected.size());
      RC_ASSERT(std::equal(nodes.begin(), nodes.end(), expected.begin(),
        [](const Node& a, const Node& b) { return a.Depth == b.Depth && a.Transmittance == b.Transmittance; }));
      RC_ASSERT(with->GetEstimate() == without->GetEstimate());
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestCorrectedVisibility, ChangesNothingWhileAllFragmentsHaveNodes)
{
  EXPECT_TRUE(rc::check("bit for bit",
    []
    {
      std::vector<Step> steps = *rc::gen::oneOf(Steps(), ExactSteps(GetParam()));
      steps.resize(std::min<std::size_t>(steps.size(), static_cast<std::size_t>(GetParam().NodeCount)));
      RC_ASSERT(CorrectedWeights(GetParam(), steps) == Weights(GetParam(), steps));
      const auto shader = GetParam().New();
      RC_ASSERT(shader->GetCorrected(0.3f, 0.1f) == 0.3f);
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestCorrectedVisibility, AddsUpToWhatIsHidden)
{
  EXPECT_TRUE(rc::check("fragments of one colour",
    []
    {
      const std::vector<Step> steps = *Steps();
      const auto shader = GetParam().New();
      double hidden = 1;
      for (const Step& step : steps)
      {
        shader->Insert(step.Depth, step.Alpha);
        hidden *= 1 - static_cast<double>(step.Alpha);
      }
      float weights = 0;
      for (const Step& step : steps)
      {
        weights += shader->VisibilityAt(step.Depth, step.Alpha) * step.Alpha;
      }
      RC_ASSERT(std::abs(shader->GetCorrected(weights, weights) - (1 - hidden)) < Rounding);
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestCorrectedVisibility, NeverRisesWithDepth)
{
  EXPECT_TRUE(rc::check("for fragments of one opacity, and between 1 and what all let through",
    []
    {
      const auto shader = GetParam().New();
      for (const Step& step : *Steps())
      {
        shader->Insert(step.Depth, step.Alpha);
      }
      const std::vector<Step> asked = *Steps();
      RC_PRE(!asked.empty());
      std::vector<float> depths;
      for (const Step& step : asked)
      {
        depths.push_back(step.Depth);
      }
      for (const Node& node : shader->GetNodes())
      {
        depths.push_back(static_cast<float>(node.Depth));
      }
      std::sort(depths.begin(), depths.end());
      depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
      double before = 1;
      for (float depth : depths)
      {
        const double visibility = shader->VisibilityAt(depth, asked.front().Alpha);
        RC_ASSERT(visibility <= before);
        RC_ASSERT(visibility >= shader->GetTotal());
        before = visibility;
      }
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestCorrectedVisibility, IsThatOfTheReference)
{
  std::mt19937 random(13);
  for (int i = 0; i < 50; ++i)
  {
    const std::vector<Step> steps = RandomSteps(random, 96);
    VisibilityFunction reference = ReferenceOf(GetParam());
    for (const Step& step : steps)
    {
      reference.Insert(step.Depth, step.Alpha);
    }
    const bool byMeans = GetParam().Rule == Removal::Underestimate && GetParam().NodeCount < 96;
    std::vector<double> expected;
    for (const Step& step : steps)
    {
      expected.push_back(byMeans ? reference.MeanBeforeNext(step.Depth, step.Alpha) : reference.BeforeNext(step.Depth));
    }
    EXPECT_LT(LargestDifference(CorrectedWeights(GetParam(), steps), expected), Rounding);
  }
}

//------------------------------------------------------------------------------
TEST_P(TestCorrectedVisibility, HidesNothingMore)
{
  EXPECT_TRUE(rc::check("before it is scaled, each fragment is seen as well as without, coincident ones, too",
    []
    {
      const std::vector<Step> steps = *rc::gen::oneOf(Steps(), ExactSteps(GetParam()));
      const std::vector<double> corrected = CorrectedWeights(GetParam(), steps);
      const std::vector<double> paper = Weights(GetParam(), steps);
      for (std::size_t i = 0; i < steps.size(); ++i)
      {
        RC_ASSERT(corrected[i] >= paper[i] - Rounding);
      }
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, EstimatesItsErrorAsTheReferenceDoes)
{
  EXPECT_TRUE(rc::check("the same estimate, where single precision is exact; 0 if nothing was removed",
    []
    {
      const auto shader = GetParam().New();
      VisibilityFunction reference = ReferenceOf(GetParam());
      int count = 0;
      for (const Step& step : *ExactSteps(GetParam()))
      {
        shader->Insert(step.Depth, step.Alpha);
        reference.Insert(step.Depth, step.Alpha);
        ++count;
        RC_ASSERT(std::abs(shader->GetEstimate() - reference.EstimateError()) < Rounding);
        RC_ASSERT(count > GetParam().NodeCount || shader->GetEstimate() == 0);
      }
    }));
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i)
  {
    const auto shader = GetParam().New();
    VisibilityFunction reference = ReferenceOf(GetParam());
    for (const Step& step : RandomSteps(random, 96))
    {
      shader->Insert(step.Depth, step.Alpha);
      reference.Insert(step.Depth, step.Alpha);
    }
    EXPECT_NEAR(shader->GetEstimate(), reference.EstimateError(), Rounding);
    EXPECT_GT(shader->GetEstimate(), 0);
  }
}

//------------------------------------------------------------------------------
TEST_P(TestVisibility, EstimatesNoLessThanItsMeanError)
{
  EXPECT_TRUE(rc::check("of transmittance between the nearest and the farthest fragment",
    []
    {
      const std::vector<Step> steps = *Steps();
      const auto shader = GetParam().New();
      VisibilityFunction exact(static_cast<int>(steps.size()) + 1, GetParam().Rule);
      for (const Step& step : steps)
      {
        shader->Insert(step.Depth, step.Alpha);
        exact.Insert(step.Depth, step.Alpha);
      }
      RC_PRE(!steps.empty());
      const auto [nearest, farthest] = std::minmax_element(steps.begin(), steps.end(), NearerThan);
      RC_PRE(nearest->Depth < farthest->Depth);
      const double mean = AreaBetween(shader->GetNodes(), exact.GetNodes()) / (farthest->Depth - nearest->Depth);
      RC_ASSERT(shader->GetEstimate() >= mean - Rounding);
    }));
}

INSTANTIATE_TEST_SUITE_P(Shader, TestVisibility, testing::ValuesIn(VisibilityVariants()),
  [](const auto& info) { return info.param.GetName(); });
INSTANTIATE_TEST_SUITE_P(Shader, TestPaperVisibility, testing::ValuesIn(TestPaperVisibility::Variants()),
  [](const auto& info) { return info.param.GetName(); });
INSTANTIATE_TEST_SUITE_P(Shader, TestCorrectedVisibility, testing::ValuesIn(TestCorrectedVisibility::Variants()),
  [](const auto& info) { return info.param.GetName(); });

//------------------------------------------------------------------------------
// How far weights are from the truth, and from those of the same fragments drawn in another order: both shrink with
// each node more, which is what makes the method order-independent in practice (section 5.1).
class TestVisibilityOfManyNodes : public testing::TestWithParam<Removal>
{
protected:
  struct Error
  {
    double FromExact = 0;
    double FromOtherOrder = 0;
  };

  static Error Measure(const VisibilityVariant& variant)
  {
    constexpr int Trials = 200;
    constexpr std::size_t Count = 64;
    std::mt19937 random(11);
    Error error;
    for (int i = 0; i < Trials; ++i)
    {
      const std::vector<Step> steps = RandomSteps(random, Count);
      std::vector<Step> reversed(steps.rbegin(), steps.rend());
      std::vector<double> other = Weights(variant, reversed);
      std::reverse(other.begin(), other.end());
      const std::vector<double> weights = Weights(variant, steps);
      const std::vector<double> exact = ReferenceWeights(VisibilityFunction(Count, variant.Rule), steps);
      for (std::size_t k = 0; k < Count; ++k)
      {
        error.FromExact += std::pow(weights[k] - exact[k], 2) / (Count * Trials);
        error.FromOtherOrder += std::pow(weights[k] - other[k], 2) / (Count * Trials);
      }
    }
    return { std::sqrt(error.FromExact), std::sqrt(error.FromOtherOrder) };
  }
};

TEST_P(TestVisibilityOfManyNodes, ComesCloserToExactAndToEveryOrder)
{
  Error last{ 1, 1 };
  int lastCount = 0;
  for (const VisibilityVariant& variant : VisibilityVariants())
  {
    if (!variant.Corrected || variant.Rule != GetParam() || variant.NodeCount < 2 * lastCount)
    {
      continue;
    }
    const Error error = Measure(variant);
    RecordProperty(variant.GetName(),
      std::to_string(error.FromExact) + " from exact, " + std::to_string(error.FromOtherOrder) +
        " from the other order");
    EXPECT_LE(error.FromExact, last.FromExact) << variant.GetName();
    if (variant.NodeCount >= 4)
    {
      EXPECT_LE(error.FromOtherOrder, last.FromOtherOrder) << variant.GetName();
      last.FromOtherOrder = error.FromOtherOrder;
    }
    last.FromExact = error.FromExact;
    lastCount = variant.NodeCount;
  }
  EXPECT_GE(lastCount, 64);
  EXPECT_LT(last.FromExact, Rounding);
  EXPECT_LT(last.FromOtherOrder, Rounding);
}

INSTANTIATE_TEST_SUITE_P(
  Shader, TestVisibilityOfManyNodes, testing::Values(Removal::Underestimate, Removal::Overestimate, Removal::Mixed));
