// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fragments that a trace keeps are those of the scene, each in its place, with its depth and colour.
#include "RenderTest.h"

#include <vtkFragmentTracePass.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <tuple>

namespace
{
using Fragment = vtkStorageSimulator::Fragment;

/// Of all pixels, row by row, in the order of drawing.
std::vector<Fragment> ExpectedFragments(const AnalyticScene& scene)
{
  std::vector<Fragment> fragments;
  for (int y = 0; y < scene.Height; ++y)
  {
    for (int x = 0; x < scene.Width; ++x)
    {
      const auto covers = [x, y](const Rectangle& r)
      { return x >= r.Left && x < r.Right && y >= r.Bottom && y < r.Top; };
      double opaque = 1;
      for (const Rectangle& rectangle : scene.Opaque)
      {
        opaque = covers(rectangle) ? std::min(opaque, rectangle.Depth) : opaque;
      }
      for (const Layer& layer : scene.Translucent)
      {
        for (const Rectangle& r : layer)
        {
          if (covers(r) && r.Depth < opaque)
          {
            fragments.push_back({ x, y, static_cast<float>(r.Depth),
              { { static_cast<float>(r.Rgb[0]), static_cast<float>(r.Rgb[1]), static_cast<float>(r.Rgb[2]),
                static_cast<float>(r.Alpha) } } });
          }
        }
      }
    }
  }
  return fragments;
}

void ExpectFragments(const std::vector<Fragment>& traced, const AnalyticScene& scene, bool drawOrder, float tolerance)
{
  std::vector<Fragment> expected = ExpectedFragments(scene);
  std::vector<Fragment> given = traced;
  ASSERT_GT(expected.size(), 0u);
  ASSERT_EQ(given.size(), expected.size());
  for (auto* fragments : { &expected, &given })
  {
    if (!drawOrder)
    {
      std::sort(fragments->begin(), fragments->end(),
        [](const Fragment& a, const Fragment& b) { return std::tie(a.Y, a.X, a.Depth) < std::tie(b.Y, b.X, b.Depth); });
    }
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_EQ(given[i].X, expected[i].X) << i;
    ASSERT_EQ(given[i].Y, expected[i].Y) << i;
    ASSERT_EQ(given[i].Depth, expected[i].Depth) << i;
    for (int channel = 0; channel < 4; ++channel)
    {
      ASSERT_NEAR(given[i].Color[channel], expected[i].Color[channel], tolerance) << i << ", channel " << channel;
    }
  }
}

struct Kept
{
  std::string Name;
  int ColorFormat;
  double MiB;      // memory limit
  float Tolerance; // of colours
};

void PrintTo(const Kept& value, std::ostream* os)
{
  *os << value.Name;
}
}

class TestFragmentTracePass
  : public RenderTest
  , public testing::WithParamInterface<Kept>
{
};

