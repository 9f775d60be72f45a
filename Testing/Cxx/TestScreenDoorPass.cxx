// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Screen-door transparency: masks hold what is said of them, and pictures are, pixel by pixel, as the masks make them.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkScreenDoorMask.h>
#include <vtkScreenDoorPass.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

namespace
{
using Ranks = std::vector<unsigned int>;

const int Offsets[] = { vtkScreenDoorPass::NoOffset, vtkScreenDoorPass::ObjectOffset };
constexpr double Pi = 3.14159265358979323846;

struct Mask
{
  std::string Name;
  int Value;
  int Size;

  int Cells() const { return this->Size * this->Size; }
  Ranks Make() const
  {
    return this->Value == vtkScreenDoorPass::BlueNoise ? vtkScreenDoorMask::MakeBlueNoise(this->Size)
                                                       : vtkScreenDoorMask::MakeOrdered(this->Size);
  }
};

void PrintTo(const Mask& mask, std::ostream* os)
{
  *os << mask.Name;
}

const Mask Masks[] = { { "Ordered4x4", vtkScreenDoorPass::Ordered4x4, 4 },
  { "Ordered8x8", vtkScreenDoorPass::Ordered8x8, 8 }, { "BlueNoise", vtkScreenDoorPass::BlueNoise, 64 } };

/// Power of the pattern of the ranks below count at a frequency, in cycles a mask, where that of as many cells at
/// random is 1.
double Power(const Ranks& ranks, int size, int count, int u, int v)
{
  std::complex<double> sum = 0;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      if (ranks[y * size + x] < static_cast<unsigned int>(count))
      {
        sum += std::polar(1.0, -2 * Pi * (u * x + v * y) / size);
      }
    }
  }
  const double filled = static_cast<double>(count) / (size * size);
  return std::norm(sum) / (size * size * filled * (1 - filled));
}

class TestScreenDoorMask
  : public testing::Test
  , public testing::WithParamInterface<Mask>
{
};
}

//------------------------------------------------------------------------------
TEST_P(TestScreenDoorMask, HoldsEachRankOnce)
{
  Ranks ranks = GetParam().Make();
  EXPECT_EQ(ranks, GetParam().Make()) << "in each run";
  std::sort(ranks.begin(), ranks.end());
  ASSERT_EQ(static_cast<int>(ranks.size()), GetParam().Cells());
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    ASSERT_EQ(ranks[i], i);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Masks, TestScreenDoorMask, testing::ValuesIn(Masks), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
TEST(TestOrderedMask, IsBayers)
{
  EXPECT_EQ(vtkScreenDoorMask::MakeOrdered(4), (Ranks{ 0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5 }));
}

//------------------------------------------------------------------------------
// Blue noise: hardly any power at low frequencies, and no peak at any.
TEST(TestBlueNoiseMask, HasNeitherClustersNorAPattern)
{
  constexpr int size = 64;
  const Ranks ranks = vtkScreenDoorMask::MakeBlueNoise(size);
  const Ranks ordered = vtkScreenDoorMask::MakeOrdered(size);
  Ranks shuffled = ranks;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(1));
  for (double opacity : { 0.1, 0.3, 0.5, 0.7, 0.9 })
  {
    const int count = static_cast<int>(opacity * size * size);
    double low = 0;
    double peak = 0;
    double shuffledLow = 0;
    double orderedPeak = 0;
    constexpr int lowest = 6; // cycles a mask, a tenth of what it can hold
    for (int v = 0; v <= size / 2; ++v)
    {
      for (int u = 0; u < size; u += v < lowest ? 1 : 3)
      {
        const bool isLow = std::hypot(std::min(u, size - u), v) <= lowest;
        const double power = u + v > 0 ? Power(ranks, size, count, u, v) : 0;
        if (isLow && u + v > 0)
        {
          low = std::max(low, power);
          shuffledLow = std::max(shuffledLow, Power(shuffled, size, count, u, v));
        }
        peak = std::max(peak, power);
      }
    }
    for (int v : { 0, 8, 16, 32 })
    {
      for (int u : { 8, 16, 32 })
      {
        orderedPeak = std::max(orderedPeak, Power(ordered, size, count, u, v));
      }
    }
    RecordProperty("low" + std::to_string(count), std::to_string(low));
    RecordProperty("peak" + std::to_string(count), std::to_string(peak));
    EXPECT_LE(low, 0.5) << opacity;
    EXPECT_GE(shuffledLow, 2) << opacity;
    EXPECT_LE(peak, 20) << opacity;
    EXPECT_GE(orderedPeak, 100) << opacity;
  }
}

