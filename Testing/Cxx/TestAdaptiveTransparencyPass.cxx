// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The estimate of the error, drawn as a picture, and tolerances of it, against the same computed on the CPU.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using Adaptive = vtkAdaptiveTransparencyPass;
using Reference::Fragment;
using Reference::Removal;

constexpr double Bound = 2; // of 255: the framebuffer rounds

Reference::Pixel Grey(double value)
{
  const double grey = std::min(value, 1.0);
  return { { { grey, grey, grey } }, 0 };
}

// What Show draws, of fragments in the order of their insertion.
Compositor Shown(int show, int memory, int nodes, Removal rule)
{
  return [=](std::vector<Fragment> fragments)
  {
    if (memory == Adaptive::Variable) // the fragment drawn last is inserted first
    {
      std::reverse(fragments.begin(), fragments.end());
    }
    Reference::VisibilityFunction visibility(nodes, rule);
    for (const Fragment& fragment : fragments)
    {
      visibility.Insert(fragment.Depth, fragment.Alpha);
    }
    return fragments.empty() ? Reference::Pixel{}
                             : Grey(show == Adaptive::Error ? visibility.EstimateError() / Adaptive::DefaultWhite
                                                            : visibility.GetNodes().size() / 64.0);
  };
}

Compositor ToTolerance(int nodes, Removal rule, double tolerance)
{
  return [=](const std::vector<Fragment>& fragments)
  { return Reference::CompositeToTolerance(fragments, nodes, rule, tolerance); };
}

// Each surface twice at the same place.
AnalyticScene Coincident()
{
  AnalyticScene scene = RandomLayers(60, 45, 7, 12, 0.05, 0.5);
  const std::vector<Layer> once = scene.Translucent;
  scene.Translucent.insert(scene.Translucent.end(), once.begin(), once.end());
  return scene;
}

std::vector<AnalyticScene> Scenes()
{
  return { RandomLayers(60, 45, 2, 30, 0.02, 0.8), RandomMosaic(40, 30, 6, 100, 0.02, 0.3) };
}

void AddSpheres(vtkRenderer* renderer)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 40; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(40);
    sphere->SetPhiResolution(30);
    sphere->SetRadius(0.4 + 0.3 * unit(random));
    sphere->SetCenter(2 * unit(random), 1.5 * unit(random), 2 * unit(random));
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(unit(random), unit(random), unit(random));
    actor->GetProperty()->SetOpacity(0.3);
    renderer->AddActor(actor);
  }
  renderer->ResetCamera();
}
}

//------------------------------------------------------------------------------
// Of coincident fragments each is hidden by those drawn after it, wherever functions lie.
using TestFixedMemory = RenderTest;

TEST_F(TestFixedMemory, IsExactOfCoincidentFragmentsWithEnoughNodes)
{
  const AnalyticScene scene = Coincident();
  const Picture exact = scene.Compute(Reference::CompositeExact);
  for (int samples : { 0, 4 })
  {
    View view(scene, samples);
    for (int section : { vtkTranslucencyPass::Automatic, vtkTranslucencyPass::Spinlock })
    {
      for (int nodes : { 4, 16 })
      {
        SCOPED_TRACE(std::to_string(samples) + " " + std::to_string(section) + " " + std::to_string(nodes));
        const auto pass = NewAdaptive(nodes, Removal::Underestimate);
        pass->SetMemory(Adaptive::Fixed);
        pass->SetCriticalSection(section);
        view.SetPass(pass);
        const PictureDifference difference = Compare(view.Render(), exact);
        if (!KeepsDrawOrder(view))
        {
          GTEST_SKIP() << "the driver inserts fragments in an order of its own";
        }
        EXPECT_EQ(difference.Largest <= Bound, nodes == 16) << difference;
      }
    }
  }
}

//------------------------------------------------------------------------------
using TestErrorEstimate = RenderTest;

