// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures with an opacity, over a background that has none: what other programs put over backgrounds of their own.
#include "RenderTest.h"

#include <vtkImageData.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <tuple>

namespace
{
std::string NameOf(const Way& way)
{
  return std::regex_replace(way.Technique + way.Choice, std::regex("-"), "_");
}

// Those that are exact of four layers.
std::vector<Way> ExactWays()
{
  std::vector<Way> ways{ { "adaptive", "memory", "fixed" }, { "peel", "method", "front-to-back" },
    { "peel", "method", "bucket-sort" } };
  for (const char* technique : { "exact", "adaptive", "peel", "mlab", "hybrid", "kbuffer", "sorted", "auto" })
  {
    ways.push_back({ technique, "", "" });
  }
  return ways;
}

// Translucent rectangles and nothing else.
AnalyticScene Layers(int count)
{
  AnalyticScene scene = RandomLayers(30, 30, 91, count, 0.1, 0.8);
  scene.Opaque.clear();
  scene.Width = 40; // beside them there is nothing
  return scene;
}

// Channels of pixels, four each if there is an opacity, in units of 1/255.
std::vector<double> Shoot(
  const AnalyticScene& scene, const Way& way, int samples, int scale, double background, double opacity)
{
  View view(scene, samples);
  view.Window->SetAlphaBitPlanes(1);
  view.Renderer->SetBackground(background, background, background);
  view.Renderer->SetBackgroundAlpha(opacity);
  view.SetTranslucentPass(NewPass(way));
  view.Window->Render();
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(view.Window);
  grabber->SetInputBufferTypeToRGBA();
  grabber->SetScale(scale);
  grabber->SetShouldRerender(scale > 1);
  grabber->ReadFrontBufferOff();
  grabber->Update();
  vtkImageData* image = grabber->GetOutput();
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  return { bytes, bytes + image->GetNumberOfPoints() * image->GetNumberOfScalarComponents() };
}
}

class TestTransparentBackground
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Way, int, int>>
{
protected:
  Way DrawnBy = std::get<0>(this->GetParam());
  std::string Technique = this->DrawnBy.Technique;
  int Samples = std::get<1>(this->GetParam());
  int Scale = std::get<2>(this->GetParam());
};

//------------------------------------------------------------------------------
// The colour, multiplied by the opacity, is that over black; and over white it lets the rest through.
TEST_P(TestTransparentBackground, IsWhatOpaqueOnesAreMadeOf)
{
  const AnalyticScene scene = Layers(9);
  const std::vector<double> transparent = Shoot(scene, this->DrawnBy, this->Samples, this->Scale, 0, 0);
  const std::vector<double> black = Shoot(scene, this->DrawnBy, this->Samples, this->Scale, 0, 1);
  const std::vector<double> white = Shoot(scene, this->DrawnBy, this->Samples, this->Scale, 1, 1);
  ASSERT_EQ(transparent.size(), 4u * this->Scale * this->Scale * scene.Width * scene.Height);
  ASSERT_EQ(black.size(), transparent.size());
  double color = 0;
  double opacity = 0;
  double most = 0;
  double least = 255;
  for (std::size_t i = 0; i < transparent.size(); ++i)
  {
    const double alpha = transparent[i / 4 * 4 + 3];
    most = std::max(most, alpha);
    least = std::min(least, alpha);
    if (i % 4 != 3)
    {
      color = std::max(color, std::abs(transparent[i] - black[i]));
      opacity = std::max(opacity, std::abs(255 - alpha + transparent[i] - white[i]));
    }
  }
  EXPECT_LE(color, 1);
  EXPECT_EQ(least, 0) << "the background has an opacity";
  if (this->Technique == "additive") // hides nothing: over white it is not seen
  {
    EXPECT_EQ(most, 0);
  }
  else if (this->Technique !=
    "vtk-oit") // which leaves no opacity behind, and so is told of in Documentation/Behaviour.md
  {
    const bool inBytes = this->Technique == "blend" || this->Technique == "vtk-peel"; // layer by layer
    EXPECT_LE(opacity, inBytes ? 2.5 : 1.5);
    EXPECT_GT(most, 128) << "surfaces have no opacity";
  }
  if (this->Technique == "vtk-peel" && this->Samples > 1)
  {
    TakeMessages(); // that it can't
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, TestTransparentBackground,
  testing::Combine(testing::ValuesIn(AllWays()), testing::Values(0, 4), testing::Values(1, 2)),
  [](const auto& info)
  {
    return NameOf(std::get<0>(info.param)) + "Samples" + std::to_string(std::get<1>(info.param)) + "Scale" +
      std::to_string(std::get<2>(info.param));
  });

class TestTransparentBackgroundOf
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Way, int>>
{
};

//------------------------------------------------------------------------------
TEST_P(TestTransparentBackgroundOf, FewLayersIsExact)
{
  AnalyticScene scene = Layers(4);
  const std::vector<double> drawn = Shoot(scene, std::get<0>(this->GetParam()), std::get<1>(this->GetParam()), 1, 0, 0);
  scene.Background = { { 0, 0, 0 } };
  const Picture color = scene.Compute(Reference::CompositeExact);
  scene.Background = { { 1, 1, 1 } };
  const Picture overWhite = scene.Compute(Reference::CompositeExact);
  for (std::size_t pixel = 0; pixel < color.Rgb.size() / 3; ++pixel)
  {
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      ASSERT_NEAR(drawn[4 * pixel + channel], color.Rgb[3 * pixel + channel], 1.1) << "pixel " << pixel;
    }
    ASSERT_NEAR(drawn[4 * pixel + 3], 255 - (overWhite.Rgb[3 * pixel] - color.Rgb[3 * pixel]), 1.1)
      << "pixel " << pixel;
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, TestTransparentBackgroundOf,
  testing::Combine(testing::ValuesIn(ExactWays()), testing::Values(0, 4)),
  [](const auto& info)
  { return NameOf(std::get<0>(info.param)) + "Samples" + std::to_string(std::get<1>(info.param)); });