namespace
{
/// The picture of layers that are one rectangle each, their front faces seen, by the definition.
Picture ComputeScreenDoor(const AnalyticScene& scene, const Mask& mask, int offset)
{
  const Ranks ranks = mask.Make();
  Picture picture{ scene.Width, scene.Height, {} };
  for (int y = 0; y < scene.Height; ++y)
  {
    for (int x = 0; x < scene.Width; ++x)
    {
      double nearest = 1;
      Reference::Color seen = scene.Background;
      const auto show = [&](const Rectangle& rectangle)
      {
        const bool covers = x >= rectangle.Left && x < rectangle.Right && y >= rectangle.Bottom && y < rectangle.Top;
        if (covers && rectangle.Depth < nearest)
        {
          nearest = rectangle.Depth;
          seen = rectangle.Rgb;
        }
      };
      std::for_each(scene.Opaque.begin(), scene.Opaque.end(), show);
      for (std::size_t i = 0; i < scene.Translucent.size(); ++i)
      {
        // Front faces have every other place of the sequence of the plastic number, 1.3247.
        const double place = offset == vtkScreenDoorPass::ObjectOffset ? 2.0 * i : 0;
        const double plastic = 1.32471795724474602596;
        const int right = static_cast<int>(mask.Size * std::fmod(place / plastic, 1));
        const int up = static_cast<int>(mask.Size * std::fmod(place / (plastic * plastic), 1));
        const unsigned int rank = ranks[(y + up) % mask.Size * mask.Size + (x + right) % mask.Size];
        if (scene.Translucent[i].front().Alpha > (rank + 0.5) / mask.Cells())
        {
          show(scene.Translucent[i].front());
        }
      }
      for (double channel : seen)
      {
        picture.Rgb.push_back(255 * channel);
      }
    }
  }
  return picture;
}

struct Case
{
  Mask Of;
  int Samples;
};

void PrintTo(const Case& value, std::ostream* os)
{
  *os << value.Of.Name << value.Samples;
}

class TestScreenDoor
  : public RenderTest
  , public testing::WithParamInterface<Case>
{
protected:
  Picture Draw(const AnalyticScene& scene, int offset)
  {
    View view(scene, GetParam().Samples);
    vtkNew<vtkScreenDoorPass> pass;
    pass->SetMask(GetParam().Of.Value);
    pass->SetOffset(offset);
    view.SetPass(pass);
    const Picture drawn = view.Render();
    EXPECT_EQ(view.Render(), drawn);
    EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    return drawn;
  }

  /// Flat layers over all of a black window of whole periods: red ones, the nearest first, then green and blue.
  static AnalyticScene FlatLayers(const std::vector<double>& opacities)
  {
    AnalyticScene scene;
    scene.Width = 192;
    scene.Height = 128;
    for (std::size_t i = 0; i < opacities.size(); ++i)
    {
      Reference::Color color{ { 0, 0, 0 } };
      color[i] = 1;
      scene.Translucent.push_back({ { 0, 0, scene.Width, scene.Height, (i + 1) / 8.0, color, opacities[i] } });
    }
    return scene;
  }

  /// How many pixels of each period show a channel, the same in all.
  static int CountInPeriods(const Picture& picture, int size, int channel)
  {
    int expected = -1;
    for (int top = 0; top < picture.Height; top += size)
    {
      for (int left = 0; left < picture.Width; left += size)
      {
        int count = 0;
        for (int i = 0; i < size * size; ++i)
        {
          count += picture.At(left + i % size, top + i / size, channel) == 255;
        }
        EXPECT_TRUE(expected < 0 || count == expected) << count << " and " << expected;
        expected = count;
      }
    }
    return expected;
  }
};
}

//------------------------------------------------------------------------------
TEST_P(TestScreenDoor, CoversAPeriodAsTheOpacityTells)
{
  const Mask& mask = GetParam().Of;
  for (double opacity : { 0.001, 0.1, 0.26, 0.5, 0.71, 0.93, 0.999 })
  {
    for (int offset : Offsets)
    {
      const int count = CountInPeriods(this->Draw(FlatLayers({ opacity }), offset), mask.Size, 0);
      EXPECT_LE(std::abs(count - opacity * mask.Cells()), 0.5) << opacity;
    }
    // Two triangles, each with a place of its own: as much but for the edge between them.
    const Picture drawn = this->Draw(FlatLayers({ opacity }), vtkScreenDoorPass::PrimitiveOffset);
    const auto kept = std::count(drawn.Rgb.begin(), drawn.Rgb.end(), 255.0);
    EXPECT_NEAR(static_cast<double>(kept) / (drawn.Width * drawn.Height), opacity, 0.5 / mask.Cells() + 0.01);
  }
}

//------------------------------------------------------------------------------
// With one place for all, what a nearer layer leaves free of a period is what it does not cover itself.
TEST_P(TestScreenDoor, SeesOfAFartherLayerWhatTheNearerLeavesFree)
{
  const Mask& mask = GetParam().Of;
  const double near = 0.3;
  for (double far : { 0.2, 0.3, 0.7 })
  {
    const Picture drawn = this->Draw(FlatLayers({ near, far }), vtkScreenDoorPass::NoOffset);
    const int covered = static_cast<int>(std::lround(near * mask.Cells()));
    EXPECT_EQ(CountInPeriods(drawn, mask.Size, 0), covered);
    EXPECT_EQ(CountInPeriods(drawn, mask.Size, 1), std::max<int>(0, std::lround(far * mask.Cells()) - covered)) << far;
  }
}

