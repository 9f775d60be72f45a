// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The rules of choice, driven by costs that are made up.
#include "vtkTechniqueChooser.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace
{
using Chooser = vtkTechniqueChooser;

// Best first. Lists take memory for fragments, layers for pixels.
const std::vector<Chooser::Candidate> Some{
  { "lists", 0, 1, 16, 4, 0, 8 },
  { "layers", 0.001, 2, 0, 0, 100, 0 },
  { "few-layers", 0.01, 1.5, 0, 0, 50, 0 },
  { "sums", 0.05, 0.5, 0, 0, 20, 0 },
};
enum
{
  Lists,
  Layers,
  FewLayers,
  Sums
};

constexpr double Mebi = 1024 * 1024; // pixels: a byte of each is a MiB

/// A scene and a machine.
struct World
{
  double Fragments = 4 * Mebi;
  std::vector<double> Milliseconds{ 10, 20, 15, 5 }; // of the candidates
  int Samples = 1;

  int Draw(Chooser& chooser, bool changed = false, double noise = 1) const
  {
    const int chosen = chooser.Choose({ Mebi, this->Samples, changed });
    const Chooser::Candidate& one = Some[chosen];
    Chooser::Cost cost;
    cost.Milliseconds = this->Milliseconds[chosen] * noise;
    cost.Bytes =
      one.BytesPerFragment * this->Fragments + (one.BytesPerPixel + one.BytesPerSample * this->Samples) * Mebi;
    cost.Fragments = this->Fragments;
    chooser.Observe(cost);
    return chosen;
  }

  /// The choices of that many frames, each once as long as it stays.
  std::vector<int> Choices(Chooser& chooser, int frames) const
  {
    std::vector<int> choices;
    for (int frame = 0; frame < frames; ++frame)
    {
      const int chosen = this->Draw(chooser);
      if (choices.empty() || choices.back() != chosen)
      {
        choices.push_back(chosen);
      }
    }
    return choices;
  }
};

using Choices = std::vector<int>;

void ExpectReason(const Chooser& chooser, const std::string& part)
{
  EXPECT_NE(chooser.GetReason().find(part), std::string::npos) << chooser.GetReason();
}
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, TakesTheBestWithoutABudget)
{
  Chooser chooser(Some);
  EXPECT_EQ(chooser.GetChosen(), -1);
  EXPECT_EQ(World().Choices(chooser, 50), Choices{ Lists });
  ExpectReason(chooser, "there is no budget");
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, PredictsMemory)
{
  Chooser chooser(Some);
  World world;
  world.Draw(chooser);
  EXPECT_EQ(chooser.GetBytes(Lists, { Mebi, 1, false }), 4 * 16 * Mebi + 4 * Mebi);
  EXPECT_EQ(chooser.GetBytes(Lists, { Mebi, 4, false }), 4 * 16 * Mebi + 4 * Mebi + 4 * 8 * Mebi);
  EXPECT_EQ(chooser.GetBytes(Layers, { Mebi, 4, false }), 4 * 100 * Mebi);
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, TakesTheBestThatFitsIntoMemory)
{
  // Before the first frame a fragment a pixel is expected, 20 MiB for lists; then 68 MiB.
  const struct
  {
    double Mebibytes;
    Choices Expected;
  } cases[] = { { 68, { Lists } }, { 67, { Lists, FewLayers } }, { 49, { Lists, Sums } }, { 20, { Lists, Sums } } };
  for (const auto& one : cases)
  {
    Chooser chooser(Some);
    chooser.SetBudget({ 0, one.Mebibytes, 0 });
    EXPECT_EQ(World().Choices(chooser, 50), one.Expected) << one.Mebibytes;
    ExpectReason(chooser, "memory budget of " + std::to_string(static_cast<int>(one.Mebibytes)) + " MiB");
  }
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, TakesTheSmallestIfNothingFits)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 0, 10, 0 });
  World world;
  world.Fragments = 100 * Mebi;
  EXPECT_EQ(world.Choices(chooser, 50).back(), Sums);
  ExpectReason(chooser, "nothing fits");
  ExpectReason(chooser, "memory budget of 10 MiB");
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, LeavesWhatNeedsTiles)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 0, 100, 0 });
  EXPECT_EQ(chooser.Choose({ Mebi, 1, false }), Lists);
  Chooser::Cost cost;
  cost.Fragments = Mebi;
  cost.Tiles = 3;
  chooser.Observe(cost);
  EXPECT_EQ(chooser.Choose({ Mebi, 1, false }), Layers);
  ExpectReason(chooser, "lists took 3 tiles");
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, ReturnsToTheBetterOneOnlyWithAMarginAndAfterAChange)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 0, 60, 0 });
  World world;
  EXPECT_EQ(world.Choices(chooser, 5).back(), FewLayers);
  world.Fragments = Mebi; // 20 MiB, but nothing says that the scene has changed
  EXPECT_EQ(world.Choices(chooser, 20), Choices{ FewLayers });
  world.Fragments = 3 * Mebi; // 52 MiB: fits, but closely
  world.Draw(chooser);
  for (int frame = 0; frame < 20; ++frame)
  {
    EXPECT_EQ(world.Draw(chooser, true), FewLayers);
  }
  world.Fragments = 2 * Mebi; // 36 MiB
  world.Draw(chooser, true);
  EXPECT_EQ(world.Draw(chooser, true), Lists);
  ExpectReason(chooser, "better than few-layers");
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, StepsDownInTimeByAMedian)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 8, 0, 0 });
  World world;
  for (int frame = 0; frame < Chooser::MedianFrames; ++frame)
  {
    EXPECT_EQ(world.Draw(chooser), Lists);
  }
  EXPECT_EQ(world.Choices(chooser, 50), Choices{ Sums }); // layers are expected to take longer
  ExpectReason(chooser, "lists took 10 ms");
  ExpectReason(chooser, "time budget of 8 ms");
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, IsNotMovedByAFewSlowFrames)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 12, 0, 0 });
  World world;
  for (int frame = 0; frame < 100; ++frame)
  {
    EXPECT_EQ(world.Draw(chooser, false, frame % 7 == 0 ? 50 : 1), Lists);
  }
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, StaysWithTheFastestIfNoneFits)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 1, 0, 0 });
  World world;
  EXPECT_EQ(world.Choices(chooser, 100), (Choices{ Lists, Sums }));
  ExpectReason(chooser, "no technique is expected to fit");
  world.Milliseconds = { 10, 20, 15, 30 }; // what was expected of sums is not so
  Chooser other(Some);
  other.SetBudget({ 1, 0, 0 });
  EXPECT_EQ(world.Choices(other, 100), (Choices{ Lists, Sums, Lists }));
  world.Milliseconds = { 10, 20, 15, 9 }; // hardly anything is saved
  Chooser third(Some);
  third.SetBudget({ 1, 0, 0 });
  EXPECT_EQ(world.Choices(third, 100), (Choices{ Lists, Sums, Lists }));
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, DoesNotTryAgainWhatWasTooSlowWhileTheViewMoves)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 8, 0, 0 });
  World world;
  world.Choices(chooser, 50);
  for (int frame = 0; frame < 100; ++frame)
  {
    world.Fragments = (4 - 0.005 * frame) * Mebi;
    EXPECT_EQ(world.Draw(chooser, true), Sums);
  }
  world.Fragments = 2 * Mebi; // half the time
  world.Milliseconds = { 5, 10, 7.5, 2.5 };
  for (int frame = 0; frame < 2 * Chooser::MedianFrames; ++frame)
  {
    world.Draw(chooser, true);
  }
  EXPECT_EQ(chooser.GetChosen(), Lists);
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, DoesNotCountFramesThatBuiltShaders)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 8, 0, 0 });
  for (int frame = 0; frame < 50; ++frame)
  {
    EXPECT_EQ(chooser.Choose({ Mebi, 1, frame == 0 }), Lists);
    Chooser::Cost cost;
    cost.Milliseconds = 100;
    cost.Steady = false;
    chooser.Observe(cost);
  }
}