//------------------------------------------------------------------------------
TEST_P(TestFragmentTracePass, KeepsEveryFragment)
{
  const AnalyticScene scene = RandomLayers(200, 150, 13, 60, 0.02, 0.5);
  vtkNew<vtkABufferPass> exact;
  exact->GetStorage()->SetColorFormat(GetParam().ColorFormat);
  const Picture right = Draw(scene, exact);

  View view(scene);
  vtkNew<vtkFragmentTracePass> trace;
  trace->GetStorage()->SetColorFormat(GetParam().ColorFormat);
  trace->GetStorage()->SetMemoryLimit(GetParam().MiB);
  view.SetPass(trace);
  for (int frame = 0; frame < 2; ++frame)
  {
    EXPECT_EQ(Compare(right, view.Render()).Largest, 0) << "frame " << frame;
    EXPECT_EQ(trace->GetStatistics()->GetTiles() > 1, GetParam().MiB > 0);
    EXPECT_EQ(trace->GetStatistics()->GetFragments(), static_cast<vtkTypeInt64>(trace->GetFragments().size()));
    ExpectFragments(trace->GetFragments(), scene, KeepsDrawOrder(view), GetParam().Tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Storages, TestFragmentTracePass,
  testing::Values(Kept{ "Half", vtkFragmentStorage::HalfFloat, 0, 1.0f / 2048 },
    Kept{ "Bytes", vtkFragmentStorage::RGBA8, 0, 0.5f / 255 + 1e-5f },
    Kept{ "HalfInTiles", vtkFragmentStorage::HalfFloat, 1, 1.0f / 2048 },
    Kept{ "BytesInTiles", vtkFragmentStorage::RGBA8, 1, 0.5f / 255 + 1e-5f }),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestFragmentTrace = RenderTest;

// More than the rounds after which some drivers end a loop.
TEST_F(TestFragmentTrace, KeepsADeepPixel)
{
  AnalyticScene scene;
  scene.Width = 40;
  scene.Height = 30;
  Layer deep;
  for (int i = 0; i < 100000; ++i)
  {
    const int shuffled = static_cast<int>(i * 24977LL % 100000) % 65535 + 1;
    deep.push_back({ 17, 11, 19, 12, shuffled / 131072.0, { { (i % 256) / 255.0, 0, 1 } }, (1 + i % 3) / 255.0 });
  }
  scene.Translucent = { deep };
  View view(scene);
  vtkNew<vtkFragmentTracePass> trace;
  view.SetPass(trace);
  view.Render();
  ASSERT_EQ(trace->GetFragments().size(), 200000u);
  if (KeepsDrawOrder(view))
  {
    ExpectFragments(trace->GetFragments(), scene, true, 1.0f / 2048);
  }
}

//------------------------------------------------------------------------------
TEST_F(TestFragmentTrace, KeepsNothingOfTheFrameBefore)
{
  const AnalyticScene scene = RandomLayers(60, 40, 5, 10, 0.1, 0.5);
  View view(scene);
  vtkNew<vtkFragmentTracePass> trace;
  view.SetPass(trace);
  view.Render();
  EXPECT_GT(trace->GetFragments().size(), 0u);
  view.Renderer->RemoveAllViewProps();
  view.Render();
  EXPECT_EQ(trace->GetFragments().size(), 0u);
}

//------------------------------------------------------------------------------
TEST_F(TestFragmentTrace, SeveralSamplesAreAnError)
{
  const AnalyticScene scene = RandomLayers(60, 40, 5, 10, 0.1, 0.5);
  View view(scene, 4);
  vtkNew<vtkFragmentTracePass> trace;
  view.SetPass(trace);
  view.Render();
  const auto messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("a pixel has 4 samples, expected 1"), std::string::npos) << messages[0];
  EXPECT_EQ(trace->GetFragments().size(), 0u);
  EXPECT_EQ(trace->GetStatistics()->GetFallback(), "peeling");
}

//------------------------------------------------------------------------------
// A fragment of opacity a and transmission t hides a * (1 - t): with the mean of the transmission colour.
TEST_F(TestFragmentTrace, TakesTheMeanOfTransmissionColours)
{
  AnalyticScene scene;
  scene.Width = 20;
  scene.Height = 10;
  scene.Translucent = { { { 0, 0, 20, 10, 0.25, { { 0.5, 0.25, 0 } }, 0.5, { { 0.6, 0.3, 0 } } } } };
  View view(scene);
  vtkNew<vtkFragmentTracePass> trace;
  view.SetPass(trace);
  view.Render();
  const auto messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("mean"), std::string::npos) << messages[0];
  ASSERT_EQ(trace->GetFragments().size(), 200u);
  const auto& color = trace->GetFragments().front().Color;
  EXPECT_NEAR(color[3], 0.5 * 0.7, 1e-3);
  EXPECT_NEAR(color[0] * color[3], 0.5 * 0.5, 1e-3) << "as much light as without";
}