//------------------------------------------------------------------------------
// In different places, coincident layers of the same opacity show different pixels.
TEST_P(TestScreenDoor, ShowsBothOfTwoLayersInDifferentPlaces)
{
  const Mask& mask = GetParam().Of;
  const Picture drawn = this->Draw(FlatLayers({ 0.45, 0.45 }), vtkScreenDoorPass::ObjectOffset);
  EXPECT_EQ(CountInPeriods(drawn, mask.Size, 0), std::lround(0.45 * mask.Cells()));
  if (mask.Value == vtkScreenDoorPass::BlueNoise) // which shows about as much of the farther one as blending
  {
    EXPECT_NEAR(CountInPeriods(drawn, mask.Size, 1), 0.55 * 0.45 * mask.Cells(), 0.1 * mask.Cells());
  }
}

//------------------------------------------------------------------------------
TEST_P(TestScreenDoor, IsAsTheMaskMakesIt)
{
  const AnalyticScene scene = RandomLayers(200, 150, 221, 9, 0.1, 0.9);
  for (int offset : Offsets)
  {
    const PictureDifference difference =
      Compare(this->Draw(scene, offset), ComputeScreenDoor(scene, GetParam().Of, offset));
    EXPECT_LE(difference.Largest, 0.5) << difference;
  }
}

//------------------------------------------------------------------------------
TEST_P(TestScreenDoor, DoesNotDependOnTheOrderOfDrawing)
{
  const AnalyticScene scene = RandomLayers(200, 150, 222, 9, 0.1, 0.9);
  EXPECT_EQ(this->Draw(scene, vtkScreenDoorPass::NoOffset), this->Draw(scene.Reversed(), vtkScreenDoorPass::NoOffset));
}

namespace
{
std::vector<Case> Cases()
{
  std::vector<Case> cases;
  for (int samples : { 0, 4 })
  {
    for (const Mask& mask : Masks)
    {
      cases.push_back({ mask, samples });
    }
  }
  return cases;
}
}

INSTANTIATE_TEST_SUITE_P(Masks, TestScreenDoor, testing::ValuesIn(Cases()),
  [](const auto& info) { return info.param.Of.Name + (info.param.Samples > 0 ? "MultiSampled" : ""); });

//------------------------------------------------------------------------------
using TestScreenDoorWindow = RenderTest;

TEST_F(TestScreenDoorWindow, KeepsTheOpaqueDepth)
{
  const AnalyticScene scene = RandomLayers(200, 150, 223, 9, 0.3, 0.9);
  const auto depths = [&scene](bool translucent)
  {
    View view(scene);
    vtkNew<vtkScreenDoorPass> pass;
    view.SetPass(pass);
    for (vtkIdType i = static_cast<vtkIdType>(scene.Opaque.size());
         i < view.Renderer->GetViewProps()->GetNumberOfItems(); ++i)
    {
      vtkProp::SafeDownCast(view.Renderer->GetViewProps()->GetItemAsObject(static_cast<int>(i)))
        ->SetVisibility(translucent);
    }
    view.Render();
    std::vector<float> values(static_cast<std::size_t>(scene.Width) * scene.Height);
    view.Window->GetZbufferData(0, 0, scene.Width - 1, scene.Height - 1, values.data());
    return values;
  };
  const std::vector<float> opaque = depths(false);
  EXPECT_LT(*std::min_element(opaque.begin(), opaque.end()), 0.6f);
  EXPECT_EQ(depths(true), opaque);
}

//------------------------------------------------------------------------------
TEST_F(TestScreenDoorWindow, OptionsOutOfRangeAreErrorsAndChangeNothing)
{
  vtkNew<vtkScreenDoorPass> pass;
  const vtkMTimeType before = pass->GetMTime();
  for (int value : { -1, 3 })
  {
    pass->SetMask(value);
    std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("Mask is " + std::to_string(value) + ", expected ordered-4x4 (0)"), std::string::npos)
      << messages[0];
    pass->SetOffset(value);
    messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("Offset is " + std::to_string(value) + ", expected none (0)"), std::string::npos)
      << messages[0];
  }
  EXPECT_EQ(pass->GetMTime(), before);
  EXPECT_EQ(pass->GetOption("mask"), "blue-noise");
  EXPECT_EQ(pass->GetOption("offset"), "object");
  EXPECT_TRUE(pass->SetOption("mask", "ordered-8x8"));
  EXPECT_EQ(pass->GetMask(), vtkScreenDoorPass::Ordered8x8);
}
