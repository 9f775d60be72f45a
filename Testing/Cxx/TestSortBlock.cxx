// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The sorting network: the shader's own text on the CPU. Runs under AddressSanitizer and UndefinedBehaviorSanitizer.
#include "SortShader.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <tuple>

namespace
{
/// Few depths and colours, so that ties are common.
std::vector<SortedFragment> AnyFragments(const SortVariant& variant)
{
  const std::uint32_t lastWords = variant.Channels == 3 ? 3 : 1;
  std::vector<SortedFragment> fragments(*rc::gen::inRange<std::size_t>(0, variant.BlockSize + 1));
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    fragments[i] = { static_cast<float>(*rc::gen::inRange(0, 9)) / 8,
      { *rc::gen::inRange(0u, 3u), *rc::gen::inRange(0u, 3u), *rc::gen::inRange(0u, lastWords) },
      static_cast<std::uint32_t>(i + 1) };
  }
  return fragments;
}

std::vector<std::uint32_t> Nodes(const std::vector<SortedFragment>& fragments)
{
  std::vector<std::uint32_t> nodes;
  for (const SortedFragment& fragment : fragments)
  {
    nodes.push_back(fragment.Node);
  }
  return nodes;
}

auto Content(const SortedFragment& fragment)
{
  return std::make_tuple(fragment.Depth, fragment.Color[0], fragment.Color[1], fragment.Color[2]);
}

bool NearerThan(const SortedFragment& a, const SortedFragment& b)
{
  return a.Depth < b.Depth;
}

bool AtEqualDepth(const SortedFragment& a, const SortedFragment& b)
{
  return a.Depth == b.Depth;
}

bool BeforeByContent(const SortedFragment& a, const SortedFragment& b)
{
  return Content(a) < Content(b);
}
}

class TestSortBlock : public testing::TestWithParam<SortVariant>
{
};

//------------------------------------------------------------------------------
TEST_P(TestSortBlock, SortsAsTheStandardLibraryDoes)
{
  const std::string order = GetParam().Order;
  EXPECT_TRUE(rc::check("by depth, then " + order,
    [&order]
    {
      std::vector<SortedFragment> expected = AnyFragments(GetParam());
      bool equalDepths = false;
      const std::vector<SortedFragment> sorted = GetParam().Sort(expected, equalDepths);
      std::stable_sort(expected.begin(), expected.end(), order == "Content" ? BeforeByContent : NearerThan);
      RC_ASSERT(sorted.size() == expected.size());
      for (std::size_t i = 0; i < sorted.size(); ++i)
      {
        RC_ASSERT(sorted[i].Depth == expected[i].Depth);
        RC_ASSERT(order == "None" || Content(sorted[i]) == Content(expected[i]));
        RC_ASSERT(order != "Drawn" || sorted[i].Node == expected[i].Node);
      }
      RC_ASSERT(equalDepths == (std::adjacent_find(expected.begin(), expected.end(), AtEqualDepth) != expected.end()));
    }));
}

//------------------------------------------------------------------------------
TEST_P(TestSortBlock, CarriesEachFragmentAlongOnce)
{
  EXPECT_TRUE(rc::check("nodes and colours stay with their depths",
    []
    {
      const std::vector<SortedFragment> fragments = AnyFragments(GetParam());
      bool equalDepths = false;
      const std::vector<SortedFragment> sorted = GetParam().Sort(fragments, equalDepths);
      std::vector<std::uint32_t> nodes = Nodes(sorted);
      for (const SortedFragment& fragment : sorted)
      {
        RC_ASSERT(fragment.Node >= 1 && fragment.Node <= fragments.size());
        RC_ASSERT(Content(fragment) == Content(fragments[fragment.Node - 1]));
      }
      std::sort(nodes.begin(), nodes.end());
      RC_ASSERT(std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end());
    }));
}

INSTANTIATE_TEST_SUITE_P(Network, TestSortBlock, testing::ValuesIn(SortVariants()),
  [](const auto& info)
  { return info.param.Order + std::to_string(info.param.BlockSize) + "_" + std::to_string(info.param.Channels); });
