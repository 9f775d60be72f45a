// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// How much room cells get before they are drawn: enough where the view goes on as it was, moves, or changes its size.
#include "vtkCellRoom.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace
{
using Room = vtkCellRoom;
using Rectangle = Room::Rectangle;
using Units = Room::Units;

constexpr std::int64_t NoLimit = 1 << 30;
const Room::Unit Node;
const Rectangle Viewport{ { 10, 20, 160, 100 } };

std::int64_t Sum(const Units& units)
{
  return std::accumulate(units.begin(), units.end(), std::int64_t(0));
}

/// What the cells of a tile take where each pixel of a disc holds that many fragments. Its middle and radius are parts
/// of the height; the middle is seen from that of the tile.
Units Take(const Rectangle& tile, double x, double y, double radius, int fragments)
{
  const auto [across, down] = Room::GetCells(tile);
  const int shift = Room::GetCellShift(tile);
  Units units(static_cast<std::size_t>(across) * down, 0);
  for (int row = 0; row < tile[3]; ++row)
  {
    for (int column = 0; column < tile[2]; ++column)
    {
      const double u = (column + 0.5 - tile[2] / 2.0) / tile[3] - x;
      const double v = (row + 0.5) / tile[3] - 0.5 - y;
      if (std::hypot(u, v) <= radius)
      {
        units[(row >> shift) * across + (column >> shift)] += fragments;
      }
    }
  }
  return units;
}

/// The box of that disc.
std::vector<Room::Box> BoxOf(const Rectangle& tile, double x, double y, double radius)
{
  const double height = tile[3];
  const double middle[2]{ tile[0] + tile[2] / 2.0 + x * height, tile[1] + height / 2 + y * height };
  return { { { middle[0] - radius * height, middle[1] - radius * height, middle[0] + radius * height,
    middle[1] + radius * height } } };
}

/// Units are fragments.
bool Finish(Room& room, const Units& taken)
{
  return room.FinishTile(taken, taken);
}

/// Draws a frame of a disc; true if it is drawn once.
bool DrawOnce(
  Room& room, const Rectangle& tile, double x, double y, double radius, int fragments, std::int64_t allowed = NoLimit)
{
  const Units taken = Take(tile, x, y, radius, fragments);
  room.BeginFrame(BoxOf(tile, x, y, radius));
  room.BeginTile(tile, Node, 0, allowed);
  const bool once = Finish(room, taken);
  if (!once)
  {
    room.BeginTile(tile, Node, 0, allowed);
    EXPECT_TRUE(Finish(room, taken)) << "what was counted has room";
  }
  return once;
}
}

TEST(TestCellRoom, GivesFirstFramesTwoFragmentsPerBox)
{
  Room room;
  EXPECT_TRUE(DrawOnce(room, Viewport, 0.1, 0.05, 0.3, 2));
  EXPECT_FALSE(room.IsTooLarge());
  Room other;
  EXPECT_FALSE(DrawOnce(other, Viewport, 0.1, 0.05, 0.3, 3));
}

TEST(TestCellRoom, GivesEachPixelAFragmentWhereThereIsNoBox)
{
  Room room;
  room.BeginFrame({});
  room.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_EQ(room.GetRanges(), Units(10 * 7, 256));
}

TEST(TestCellRoom, GuessesNoMoreThanSixteenFragmentsOnAverage)
{
  Room deep; // in four cells
  deep.BeginFrame(std::vector<Room::Box>(100, { { 74, 52, 106, 84 } }));
  deep.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_EQ(deep.GetRanges()[2 * 10 + 4], 200 * 256);

  Room room;
  room.BeginFrame(std::vector<Room::Box>(100, { { -1e9, -1e9, 1e9, 1e9 } }));
  room.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_EQ(room.GetRanges(), Units(10 * 7, 16 * 256));
}

TEST(TestCellRoom, GuessesHalfOfTheLimit)
{
  Room room;
  room.BeginFrame(std::vector<Room::Box>(100, { { -1e9, -1e9, 1e9, 1e9 } }));
  room.BeginTile(Viewport, Node, 0, 100000);
  EXPECT_LE(room.GetUnits(), 50000);
  EXPECT_GE(room.GetUnits(), 49000);
  room.BeginTile({ { 10, 20, 160, 50 } }, Node, 0, 10 * 4 * 256);
  EXPECT_EQ(room.GetRanges(), Units(10 * 4, 256)) << "one each is not a guess";
}

// A unit of four is begun in every pixel.
TEST(TestCellRoom, CountsUnitsThatAreNotFull)
{
  Room room;
  room.BeginFrame({ { { 10, 20, 170, 120 } } });
  room.BeginTile(Viewport, { 4, 0, 2 }, 0, NoLimit);
  EXPECT_EQ(room.GetRanges()[0], 256 * (2 + 3) / 4);
  Room own; // pixels have room for four themselves
  own.BeginFrame({ { { 10, 20, 170, 120 } } });
  own.BeginTile(Viewport, { 4, 4, 2 }, 0, NoLimit);
  EXPECT_EQ(own.GetRanges()[0], 256 / 4);
}

