// The sorting network: the shader's own text on the CPU. Runs under AddressSanitizer and UndefinedBehaviorSanitizer.
#include "SortShader.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <tuple>

namespace
{
/// Few depths and colours, so that ties are common.
std::vector<SortedFragment> AnyFragments(int most)
{
  std::vector<SortedFragment> fragments(*rc::gen::inRange<std::size_t>(0, most + 1));
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    fragments[i] = { static_cast<float>(*rc::gen::inRange(0, 9)) / 8,
      { *rc::gen::inRange(0u, 3u), *rc::gen::inRange(0u, 3u) }, static_cast<std::uint32_t>(i + 1) };
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
  return std::make_tuple(fragment.Depth, fragment.Color[0], fragment.Color[1]);
}

bool NearerThan(const SortedFragment& a, const SortedFragment& b)
{
  return a.Depth < b.Depth;
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
  const bool drawn = GetParam().Order == "Drawn";
  EXPECT_TRUE(rc::check(drawn ? "stable by depth" : "by depth, then by content",
    [drawn]
    {
      std::vector<SortedFragment> expected = AnyFragments(GetParam().BlockSize);
      const std::vector<SortedFragment> sorted = GetParam().Sort(expected);
      std::stable_sort(expected.begin(), expected.end(), drawn ? NearerThan : BeforeByContent);
      RC_ASSERT(sorted.size() == expected.size());
      for (std::size_t i = 0; i < sorted.size(); ++i)
      {
        RC_ASSERT(Content(sorted[i]) == Content(expected[i]));
      }
      std::vector<std::uint32_t> nodes = Nodes(sorted);
      if (drawn)
      {
        RC_ASSERT(nodes == Nodes(expected));
      }
      // Each once: what is carried along has gone with its fragment.
      std::sort(nodes.begin(), nodes.end());
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        RC_ASSERT(nodes[i] == i + 1);
      }
    }));
}

INSTANTIATE_TEST_SUITE_P(Network, TestSortBlock, testing::ValuesIn(SortVariants()),
  [](const auto& info) { return info.param.Order + std::to_string(info.param.BlockSize); });
