// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The look of lit, curved, coloured surfaces: VTK's regression harness with baselines, and a strict comparison beside
// it.
//
// A test more is a row more in Looks[], and a baseline of that name in Testing/Data/Baseline. Where there is none, the
// failing test writes the candidate into the current folder.
#include "RenderTest.h"
#include "StrictComparison.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTesting.h>

#include <OpenImageIO/imagebufalgo.h>

#include <cmath>

namespace
{
constexpr int Size = 200;
constexpr double HarnessThreshold = 10; // VTK's own measure, and its default

struct Look
{
  std::string Name; // of the test and of the baseline
  void (*Arrange)(vtkRenderer* renderer);
  vtkSmartPointer<vtkTranslucencyPass> (*NewPass)();
};

void PrintTo(const Look& value, std::ostream* os)
{
  *os << value.Name;
}

vtkActor* Add(vtkRenderer* renderer, vtkAlgorithm* source, const Reference::Color& color, double opacity)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
  return actor;
}

void AddCone(vtkRenderer* renderer)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(40);
  cone->SetHeight(2.4);
  cone->SetRadius(0.6);
  Add(renderer, cone, { { 0.9, 0.8, 0.6 } }, 1);
}

void LookAtTheScene(vtkRenderer* renderer)
{
  renderer->SetBackground(0.2, 0.2, 0.4);
  renderer->SetBackground2(0.6, 0.6, 0.8);
  renderer->GradientBackgroundOn();
  renderer->GetActiveCamera()->SetPosition(1.5, 2, 6);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.5);
}

/// Seven balls that overlap each other and the cone, each drawn with its back.
void ArrangeSpheres(vtkRenderer* renderer)
{
  AddCone(renderer);
  for (int i = 0; i < 7; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(32);
    sphere->SetRadius(0.8);
    sphere->SetCenter(0.9 * std::cos(i * 0.898), 0.9 * std::sin(i * 0.898), 0.3 * (i % 3) - 0.3);
    vtkActor* ball = Add(renderer, sphere, { { (i % 2) * 1.0, (i % 3) / 2.0, (i % 4) / 3.0 } }, 0.2 + 0.08 * i);
    ball->GetProperty()->SetSpecular(0.4);
    ball->GetProperty()->SetSpecularPower(20);
  }
  LookAtTheScene(renderer);
}

/// Panes that cut through each other and through the cone: no order of drawing whole panes is right.
void ArrangePanes(vtkRenderer* renderer)
{
  AddCone(renderer);
  const Reference::Color colors[] = { { { 1, 0.2, 0.2 } }, { { 0.2, 1, 0.2 } }, { { 0.2, 0.4, 1 } },
    { { 1, 1, 0.2 } } };
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkPlaneSource> plane;
    vtkActor* pane = Add(renderer, plane, colors[i], 0.45);
    pane->SetScale(2.6, 2.2, 1);
    pane->RotateY(20 + 45 * i);
    pane->RotateX(15);
  }
  LookAtTheScene(renderer);
}

vtkSmartPointer<vtkTranslucencyPass> NewExact()
{
  return vtkSmartPointer<vtkABufferPass>::New();
}

/// Fewer than there are layers: nodes have to be removed.
vtkSmartPointer<vtkTranslucencyPass> NewAdaptiveOfFourNodes()
{
  return NewAdaptive(4, Reference::Removal::Underestimate);
}

const Look Looks[] = {
  { "TestABufferPassSpheres", ArrangeSpheres, NewExact },
  { "TestABufferPassPanes", ArrangePanes, NewExact },
  { "TestAdaptiveTransparencyPassSpheres", ArrangeSpheres, NewAdaptiveOfFourNodes },
};

std::string Baseline(const std::string& name)
{
  return std::string(TRANSLUCENCY_BASELINES) + "/" + name + ".png";
}

OIIO::ImageBuf ToImage(const Picture& picture)
{
  OIIO::ImageBuf image(OIIO::ImageSpec(picture.Width, picture.Height, 3, OIIO::TypeDesc::FLOAT));
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const float pixel[] = { static_cast<float>(picture.At(x, y, 0) / 255),
        static_cast<float>(picture.At(x, y, 1) / 255), static_cast<float>(picture.At(x, y, 2) / 255) };
      image.setpixel(x, picture.Height - 1 - y, pixel); // files begin at the top
    }
  }
  return image;
}

bool PassesHarness(View& view, const std::string& name)
{
  vtkNew<vtkTesting> harness;
  for (const std::string& argument : { std::string("-V"), Baseline(name), std::string("-T"), std::string(".") })
  {
    harness->AddArgument(argument.c_str());
  }
  harness->SetRenderWindow(view.Window);
  return harness->RegressionTest(HarnessThreshold) == vtkTesting::PASSED;
}
}

class TestRegression
  : public RenderTest
  , public testing::WithParamInterface<Look>
{
};

//------------------------------------------------------------------------------
TEST_P(TestRegression, LooksAsItDid)
{
  View view(Size, Size);
  GetParam().Arrange(view.Renderer);
  view.SetPass(GetParam().NewPass());
  const Picture drawn = view.Render();
  EXPECT_TRUE(PassesHarness(view, GetParam().Name));

  const std::string path = Baseline(GetParam().Name);
  OIIO::ImageBuf baseline(path);
  ASSERT_TRUE(baseline.read(0, 0, true, OIIO::TypeDesc::FLOAT)) << path << ": " << baseline.geterror();
  EXPECT_EQ(CompareStrictly(ToImage(drawn), baseline), "");
}

INSTANTIATE_TEST_SUITE_P(
  Baselines, TestRegression, testing::ValuesIn(Looks), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
TEST(TestStrictComparison, SeesADimmedPicture)
{
  OIIO::ImageBuf baseline(Baseline(Looks[0].Name));
  ASSERT_TRUE(baseline.read(0, 0, true, OIIO::TypeDesc::FLOAT));
  EXPECT_EQ(CompareStrictly(baseline, baseline), "");
  const OIIO::ImageBuf dimmed = OIIO::ImageBufAlgo::mul(baseline, 0.8f);
  EXPECT_NE(CompareStrictly(dimmed, baseline), "");
  const OIIO::ImageBuf cropped = OIIO::ImageBufAlgo::cut(baseline, OIIO::ROI(0, Size, 0, Size - 1));
  EXPECT_NE(CompareStrictly(cropped, baseline), "");
}