TEST(TestCellRoom, GuessesWhatAUnitSays)
{
  Room room;
  room.BeginFrame({ { { 10, 20, 170, 120 } } });
  room.BeginTile(Viewport, { 1, 0, 2.5 }, 0, NoLimit);
  EXPECT_EQ(room.GetRanges()[0], 640);
}

TEST(TestCellRoom, TellsAGuessThatWasTooLarge)
{
  const std::vector<Room::Box> boxes(3, { { 0, 0, 200, 200 } });
  Room room;
  room.BeginFrame(boxes);
  room.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_EQ(room.GetRanges(), Units(70, 6 * 256));
  EXPECT_TRUE(Finish(room, Units(70, 3 * 256 - 1)));
  EXPECT_TRUE(room.IsTooLarge());
  room.BeginFrame(boxes);
  room.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_EQ(room.GetRanges(), Units(70, 767 + 767 / 8));
  EXPECT_TRUE(Finish(room, Units(70, 1)));
  EXPECT_FALSE(room.IsTooLarge()) << "that was no guess";

  Room other;
  other.BeginFrame({ boxes[0] });
  other.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_TRUE(Finish(other, Units(70, 0)));
  EXPECT_FALSE(other.IsTooLarge()) << "not more than twice one fragment per pixel";
}

TEST(TestCellRoom, WidensWhenTheViewMovesNotAfterwards)
{
  Room room;
  DrawOnce(room, Viewport, 0, 0, 0.3, 9);
  for (int frame = 1; frame < 5; ++frame) // up to two cells a frame
  {
    SCOPED_TRACE(frame);
    EXPECT_TRUE(DrawOnce(room, Viewport, 0.2 * frame, -0.05 * frame, 0.3, 9));
    EXPECT_GT(room.GetUnitsToReserve(NoLimit), room.GetUnits());
  }
  EXPECT_TRUE(DrawOnce(room, Viewport, 0.8, -0.2, 0.3, 9)); // the same view
  EXPECT_EQ(room.GetUnitsToReserve(NoLimit), room.GetUnits());
  EXPECT_LE(room.GetUnits(), Sum(Take(Viewport, 0.8, -0.2, 0.3, 9)) * 9 / 8);
}

// Three surfaces lie over each other that lay side by side, farther away than cells look; a fourth comes.
TEST(TestCellRoom, ForeseesWhereBoxesWillLie)
{
  Room room;
  std::vector<double> places{ -0.6, 0, 0.6 };
  const auto draw = [&room, &places](const Room::Unit& unit)
  {
    std::vector<Room::Box> boxes;
    Units taken(70, 0);
    for (double place : places)
    {
      boxes.push_back(BoxOf(Viewport, place, 0, 0.2)[0]);
      const Units one = Take(Viewport, place, 0, 0.2, 3);
      std::transform(one.begin(), one.end(), taken.begin(), taken.begin(), std::plus<>());
    }
    room.BeginFrame(boxes);
    room.BeginTile(Viewport, unit, 0, NoLimit);
    Units units = taken; // of a pixel's 3 or 9 fragments, if they are of 4: 1 or 3
    for (std::int64_t& count : units)
    {
      count = unit.Fragments == 4 ? count / 3 : count;
    }
    return room.FinishTile(units, taken);
  };
  draw(Node);
  places = { 0.2, 0.2, 0.2 };
  EXPECT_TRUE(draw(Node));
  places.push_back(0.2);
  EXPECT_TRUE(draw(Node));
  places = { -0.6, 0, 0.6 };
  draw({ 4, 0, 2 });
  places = { 0, 0, 0 };
  EXPECT_TRUE(draw({ 4, 0, 2 }));
}

TEST(TestCellRoom, ForeseesNoMoreThanSixteenFragmentsOnAverage)
{
  Room room;
  room.BeginFrame({ { { 0, 0, 200, 200 } } });
  room.BeginTile(Viewport, Node, 0, NoLimit);
  Finish(room, Units(70, 12 * 256));
  room.BeginFrame(std::vector<Room::Box>(2, { { 0, 0, 200, 200 } }));
  room.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_EQ(room.GetRanges(), Units(70, 12 * 256 * 9 / 8));
}

// What a line holds in a cell that its box has a corner in tells nothing of cells that it covers.
TEST(TestCellRoom, ForeseesNothingFromTheCornersOfBoxes)
{
  const Room::Unit run{ 4, 0, 2 };
  Room room;
  room.BeginFrame({ { { 10, 20, 12, 22 } } });
  room.BeginTile(Viewport, run, 0, NoLimit);
  Units taken(70, 0);
  taken[0] = 64;
  Finish(room, taken);
  room.BeginFrame({ { { 10, 20, 26, 36 } } });
  room.BeginTile(Viewport, run, 0, NoLimit);
  EXPECT_EQ(room.GetRanges()[0], 3 * 256 / 4 * 9 / 8) << "runs that are not full";
}