//------------------------------------------------------------------------------
TEST(TestTechniqueChooser, TakesTheFastestWithinTheTolerance)
{
  const struct
  {
    double Tolerance;
    int Expected;
  } cases[] = { { 0, Lists }, { 0.0005, Lists }, { 0.02, Lists }, { 0.05, Sums }, { 1, Sums } };
  for (const auto& one : cases)
  {
    Chooser chooser(Some);
    chooser.SetBudget({ 0, 0, one.Tolerance });
    EXPECT_EQ(World().Choices(chooser, 10), Choices{ one.Expected }) << one.Tolerance;
  }
}

//------------------------------------------------------------------------------
// The one that is drawn always looks slower than what the others took when they were drawn last.
TEST(TestTechniqueChooser, ComesToRestEvenIfFramesTakeLongerAndLonger)
{
  Chooser chooser(Some);
  chooser.SetBudget({ 1, 0, 0 });
  World world;
  world.Milliseconds = { 10, 10, 10, 10 };
  double slower = 1;
  const auto draw = [&](int frames)
  {
    std::set<int> choices;
    for (int frame = 0; frame < frames; ++frame)
    {
      slower *= 1.2;
      choices.insert(world.Draw(chooser, false, slower));
    }
    return choices.size();
  };
  EXPECT_GT(draw(100), 1u);
  EXPECT_EQ(draw(100), 1u);
}

//------------------------------------------------------------------------------
// Whatever things cost and however much frames differ: the choices of a still scene come to rest.
RC_GTEST_PROP(TestTechniqueChooser, ComesToRestOnAStillScene, ())
{
  const auto number = [](int least, int most) { return *rc::gen::inRange(least, most); };
  Chooser chooser(Some);
  chooser.SetBudget({ number(0, 40) * 1.0, number(0, 120) * 1.0, number(0, 3) * 0.01 });
  World world;
  world.Fragments = number(0, 8) * Mebi;
  world.Samples = *rc::gen::element(1, 4);
  for (double& time : world.Milliseconds)
  {
    time = number(1, 60);
  }
  // Noise that repeats itself: a chosen one that is not left within a period is never left. Noise without an end would
  // leave some at any time.
  std::vector<double> noise(number(1, 11));
  for (double& one : noise)
  {
    one = 1 + 0.01 * number(-30, 60);
  }
  const int still = number(0, 30); // the frame from which on nothing changes
  const auto count = static_cast<int>(Some.size());
  const int most = count * (count + 1); // changes
  const int rest = still + most * (Chooser::MedianFrames + static_cast<int>(noise.size()));
  int changes = 0;
  int lastChange = 0;
  int last = -1;
  for (int frame = 0; frame < 2 * rest; ++frame)
  {
    const int chosen = world.Draw(chooser, frame < still, noise[frame % noise.size()]);
    if (frame >= still && chosen != last)
    {
      ++changes;
      lastChange = frame;
    }
    last = chosen;
  }
  RC_ASSERT(changes <= most);
  RC_ASSERT(lastChange <= rest);
}
