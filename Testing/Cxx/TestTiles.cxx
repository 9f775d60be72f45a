// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The parts in which a viewport is drawn: whatever is cut, each pixel is drawn once.
#include "vtkTranslucencyTiles.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <utility>

namespace
{
using Tiles = vtkTranslucencyTiles;
using Rectangle = Tiles::Rectangle;

/// Draws a frame: cuts tiles that are larger than a number of pixels into a number of parts, until none is. Gives the
/// tiles in the order of drawing.
std::vector<Rectangle> Draw(Tiles& tiles, const Rectangle& viewport, int most, int parts)
{
  std::vector<Rectangle> drawn;
  tiles.BeginFrame(viewport);
  while (tiles.Next())
  {
    while (tiles.GetTile()[2] * tiles.GetTile()[3] > most)
    {
      tiles.Cut(parts);
    }
    drawn.push_back(tiles.GetTile());
    tiles.Finish(1, 2);
  }
  return drawn;
}

std::map<std::pair<int, int>, int> CountPixels(const std::vector<Rectangle>& tiles)
{
  std::map<std::pair<int, int>, int> counts;
  for (const Rectangle& tile : tiles)
  {
    for (int y = tile[1]; y < tile[1] + tile[3]; ++y)
    {
      for (int x = tile[0]; x < tile[0] + tile[2]; ++x)
      {
        ++counts[{ x, y }];
      }
    }
  }
  return counts;
}
}

RC_GTEST_PROP(TestTiles, DrawEachPixelOnce, ())
{
  const Rectangle viewport{ { *rc::gen::inRange(0, 9), *rc::gen::inRange(0, 9), *rc::gen::inRange(1, 20),
    *rc::gen::inRange(1, 20) } };
  Tiles tiles;
  const auto drawn = Draw(tiles, viewport, *rc::gen::inRange(1, 400), *rc::gen::inRange(2, 50));
  const auto counts = CountPixels(drawn);
  RC_ASSERT(counts.size() == static_cast<std::size_t>(viewport[2] * viewport[3]));
  for (const auto& pixel : counts)
  {
    RC_ASSERT(pixel.second == 1);
    RC_ASSERT(CountPixels({ viewport }).count(pixel.first) == 1);
  }
  RC_ASSERT(tiles.GetFragments() == static_cast<std::int64_t>(drawn.size()));
}

RC_GTEST_PROP(TestTiles, AreThoseOfTheFrameBefore, ())
{
  const Rectangle viewport{ { 3, 5, *rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20) } };
  const int parts = *rc::gen::inRange(2, 9);
  Tiles tiles;
  const auto first = Draw(tiles, viewport, *rc::gen::inRange(1, 400), parts);
  const auto second = Draw(tiles, viewport, viewport[2] * viewport[3], parts);
  RC_ASSERT(second == first);
  RC_ASSERT(tiles.GetLastUnits() == static_cast<std::int64_t>(2 * first.size()));
}

// What has failed counts as finished, too, or the next frame would leave it out.
TEST(TestTiles, TellWhetherTheCurrentOneIsFinished)
{
  Tiles tiles;
  tiles.BeginFrame({ { 0, 0, 8, 8 } });
  ASSERT_TRUE(tiles.Next());
  EXPECT_FALSE(tiles.IsFinished());
  tiles.Cut(2);
  EXPECT_FALSE(tiles.IsFinished());
  tiles.Finish();
  EXPECT_TRUE(tiles.IsFinished());
  ASSERT_TRUE(tiles.Next());
  EXPECT_FALSE(tiles.IsFinished());
}

TEST(TestTiles, AreForgottenWithTheViewport)
{
  Tiles tiles;
  EXPECT_EQ(Draw(tiles, { { 0, 0, 8, 8 } }, 16, 4).size(), 4u);
  EXPECT_EQ(Draw(tiles, { { 0, 0, 8, 9 } }, 100, 4).size(), 1u);
  EXPECT_EQ(Draw(tiles, { { 0, 0, 8, 9 } }, 16, 4).size(), 6u); // two rows each, and the last three one by one
  tiles.Forget();
  EXPECT_EQ(Draw(tiles, { { 0, 0, 8, 9 } }, 100, 4).size(), 1u);
}

TEST(TestTiles, GiveWayToTheWholeViewportBeforeAnyIsDrawn)
{
  const Rectangle viewport{ { 0, 0, 8, 8 } };
  Tiles tiles;
  Draw(tiles, viewport, 16, 4);
  tiles.BeginFrame(viewport);
  ASSERT_TRUE(tiles.Next());
  tiles.UseWholeViewport();
  EXPECT_EQ(tiles.GetTile(), viewport);
  tiles.Cut(2);
  const Rectangle half = tiles.GetTile();
  tiles.UseWholeViewport(); // it is cut now
  EXPECT_EQ(tiles.GetTile(), half);
  tiles.Finish();
  ASSERT_TRUE(tiles.Next());
  tiles.UseWholeViewport();
  EXPECT_NE(tiles.GetTile(), viewport);
  tiles.Finish();
  EXPECT_FALSE(tiles.Next());
}

TEST(TestTiles, AreCutByRowsAndThenByPixels)
{
  Tiles tiles;
  tiles.BeginFrame({ { 0, 0, 3, 2 } });
  ASSERT_TRUE(tiles.Next());
  tiles.Cut(9);
  EXPECT_EQ(tiles.GetTile(), (Rectangle{ { 0, 0, 3, 1 } }));
  EXPECT_FALSE(tiles.IsSmallest());
  tiles.Cut(9);
  EXPECT_EQ(tiles.GetTile(), (Rectangle{ { 0, 0, 1, 1 } }));
  EXPECT_TRUE(tiles.IsSmallest());
}

TEST(TestTiles, OfNothingAreNone)
{
  Tiles tiles;
  tiles.BeginFrame(Tiles::Intersect({ { 0, 0, 4, 4 } }, { { 5, 0, 4, 4 } }));
  EXPECT_FALSE(tiles.Next());
  EXPECT_EQ(Tiles::Intersect({ { 0, 0, 4, 4 } }, { { 2, 1, 9, 2 } }), (Rectangle{ { 2, 1, 2, 2 } }));
}
