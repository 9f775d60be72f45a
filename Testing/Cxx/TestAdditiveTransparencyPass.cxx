// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Additive blending: the sum of opacity times colour, and all of what lies behind.
#include "RenderTest.h"

#include <vtkAdditiveTransparencyPass.h>
#include <vtkTranslucencyStatistics.h>

namespace
{
Reference::Pixel Add(const std::vector<Reference::Fragment>& fragments)
{
  Reference::Pixel pixel;
  for (const Reference::Fragment& fragment : fragments)
  {
    for (int c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += fragment.Alpha * fragment.Rgb[c];
    }
  }
  return pixel;
}

class TestAdditive
  : public RenderTest
  , public testing::WithParamInterface<int>
{
protected:
  void ExpectSum(const AnalyticScene& scene)
  {
    for (const AnalyticScene& ordered : { scene, scene.Reversed() })
    {
      View view(ordered, GetParam());
      vtkNew<vtkAdditiveTransparencyPass> pass;
      view.SetPass(pass);
      const PictureDifference difference = Compare(view.Render(), ordered.Compute(Add));
      EXPECT_LE(difference.Largest, 1) << difference; // rounded once
      view.Render();
      EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
      EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    }
  }
};
}

//------------------------------------------------------------------------------
TEST_P(TestAdditive, IsTheSumOfTheLayers)
{
  this->ExpectSum(RandomLayers(200, 150, 211, 12, 0.01, 0.1));
}

//------------------------------------------------------------------------------
TEST_P(TestAdditive, SaturatesWhereTheSumIsTooBright)
{
  this->ExpectSum(RandomLayers(200, 150, 212, 12, 0.2, 0.8));
}

//------------------------------------------------------------------------------
TEST_P(TestAdditive, LosesNoFaintLayer)
{
  this->ExpectSum(RandomLayers(200, 150, 213, 300, 0.0005, 0.0015)); // each less than half of 1/255
}

//------------------------------------------------------------------------------
TEST_P(TestAdditive, IsTheSumOfTheCells)
{
  this->ExpectSum(RandomMosaic(200, 150, 214, 8, 0.02, 0.1));
}

INSTANTIATE_TEST_SUITE_P(Samples, TestAdditive, testing::Values(0, 4),
  [](const auto& info) { return info.param > 0 ? "MultiSampled" : "OneSample"; });