// Boxes that jump farther than cells are widened: units that are not full have room for that, single fragments have
// not.
TEST(TestCellRoom, ForeseesOneBoxWhereUnitsAreFragments)
{
  Room room;
  room.BeginFrame({ { { 10, 20, 26, 36 } } });
  room.BeginTile(Viewport, Node, 0, NoLimit);
  Finish(room, Units(70, 0));
  room.BeginFrame(std::vector<Room::Box>(3, { { 74, 84, 90, 100 } }));
  room.BeginTile(Viewport, Node, 0, NoLimit);
  EXPECT_EQ(room.GetRanges()[4 * 10 + 4], 2 * 256 * 9 / 8);
  EXPECT_EQ(room.GetRanges()[0], 0);
}

// What changes within the same box is not seen before it is drawn.
TEST(TestCellRoom, WidensAfterAFrameThatDidNotFit)
{
  Room room;
  const auto draw = [&room](double x)
  {
    room.BeginFrame({});
    room.BeginTile(Viewport, Node, 0, NoLimit);
    return Finish(room, Take(Viewport, x, 0, 0.2, 9));
  };
  draw(0);
  EXPECT_FALSE(draw(0.2));
  for (int frame = 2; frame < 30; ++frame)
  {
    EXPECT_TRUE(draw(0.2 + frame % 2 * 0.1)) << frame;
  }
}

TEST(TestCellRoom, TakesOverWhatWasSeenInAViewportOfAnotherSize)
{
  for (const Rectangle& other : { Rectangle{ { 10, 20, 161, 100 } }, Rectangle{ { 0, 0, 320, 200 } },
         Rectangle{ { 0, 0, 100, 60 } }, Rectangle{ { 0, 0, 400, 100 } }, Rectangle{ { 0, 0, 3000, 2500 } } })
  {
    SCOPED_TRACE(testing::PrintToString(other));
    Room room;
    EXPECT_FALSE(DrawOnce(room, Viewport, 0.1, 0.05, 0.3, 9));
    EXPECT_TRUE(DrawOnce(room, other, 0.1, 0.05, 0.3, 9));
  }
}

// In tiles none of which is the picture nothing is to be taken over.
TEST(TestCellRoom, TakesNothingOverFromPartsOfAViewport)
{
  Room room;
  room.BeginFrame({});
  for (const Rectangle& tile : { Rectangle{ { 0, 0, 64, 32 } }, Rectangle{ { 0, 32, 64, 32 } } })
  {
    room.BeginTile(tile, Node, 0, NoLimit);
    Finish(room, Units(8, 2000));
  }
  room.BeginFrame({});
  room.BeginTile({ { 0, 0, 64, 48 } }, Node, 0, NoLimit);
  EXPECT_EQ(room.GetRanges(), Units(4 * 3, 256));
}

TEST(TestCellRoom, ForgetsWhatCellsTook)
{
  Room room;
  DrawOnce(room, Viewport, 0, 0, 0.3, 9);
  room.Forget();
  EXPECT_FALSE(DrawOnce(room, Viewport, 0, 0, 0.3, 9));
}

TEST(TestCellRoom, SpreadsTheFirstRoomThatIsAskedFor)
{
  Room room;
  room.BeginFrame({ { { 10, 20, 170, 120 } } });
  room.BeginTile(Viewport, Node, 300, NoLimit);
  EXPECT_EQ(room.GetUnits(), 300);
  EXPECT_EQ(room.GetRanges()[0], 256);
}

RC_GTEST_PROP(TestCellRoom, KeepsTheLimitAsLongAsWhatWasCountedDoes, ())
{
  Room room;
  for (int frame = 0; frame < 6; ++frame)
  {
    const Rectangle tile{ { 0, 0, *rc::gen::element(64, 100, 300), *rc::gen::element(64, 100, 200) } };
    const double x = *rc::gen::inRange(-10, 11) / 20.0;
    const int fragments = *rc::gen::inRange(0, 40);
    const auto [across, down] = Room::GetCells(tile);
    const std::int64_t least = across * down * 256;
    const std::int64_t allowed = std::max(least, Sum(Take(tile, x, 0, 0.3, fragments))) + *rc::gen::inRange(0, 100000);
    DrawOnce(room, tile, x, 0, 0.3, fragments, allowed);
    room.BeginFrame(BoxOf(tile, x, 0, 0.3));
    room.BeginTile(tile, Node, 0, allowed);
    RC_ASSERT(room.GetUnits() <= allowed);
    RC_ASSERT(Finish(room, Take(tile, x, 0, 0.3, fragments)));
  }
}
