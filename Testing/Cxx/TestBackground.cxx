// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// What is opaque behind surfaces that refract, disperse or diffuse. All is seen in parallel projection along -z, a unit
// of length being a pixel.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTranslucencyMaterial.h>
#include <vtkTranslucencyPass.h>
#include <vtkTranslucencyStatistics.h>

#include <cmath>

namespace
{
constexpr int Size = 80;
constexpr double Back = -100;                                               // of what is opaque
const Reference::Color Bright{ { 230 / 255.0, 178 / 255.0, 102 / 255.0 } }; // that the framebuffer holds

class BackgroundView : public View
{
public:
  explicit BackgroundView(int samples = 0)
    : View(Size, Size, samples)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(Size / 2);
    camera->SetPosition(0, 0, 200);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(1, 400);
  }

  // From one x to another.
  void AddWall(double left, double right, double z, const Reference::Color& color)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(left, -Size, z);
    plane->SetPoint1(right, -Size, z);
    plane->SetPoint2(left, Size, z);
    plane->Update();
    this->Renderer->AddActor(NewUnlitActor(plane->GetOutput(), color, 1));
  }

  // A lit, black surface that lets through a transmission colour.
  vtkActor* AddGlass(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0, 0, 0);
    actor->ForceTranslucentOn();
    vtkTranslucencyPass::SetTransmissionColor(actor, 1, 1, 1);
    vtkTranslucencyMaterial::SetMaterial(actor, this->Material);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkActor* AddBall()
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(30);
    ball->SetThetaResolution(60);
    ball->SetPhiResolution(40);
    return this->AddGlass(ball);
  }

  // A box whose front is turned by an angle round y.
  vtkActor* AddSlab(double thickness, double angle)
  {
    vtkNew<vtkCubeSource> box;
    box->SetXLength(4 * Size);
    box->SetYLength(4 * Size);
    box->SetZLength(thickness);
    vtkActor* slab = this->AddGlass(box);
    slab->RotateY(angle);
    return slab;
  }

  Picture Draw(const std::string& technique, const Settings& settings = {})
  {
    this->Pass = NewTechnique(technique, settings);
    this->SetPass(this->Pass);
    return this->Render();
  }

  vtkNew<vtkTranslucencyMaterial> Material;
  vtkSmartPointer<vtkTranslucencyPass> Pass;
};

// Where the picture's middle row goes over from dark to bright, in pixels from its middle.
double FindEdge(const Picture& picture)
{
  double dark = 0;
  for (int x = 0; x < Size; ++x)
  {
    dark += 1 - picture.At(x, Size / 2, 0) / (255 * Bright[0]);
  }
  return dark - Size / 2;
}

using TestBackground = RenderTest;
}

