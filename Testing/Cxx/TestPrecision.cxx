// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colours above 1, far and near planes a long way apart, opacity 1 among translucent fragments, surfaces that coincide.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFragmentStorage.h>
#include <vtkLight.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
enum class Technique
{
  Exact,
  Adaptive
};

void PrintTo(Technique technique, std::ostream* os)
{
  *os << (technique == Technique::Exact ? "exact" : "adaptive");
}

vtkSmartPointer<vtkFragmentListPass> New(Technique technique)
{
  if (technique == Technique::Exact)
  {
    return vtkSmartPointer<vtkABufferPass>::New();
  }
  return vtkSmartPointer<vtkAdaptiveTransparencyPass>::New();
}

vtkSmartPointer<vtkActor> NewPlane(double distance, const Reference::Color& rgb, double alpha)
{
  vtkNew<vtkPlaneSource> source; // as wide as the view at any distance
  source->SetOrigin(-2 * distance, -2 * distance, -distance);
  source->SetPoint1(2 * distance, -2 * distance, -distance);
  source->SetPoint2(-2 * distance, 2 * distance, -distance);
  source->Update();
  return NewUnlitActor(source->GetOutput(), rgb, alpha);
}

class TestPrecision
  : public RenderTest
  , public testing::WithParamInterface<Technique>
{
};
}

//------------------------------------------------------------------------------
TEST_P(TestPrecision, LightsAboveOneKeepTheirColor)
{
  for (int format : { vtkFragmentStorage::HalfFloat, vtkFragmentStorage::RGBA8 })
  {
    View view(64, 48);
    vtkNew<vtkPlaneSource> source;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.5, 0.25, 0);
    actor->GetProperty()->SetOpacity(0.3);
    view.Renderer->AddActor(actor);
    vtkNew<vtkLight> light;
    light->SetLightTypeToHeadlight();
    light->SetIntensity(4);
    view.Renderer->AddLight(light);
    view.Renderer->SetBackground(0, 0, 0);
    view.Renderer->ResetCamera();
    const auto pass = New(GetParam());
    pass->GetStorage()->SetColorFormat(format);
    view.SetPass(pass);
    const Picture drawn = view.Render();
    const bool bytes = format == vtkFragmentStorage::RGBA8; // which end at 1
    EXPECT_NEAR(drawn.At(32, 24, 0), 255 * 0.3 * (bytes ? 1 : 2), 2);
    EXPECT_NEAR(drawn.At(32, 24, 1), 255 * 0.3 * 1, 2);
  }
}

//------------------------------------------------------------------------------
// From 1e-3 to 1e6, 24 bits tell 1 from 1.001 and 1000 from 1500. Whatever is drawn first, the nearer is in front.
TEST_P(TestPrecision, OrdersBetweenPlanesFarApart)
{
  for (const auto& distances : { std::array<double, 2>{ { 1, 1.001 } }, { { 1000, 1500 } } })
  {
    for (bool nearFirst : { true, false })
    {
      View view(64, 48);
      view.Renderer->SetBackground(0, 0, 0);
      vtkCamera* camera = view.Renderer->GetActiveCamera();
      camera->SetPosition(0, 0, 0);
      camera->SetFocalPoint(0, 0, -1);
      camera->SetClippingRange(1e-3, 1e6);
      const auto nearer = NewPlane(distances[0], { { 1, 0, 0 } }, 0.5);
      const auto farther = NewPlane(distances[1], { { 0, 1, 0 } }, 0.5);
      view.Renderer->AddActor(nearFirst ? nearer : farther);
      view.Renderer->AddActor(nearFirst ? farther : nearer);
      view.SetPass(New(GetParam()));
      const Picture drawn = view.Render();
      EXPECT_NEAR(drawn.At(32, 24, 0), 255 * 0.5, 1) << distances[0] << " " << nearFirst;
      EXPECT_NEAR(drawn.At(32, 24, 1), 255 * 0.25, 1) << distances[0] << " " << nearFirst;
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(TestPrecision, OpacityOneHidesWhatLiesBehind)
{
  const auto draw = [](bool behind)
  {
    AnalyticScene scene;
    const auto whole = [](double depth, const Reference::Color& rgb, double alpha) {
      return Rectangle{ 0, 0, 400, 300, depth, rgb, alpha };
    };
    for (int i = 0; i < 12; ++i)
    {
      scene.Translucent.push_back({ whole((8 + 4 * i) / 64.0, { { 0.2, 0.6, 1 } }, 0.2) });
    }
    // One actor: a part of it is opaque, so that all of it is drawn among the translucent.
    scene.Translucent.push_back(
      { { 0, 0, 200, 300, 0.5, { { 1, 0.2, 0.2 } }, 1 }, { 200, 0, 400, 300, 0.5, { { 1, 0.2, 0.2 } }, 0.4 } });
    const auto hidden = [](const Layer& layer) { return layer[0].Depth > 0.5; };
    if (!behind)
    {
      scene.Translucent.erase(
        std::remove_if(scene.Translucent.begin(), scene.Translucent.end(), hidden), scene.Translucent.end());
    }
    return Draw(scene, New(GetParam()));
  };
  const Picture with = draw(true);
  const Picture without = draw(false);
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_EQ(with.At(100, 150, channel), without.At(100, 150, channel));
  }
  EXPECT_NE(with.At(300, 150, 2), without.At(300, 150, 2)) << "where it is translucent";
}

//------------------------------------------------------------------------------
// Two of opacity a are as one of 1 - (1 - a)^2. Dual depth peeling draws one of them.
TEST_P(TestPrecision, IdenticalSpheresBothCount)
{
  constexpr double Opacity = 0.3;
  const auto draw = [](int samples, const std::vector<double>& opacities)
  {
    View view(200, 160, samples);
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(40);
    source->SetPhiResolution(40);
    source->Update();
    for (double opacity : opacities)
    {
      view.Renderer->AddActor(NewUnlitActor(source->GetOutput(), { { 0.9, 0.6, 0.3 } }, opacity));
    }
    view.Renderer->ResetCamera();
    view.SetPass(New(GetParam()));
    return view.Render();
  };
  for (int samples : { 0, 4 })
  {
    const Picture two = draw(samples, { Opacity, Opacity });
    const Picture one = draw(samples, { 1 - std::pow(1 - Opacity, 2) });
    const PictureDifference difference = Compare(two, one);
    EXPECT_LE(difference.Largest, 1) << difference << " samples " << samples;
    EXPECT_GT(Compare(two, draw(samples, { Opacity })).Largest, 20) << "samples " << samples;
    EXPECT_EQ(Compare(two, draw(samples, { Opacity, Opacity })).Largest, 0) << "in each run";
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, TestPrecision, testing::Values(Technique::Exact, Technique::Adaptive),
  [](const auto& info) { return testing::PrintToString(info.param); });