TEST_F(TestErrorEstimate, IsDrawnAsComputedLikeTheNodes)
{
  for (const AnalyticScene& scene : Scenes())
  {
    for (int memory : { Adaptive::Variable, Adaptive::Fixed })
    {
      for (int samples : { 0, 4 })
      {
        View view(scene, samples);
        for (const auto& [nodes, rule] :
          { std::pair(1, Removal::Underestimate), std::pair(5, Removal::Overestimate), std::pair(8, Removal::Mixed) })
        {
          const auto pass = NewAdaptive(nodes, rule);
          pass->SetMemory(memory);
          view.SetPass(pass);
          for (int show : { Adaptive::Error, Adaptive::Nodes })
          {
            SCOPED_TRACE(std::to_string(scene.Translucent.size()) + " " + std::to_string(memory) + " " +
              std::to_string(samples) + " " + std::to_string(nodes) + " " + std::to_string(show));
            pass->SetShow(show);
            const PictureDifference difference =
              Compare(view.Render(), scene.Compute(Shown(show, memory, nodes, rule)));
            EXPECT_LE(difference.Largest, Bound) << difference;
            EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestErrorEstimate, IsBlackWithAsManyNodesAsFragments)
{
  const AnalyticScene scene = RandomLayers(100, 75, 8, 16, 0.02, 0.8);
  const Picture black = scene.Compute(
    [](const std::vector<Fragment>& fragments) { return fragments.empty() ? Reference::Pixel{} : Grey(0); });
  for (int memory : { Adaptive::Variable, Adaptive::Fixed })
  {
    const auto pass = NewAdaptive(16, Removal::Underestimate);
    pass->SetMemory(memory);
    pass->SetShow(Adaptive::Error);
    EXPECT_LE(Compare(Draw(scene, pass), black).Largest, 0.5); // the background is rounded
    pass->SetNodeCount(2);
    EXPECT_GT(Compare(Draw(scene, pass), black).Largest, 20);
  }
}

//------------------------------------------------------------------------------
using TestTolerance = RenderTest;

TEST_F(TestTolerance, GivesThePictureAndTheNodesThatAreComputed)
{
  std::vector<AnalyticScene> scenes = Scenes();
  scenes.push_back(Coincident());
  for (const AnalyticScene& scene : scenes)
  {
    for (int samples : { 0, 4 })
    {
      View view(scene, samples);
      for (const auto& [nodes, tolerance] : { std::pair(1, 0.02), std::pair(4, 0.001), std::pair(24, 1e-7) })
      {
        SCOPED_TRACE(std::to_string(scene.Translucent.size()) + " " + std::to_string(samples) + " " +
          std::to_string(nodes) + " " + std::to_string(tolerance));
        const auto pass = NewAdaptive(nodes, Removal::Underestimate);
        pass->SetTolerance(tolerance);
        view.SetPass(pass);
        const PictureDifference picture =
          Compare(view.Render(), scene.Compute(ToTolerance(nodes, Removal::Underestimate, tolerance)));
        EXPECT_LE(picture.Largest, Bound) << picture;
        EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");

        pass->SetShow(Adaptive::Nodes);
        const Compositor used = [n = nodes, t = tolerance](const std::vector<Fragment>& fragments)
        {
          int count = 0;
          Reference::CompositeToTolerance(fragments, n, Removal::Underestimate, t, &count);
          return fragments.empty() ? Reference::Pixel{} : Grey(count / 64.0);
        };
        const PictureDifference difference = Compare(view.Render(), scene.Compute(used));
        EXPECT_LE(difference.Largest, Bound) << difference;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The smaller, the closer to the exact picture, and the more nodes; by how much is in the class's header.
TEST_F(TestTolerance, SmallerIsNeverFartherFromExact)
{
  const AnalyticScene rectangles = RandomLayers(100, 75, 9, 60, 0.02, 0.3);
  for (int samples : { 0, 4 })
  {
    for (bool spheres : { false, true })
    {
      SCOPED_TRACE(std::to_string(samples) + (spheres ? " spheres" : " rectangles"));
      View view(100, 75, samples);
      if (spheres)
      {
        AddSpheres(view.Renderer);
      }
      else
      {
        rectangles.AddTo(view.Renderer);
      }
      vtkNew<vtkABufferPass> exact;
      view.SetPass(exact);
      const Picture right = view.Render();
      const auto pass = NewAdaptive(4, Removal::Underestimate);
      view.SetPass(pass);
      double last = Compare(view.Render(), right).RootMeanSquare;
      const double untamed = last;
      const struct
      {
        double Tolerance;
        double Largest; // of 255
      } limits[] = { { 0.1, 45 }, { 0.03, 35 }, { 0.01, 25 }, { 0.003, 15 }, { 0.001, 10 }, { 0.0001, 8 },
        { 1e-6, 2 } };
      for (const auto& limit : limits)
      {
        pass->SetTolerance(limit.Tolerance);
        const PictureDifference difference = Compare(view.Render(), right);
        EXPECT_LE(difference.Largest, limit.Largest) << limit.Tolerance << " " << difference;
        EXPECT_LE(difference.RootMeanSquare, last) << limit.Tolerance;
        last = difference.RootMeanSquare;
      }
      EXPECT_LT(last, 0.1 * untamed);
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestTolerance, IsNotForFixedMemory)
{
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  const auto refused = [&](const std::string& expected)
  {
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
  };
  pass->SetTolerance(0.01);
  EXPECT_FALSE(pass->SetOption("memory", "fixed"));
  refused("Memory is Fixed (1), expected Variable (0) while Tolerance is 0.01");
  EXPECT_EQ(pass->GetMemory(), Adaptive::Variable);
  pass->SetTolerance(0);
  pass->SetMemory(Adaptive::Fixed);
  EXPECT_FALSE(pass->SetOption("tolerance", "0.01"));
  refused("Tolerance is 0.01, expected 0 while Memory is Fixed");
  EXPECT_EQ(pass->GetTolerance(), 0);
}

//------------------------------------------------------------------------------
using TestAlphaCorrection = RenderTest;

namespace
{
// As drawn by so many nodes, with correction or as in the paper.
Picture DrawCorrected(View& view, int memory, int nodes, bool corrected)
{
  const auto pass = NewAdaptive(nodes, Removal::Underestimate);
  pass->SetMemory(memory);
  pass->SetAlphaCorrection(corrected);
  view.SetPass(pass);
  const Picture drawn = view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  return drawn;
}
}

// Nothing but white is seen, however many nodes were removed.
TEST_F(TestAlphaCorrection, OfManyAlikeGivesTheirColor)
{
  AnalyticScene stack;
  stack.Width = 40;
  stack.Height = 30;
  for (int i = 0; i < 200; ++i)
  {
    const int at = 37 * i % 200; // any order
    stack.Translucent.push_back({ { 0, 0, 40, 30, (at + 1) / 256.0, { { 1, 1, 1 } }, 0.05 } });
  }
  AnalyticScene transmitting = stack;
  for (Layer& layer : transmitting.Translucent)
  {
    layer[0].Transmission = { { 0.5, 0.25, 0 } };
    layer[0].Rgb = { { 0.5, 0.75, 1 } }; // what it hides
  }
  for (const AnalyticScene* scene : { &stack, &transmitting })
  {
    const Picture exact = scene->Compute(Reference::CompositeExact);
    for (int samples : { 0, 4 })
    {
      View view(*scene, samples);
      for (int memory : { Adaptive::Variable, Adaptive::Fixed })
      {
        SCOPED_TRACE(std::string(scene == &stack ? "one channel " : "three channels ") + std::to_string(samples) + " " +
          std::to_string(memory));
        const Picture drawn = DrawCorrected(view, memory, 8, true);
        EXPECT_LE(Compare(drawn, exact).Largest, 1);
        for (int c = 0; scene == &stack && c < 3; ++c)
        {
          EXPECT_EQ(drawn.At(20, 15, c), 255);
        }
        EXPECT_LT(DrawCorrected(view, memory, 8, false).At(20, 15, 2), 240);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestAlphaCorrection, ChangesNothingThatFits)
{
  const AnalyticScene plain = RandomLayers(100, 75, 12, 8, 0.02, 0.8);
  const AnalyticScene transmitting = plain.Transmitting(13);
  for (const AnalyticScene* scene : { &plain, &transmitting })
  {
    for (int samples : { 0, 4 })
    {
      View view(*scene, samples);
      for (int memory : { Adaptive::Variable, Adaptive::Fixed })
      {
        SCOPED_TRACE(std::to_string(scene == &plain) + " " + std::to_string(samples) + " " + std::to_string(memory));
        EXPECT_EQ(Compare(DrawCorrected(view, memory, 8, true), DrawCorrected(view, memory, 8, false)).Largest, 0);
        EXPECT_GT(Compare(DrawCorrected(view, memory, 2, true), DrawCorrected(view, memory, 2, false)).Largest, 5);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Root of the mean square over pixels whose colours are random, fall with depth, or are alike.
// Documentation/Adaptive.md has more.
struct CorrectedBound
{
  int Fragments;
  double LeastAlpha;
  double MostAlpha;
  double Most[3]; // with 4, 8 and 16 nodes
};

void PrintTo(const CorrectedBound& value, std::ostream* os)
{
  *os << value.Fragments;
}

class TestCorrectedPictures
  : public RenderTest
  , public testing::WithParamInterface<CorrectedBound>
{
};

TEST_P(TestCorrectedPictures, AreNearToExact)
{
  const CorrectedBound& bound = GetParam();
  double squares[3][2] = {};
  for (const std::string colors : { "random", "falling", "alike" })
  {
    AnalyticScene scene = RandomMosaic(120, 100, 14, bound.Fragments, bound.LeastAlpha, bound.MostAlpha).Shrunk(5);
    for (Layer& layer : scene.Translucent)
    {
      for (Rectangle& rectangle : layer)
      {
        const double falling = std::round(255 * (1 - rectangle.Depth)) / 255;
        rectangle.Rgb = colors == "random" ? rectangle.Rgb
          : colors == "falling"            ? Reference::Color{ { falling, falling, falling } }
                                           : Reference::Color{ { 1, 1, 1 } };
      }
    }
    const Picture exact = scene.Compute(Reference::CompositeExact);
    View view(scene);
    for (int i : { 0, 1, 2 })
    {
      for (bool corrected : { false, true })
      {
        squares[i][corrected] +=
          std::pow(Compare(DrawCorrected(view, Adaptive::Variable, 4 << i, corrected), exact).RootMeanSquare, 2) / 3;
      }
    }
  }
  for (int i : { 0, 1, 2 })
  {
    const double rmse = std::sqrt(squares[i][1]);
    const double uncorrected = std::sqrt(squares[i][0]);
    RecordProperty(std::to_string(4 << i), std::to_string(rmse) + " instead of " + std::to_string(uncorrected));
    EXPECT_LE(rmse, bound.Most[i]) << (4 << i);
    EXPECT_GT(uncorrected, 4 * rmse) << (4 << i);
  }
}

INSTANTIATE_TEST_SUITE_P(Adaptive, TestCorrectedPictures,
  testing::Values(CorrectedBound{ 64, 0.02, 0.3, { 0.02, 0.0065, 0.0022 } },
    CorrectedBound{ 200, 0.02, 0.1, { 0.016, 0.006, 0.0027 } },
    CorrectedBound{ 600, 0.01, 0.2, { 0.024, 0.0085, 0.003 } }),
  [](const auto& info) { return std::to_string(info.param.Fragments); });

//------------------------------------------------------------------------------
// By areas alone a cluster loses all nodes but one, if it is inserted after what lies far apart: 44 of 255, instead
// of 2.
TEST_F(TestAlphaCorrection, KeepsNodesOfNearlyCoincidentSurfaces)
{
  AnalyticScene scene = RandomMosaic(60, 45, 15, 20, 0.02, 0.1);
  const AnalyticScene cluster = RandomMosaic(60, 45, 16, 20, 0.3, 0.6);
  for (std::size_t i = 0; i < cluster.Translucent.size(); ++i)
  {
    scene.Translucent.push_back(cluster.Translucent[i]);
    for (Rectangle& rectangle : scene.Translucent.back())
    {
      rectangle.Depth = 0.25 + static_cast<double>(7 * i % 20) / 65536;
    }
  }
  AnalyticScene reversed = scene;
  std::reverse(reversed.Translucent.begin(), reversed.Translucent.end());
  const Picture exact = scene.Compute(Reference::CompositeExact);
  for (int samples : { 0, 4 })
  {
    for (const auto& [inserted, memory] :
      { std::pair(&scene, Adaptive::Fixed), std::pair(&reversed, Adaptive::Variable) })
    {
      SCOPED_TRACE(std::to_string(samples) + " " + std::to_string(memory));
      View view(*inserted, samples);
      EXPECT_LE(Compare(DrawCorrected(view, memory, 16, true), exact).Largest, 2.5);
      EXPECT_GT(Compare(DrawCorrected(view, memory, 16, false), exact).Largest, 25);
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestAlphaCorrection, OfSurfacesIsNearerToExact)
{
  View view(100, 75);
  AddSpheres(view.Renderer);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture exact = view.Render();
  for (int memory : { Adaptive::Variable, Adaptive::Fixed })
  {
    const double uncorrected = Compare(DrawCorrected(view, memory, 8, false), exact).RootMeanSquare;
    EXPECT_LT(Compare(DrawCorrected(view, memory, 8, true), exact).RootMeanSquare, uncorrected / 4) << memory;
  }
}