//------------------------------------------------------------------------------
// A uniform background gives that background times the transmission, whoever draws.
TEST_F(TestBackground, LeavesAUniformPictureAsItIs)
{
  const std::vector<std::pair<std::string, Settings>> techniques{ { "exact", {} },
    { "exact", { { "memory_limit", "1" } } }, { "adaptive", { { "memory", "fixed" } } }, { "weighted", {} },
    { "mlab", {} }, { "sorted", {} } };
  const std::array<double, 3> effects[] = { { { 1.5, 0, 0 } }, { { 1, 0.3, 0 } }, { { 1.5, 0, 0.5 } },
    { { 1.4, 0.2, 0.8 } } }; // index, diffusion, dispersion
  for (const int samples : { 0, 4 })
  {
    for (const auto& [technique, settings] : techniques)
    {
      for (const auto& [index, diffusion, dispersion] : effects)
      {
        BackgroundView view(samples);
        view.AddWall(-2 * Size, 2 * Size, Back, Bright);
        vtkActor* slab = view.AddSlab(20, 20);
        view.Material->SetIndexOfRefraction(index);
        view.Material->SetDiffusion(diffusion);
        view.Material->SetDispersion(dispersion);
        const double passes[] = { 0.9, 0.8, 0.95 };
        vtkTranslucencyPass::SetTransmissionColor(slab, passes[0], passes[1], passes[2]);
        const Picture drawn = view.Draw(technique, settings);
        const double bound = technique == "sorted" ? 1.5 : 1; // which rounds each surface
        const int faces = dispersion > 0 ? 6 : 2;             // both of them, or the cubes of both
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(drawn.At(Size / 2, Size / 2, c), 255 * Bright[c] * std::pow(passes[c], faces), bound)
            << technique << ", " << samples << " samples, index " << index << ", diffusion " << diffusion
            << ", dispersion " << dispersion;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// Where a ray meets a slab at an angle a and goes on at b, it is displaced by thickness tan(a - b) / cos(a).
TEST_F(TestBackground, SlabsDisplaceByTheirThickness)
{
  const double degree = std::acos(-1.0) / 180;
  for (const double thickness : { 10.0, 30.0 })
  {
    for (const double angle : { -40.0, 20.0, 40.0 })
    {
      BackgroundView view;
      view.AddWall(-4 * Size, 0, Back, { { 0, 0, 0 } });
      view.AddWall(0, 4 * Size, Back, Bright);
      view.AddSlab(thickness, angle);
      view.Material->SetIndexOfRefraction(1.5);
      const double met = angle * degree;
      const double inside = std::asin(std::sin(met) / 1.5);
      const double expected = thickness * std::tan(met - inside) / std::cos(met);
      EXPECT_NEAR(std::abs(FindEdge(view.Draw("exact"))), std::abs(expected), 0.6) << thickness << ", " << angle;
      // That is near what light does.
      EXPECT_NEAR(expected, thickness * std::sin(met - inside) / std::cos(inside), 0.25 * std::abs(expected));
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestBackground, PanesDisplaceByTheirOwnThickness)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2 * Size, -2 * Size, 0);
  plane->SetPoint1(2 * Size, -2 * Size, 0);
  plane->SetPoint2(-2 * Size, 2 * Size, 0);
  for (const double thickness : { 5.0, 20.0 })
  {
    BackgroundView view;
    view.AddWall(-4 * Size, 0, Back, { { 0, 0, 0 } });
    view.AddWall(0, 4 * Size, Back, Bright);
    view.AddGlass(plane)->RotateY(45);
    view.Material->SetIndexOfRefraction(1.5);
    view.Material->SetThickness(thickness);
    const double met = std::asin(std::sqrt(0.5));
    const double inside = std::asin(std::sin(met) / 1.5);
    EXPECT_NEAR(std::abs(FindEdge(view.Draw("exact"))), thickness * std::tan(met - inside), 0.6);
  }
}

//------------------------------------------------------------------------------
// A step becomes a Gaussian's integral.
TEST_F(TestBackground, DiffusionBlursWithTheDistance)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2 * Size, -2 * Size, 0);
  plane->SetPoint1(2 * Size, -2 * Size, 0);
  plane->SetPoint2(-2 * Size, 2 * Size, 0);
  for (const double behind : { 50.0, 100.0 })
  {
    BackgroundView view;
    view.AddWall(-4 * Size, 0, -behind, { { 0, 0, 0 } });
    view.AddWall(0, 4 * Size, -behind, Bright);
    view.AddGlass(plane);
    view.Material->SetDiffusion(0.08);
    const Picture drawn = view.Draw("exact");
    for (int x = 0; x < Size; ++x)
    {
      const double at = (x + 0.5 - Size / 2) / (0.08 * behind);
      const double expected = 255 * Bright[0] * 0.5 * std::erfc(-at / std::sqrt(2));
      EXPECT_NEAR(drawn.At(x, Size / 2, 0), expected, 0.05 * 255) << x << ", " << behind;
    }
  }
}

//------------------------------------------------------------------------------
// What is bent least is red.
TEST_F(TestBackground, DispersionSpreadsColors)
{
  BackgroundView view;
  const Reference::Color white{ { 1, 1, 1 } };
  view.AddWall(-4 * Size, 0, Back, { { 0, 0, 0 } });
  view.AddWall(0, 4 * Size, Back, white);
  view.AddSlab(40, 40);
  view.Material->SetIndexOfRefraction(1.5);
  view.Material->SetDispersion(0.5);
  const Picture drawn = view.Draw("exact");
  double sum[3] = { 0, 0, 0 };
  for (int x = 0; x < Size; ++x)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += drawn.At(x, Size / 2, c) / 255 - 0.5;
    }
  }
  EXPECT_GT(std::abs(sum[2]), std::abs(sum[1]) + 1);
  EXPECT_GT(std::abs(sum[1]), std::abs(sum[0]) + 1);
}

//------------------------------------------------------------------------------
TEST_F(TestBackground, WhatIsNearerIsNotSeenThroughTheSurface)
{
  for (const double diffusion : { 0.0, 0.2 })
  {
    BackgroundView view;
    view.AddWall(-4 * Size, 4 * Size, Back, Bright);
    view.AddWall(-4 * Size, 0, 80, { { 0, 0, 0 } }); // before the slab
    view.AddSlab(30, 40);
    view.Material->SetIndexOfRefraction(1.5);
    view.Material->SetDiffusion(diffusion);
    const Picture drawn = view.Draw("exact");
    for (int x = Size / 2 + 1; x < Size; ++x)
    {
      EXPECT_NEAR(drawn.At(x, Size / 2, 0), 255 * Bright[0], diffusion > 0 ? 60 : 1) << x;
    }
    EXPECT_NEAR(drawn.At(Size / 2 - 2, Size / 2, 0), 0, 1);
  }
}

//------------------------------------------------------------------------------
TEST_F(TestBackground, CostsNothingUntilSomethingIsSet)
{
  BackgroundView view;
  view.AddWall(-4 * Size, 0, Back, { { 0, 0, 0 } });
  view.AddWall(0, 4 * Size, Back, Bright);
  vtkActor* ball = view.AddBall();
  vtkTranslucencyMaterial::SetMaterial(ball, nullptr);
  const Picture before = view.Draw("exact");
  view.Render();
  const int geometry = view.Pass->GetStatistics()->GetGeometryPasses();
  const int screen = view.Pass->GetStatistics()->GetScreenPasses();
  const vtkTypeInt64 bytes = view.Pass->GetStatistics()->GetBytes();
  vtkTranslucencyMaterial::SetMaterial(ball, view.Material);
  view.Material->SetDispersion(0.5);
  EXPECT_TRUE(view.Render() == before);
  view.Render();
  EXPECT_EQ(view.Pass->GetStatistics()->GetGeometryPasses(), geometry);
  EXPECT_EQ(view.Pass->GetStatistics()->GetScreenPasses(), screen);
  EXPECT_EQ(view.Pass->GetStatistics()->GetBytes(), bytes);
  view.Material->SetIndexOfRefraction(1.5);
  EXPECT_FALSE(view.Render() == before);
  EXPECT_EQ(view.Pass->GetStatistics()->GetGeometryPasses(), geometry + 1);
  EXPECT_EQ(view.Pass->GetStatistics()->GetScreenPasses(), screen + 1);
  EXPECT_GT(view.Pass->GetStatistics()->GetBytes(), bytes);
  view.Material->SetIndexOfRefraction(1);
  EXPECT_TRUE(view.Render() == before);
}

//------------------------------------------------------------------------------
// However many tiles a technique draws.
TEST_F(TestBackground, IsChangedOnce)
{
  Picture pictures[2];
  int tiles[2];
  for (const bool limited : { false, true })
  {
    BackgroundView view;
    view.AddWall(-4 * Size, 0, Back, { { 0, 0, 0 } });
    view.AddWall(0, 4 * Size, Back, Bright);
    view.AddBall();
    view.Material->SetIndexOfRefraction(1.2);
    view.Material->SetDiffusion(0.02);
    pictures[limited ? 1 : 0] = view.Draw("exact", { { "memory_limit", limited ? "0.05" : "64" } });
    tiles[limited ? 1 : 0] = view.Pass->GetStatistics()->GetTiles();
  }
  EXPECT_EQ(tiles[0], 1);
  EXPECT_GT(tiles[1], 1);
  EXPECT_TRUE(pictures[0] == pictures[1]);
}

//------------------------------------------------------------------------------
// A mirrored ball is the same ball.
TEST_F(TestBackground, MirroredBodiesRefractTheSame)
{
  Picture pictures[2];
  for (const bool mirrored : { false, true })
  {
    BackgroundView view;
    view.AddWall(-4 * Size, 0, Back, { { 0, 0, 0 } });
    view.AddWall(0, 4 * Size, Back, Bright);
    view.AddBall()->SetScale(1, mirrored ? -1 : 1, 1);
    view.Material->SetIndexOfRefraction(1.2);
    pictures[mirrored ? 1 : 0] = view.Draw("exact");
  }
  EXPECT_LE(Compare(Crop(pictures[0], 20, 30, 40, 20), Crop(pictures[1], 20, 30, 40, 20)).RootMeanSquare, 0.02);
}

//------------------------------------------------------------------------------
TEST_F(TestBackground, IsNotBentWithoutNormals)
{
  BackgroundView view;
  view.AddWall(-4 * Size, 0, Back, { { 0, 0, 0 } });
  view.AddWall(0, 4 * Size, Back, Bright);
  vtkActor* ball = view.AddBall();
  ball->GetProperty()->LightingOff();
  const Picture before = view.Draw("exact");
  view.Material->SetIndexOfRefraction(1.5);
  EXPECT_TRUE(view.Render() == before);
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("without normals"), std::string::npos) << messages[0];
}

//------------------------------------------------------------------------------
TEST_F(TestBackground, RefusesNumbersOutOfRange)
{
  const double nan = std::nan("");
  vtkNew<vtkTranslucencyMaterial> material;
  for (const double number : { 0.5, -1.0, nan })
  {
    material->SetIndexOfRefraction(number);
    material->SetThickness(number > 0 ? -0.5 : number);
    material->SetDiffusion(number > 0 ? 1.5 : number);
    material->SetDispersion(number > 0 ? 1.5 : number);
  }
  EXPECT_EQ(TakeMessages().size(), 12u);
  EXPECT_EQ(material->GetIndexOfRefraction(), 1);
  EXPECT_EQ(material->GetThickness(), 0);
  EXPECT_EQ(material->GetDiffusion(), 0);
  EXPECT_EQ(material->GetDispersion(), 0);
}
