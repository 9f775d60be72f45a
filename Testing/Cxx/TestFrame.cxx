// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// One frame among others: how a pass is put into a renderer, what else is in the window, and what comes and goes.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkFragmentStorage.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRendererCollection.h>
#include <vtkTranslucencyStatistics.h>

#include <array>
#include <memory>

using TestFrame = RenderTest;

namespace
{
AnalyticScene SomeLayers()
{
  return RandomLayers(200, 160, 41, 30, 0.05, 0.6);
}

Picture Exact(const AnalyticScene& scene)
{
  return scene.Compute(Reference::CompositeExact);
}
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, IsTheSameAloneAndAmongRenderSteps)
{
  vtkNew<vtkABufferPass> pass;
  View alone(SomeLayers());
  alone.SetPass(pass);
  View steps(SomeLayers());
  vtkNew<vtkABufferPass> other;
  steps.SetTranslucentPass(other);
  const Picture drawn = alone.Render();
  EXPECT_EQ(Compare(drawn, steps.Render()).Largest, 0);
  const PictureDifference difference = Compare(drawn, Exact(SomeLayers()));
  EXPECT_LE(difference.Largest, 1.5) << difference;
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, BuildsNoShaderAfterTheFirstOfAStaticScene)
{
  View view(SomeLayers());
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  view.SetPass(pass);
  view.Render();
  EXPECT_GT(pass->GetStatistics()->GetShaderBuilds(), 0);
  for (int frame = 1; frame < 4; ++frame)
  {
    view.Render();
    EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0) << "frame " << frame;
    EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 1) << "frame " << frame;
  }
  view.Renderer->GetActiveCamera()->Azimuth(10);
  view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0) << "after the camera has moved";
  pass->SetNodeCount(8);
  view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0) << "nodes are not the mappers' matter";
}

//------------------------------------------------------------------------------
// What the mappers store changes with it: their shaders have to be made anew.
TEST_F(TestFrame, FollowsTheColorFormat)
{
  View view(SomeLayers());
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture drawn = view.Render();
  pass->GetStorage()->SetColorFormat(vtkFragmentStorage::RGBA8);
  EXPECT_LE(Compare(view.Render(), drawn).Largest, 3) << "bytes";
  EXPECT_GT(pass->GetStatistics()->GetShaderBuilds(), 0);
  pass->GetStorage()->SetColorFormat(vtkFragmentStorage::HalfFloat);
  EXPECT_EQ(Compare(view.Render(), drawn).Largest, 0) << "half floats again";
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, CountsWhatItDrawsAndNotWhatEarlierOnesDid)
{
  AnalyticScene scene;
  scene.Translucent.assign(7, { { 0, 0, scene.Width, scene.Height, 0.5, { { 1, 0, 0 } }, 0.5 } });
  View view(scene);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  for (int layers = 7; layers > 0; --layers)
  {
    view.Render();
    EXPECT_EQ(pass->GetStatistics()->GetDeepestPixel(), layers);
    EXPECT_EQ(pass->GetStatistics()->GetFragments(), layers * scene.Width * scene.Height);
    view.Renderer->RemoveViewProp(view.Renderer->GetViewProps()->GetLastProp());
  }
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, DrawsTranslucentBeforeBehindAndThroughOpaque)
{
  AnalyticScene scene;
  scene.Width = 60;
  scene.Height = 20;
  scene.Background = { { 0, 0, 1 } };
  scene.Opaque = { { 0, 0, 60, 20, 0.5, { { 1, 1, 1 } }, 1 } };
  scene.Translucent = { { { 0, 0, 20, 20, 0.25, { { 1, 0, 0 } }, 0.5 } }, // before
    { { 20, 0, 40, 20, 0.75, { { 1, 0, 0 } }, 0.5 } } };                  // behind
  View view(scene);
  // Through: a red rectangle that turns from before to behind at x = 50.
  AnalyticScene tilted;
  tilted.Width = 60;
  tilted.Height = 20;
  tilted.Translucent = { { { -10, 0, 10, 20, 0.5, { { 1, 0, 0 } }, 0.5 } } };
  View builder(tilted);
  vtkActor* through = vtkActor::SafeDownCast(builder.Renderer->GetViewProps()->GetItemAsObject(0));
  through->RotateY(-1);
  through->SetPosition(50, 0, 0);
  view.Renderer->AddActor(through);
  view.Renderer->GetActiveCamera()->SetParallelScale(10);

  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture drawn = view.Render();
  const auto isRed = [&drawn](int x) { return drawn.At(x, 10, 1) < 200; };
  EXPECT_TRUE(isRed(10));
  EXPECT_FALSE(isRed(30));
  EXPECT_NE(isRed(45), isRed(55));
}

namespace
{
/// Two scenes in one window, the left one by the first pass.
void ExpectSideBySide(const std::array<vtkRenderPass*, 2>& passes)
{
  const AnalyticScene scenes[] = { RandomLayers(100, 80, 51, 20, 0.05, 0.6), RandomLayers(100, 80, 52, 20, 0.05, 0.6) };
  View view(200, 80);
  view.Window->RemoveRenderer(view.Renderer);
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(0.5 * i, 0, 0.5 * (i + 1), 1);
    scenes[i].AddTo(renderer);
    renderer->SetPass(passes[i]);
    view.Window->AddRenderer(renderer);
  }
  for (int frame = 0; frame < 2; ++frame)
  {
    const Picture drawn = view.Render();
    for (int i = 0; i < 2; ++i)
    {
      const PictureDifference difference = Compare(Crop(drawn, 100 * i, 0, 100, 80), Exact(scenes[i]));
      EXPECT_LE(difference.Largest, 1.5) << "frame " << frame << ", renderer " << i << ": " << difference;
    }
  }
}
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, DrawsSeveralRenderersSideBySide)
{
  vtkNew<vtkABufferPass> left;
  vtkNew<vtkABufferPass> right;
  ExpectSideBySide({ { left, right } });
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, MayBeSharedByRenderers)
{
  vtkNew<vtkABufferPass> pass;
  ExpectSideBySide({ { pass, pass } });
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, MayMoveToAnotherWindow)
{
  vtkNew<vtkABufferPass> pass;
  auto first = std::make_unique<View>(SomeLayers());
  first->SetPass(pass);
  const Picture drawn = first->Render();
  View second(SomeLayers());
  second.SetPass(pass);
  EXPECT_EQ(Compare(drawn, second.Render()).Largest, 0);
  EXPECT_EQ(Compare(drawn, first->Render()).Largest, 0);
  first.reset();
  EXPECT_EQ(Compare(drawn, second.Render()).Largest, 0);
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, DrawsInLayersOverOtherRenderers)
{
  const AnalyticScene scene = SomeLayers();
  View view(scene);
  view.Renderer->SetLayer(1);
  view.Window->SetNumberOfLayers(2);
  view.Renderer->SetBackground(0, 0, 0); // a layer above does not clear
  vtkNew<vtkRenderer> behind;
  behind->SetBackground(scene.Background[0], scene.Background[1], scene.Background[2]);
  view.Window->AddRenderer(behind);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const PictureDifference difference = Compare(view.Render(), Exact(scene));
  EXPECT_LE(difference.Largest, 1.5) << difference;
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, LeavesRoomForOverlays)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(20, 30, 0);
  plane->SetPoint1(60, 30, 0);
  plane->SetPoint2(20, 50, 0);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor2D> overlay;
  overlay->SetMapper(mapper);
  overlay->GetProperty()->SetColor(0, 1, 0);

  View view(SomeLayers());
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture without = view.Render();
  view.Renderer->AddActor(overlay);
  const Picture with = view.Render();
  EXPECT_EQ(Crop(with, 40, 40, 1, 1).Rgb, (std::vector<double>{ 0, 255, 0 }));
  EXPECT_EQ(Crop(with, 80, 0, 100, 160), Crop(without, 80, 0, 100, 160));
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, DrawsAnEmptyScene)
{
  View view(64, 48);
  view.Renderer->SetBackground(0.2, 0.4, 0.6);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture drawn = view.Render();
  EXPECT_EQ(drawn.At(10, 10, 0), 51);
  EXPECT_EQ(drawn.At(10, 10, 2), 153);
  EXPECT_EQ(pass->GetStatistics()->GetFragments(), 0);
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, DrawsASceneWithoutTranslucentProps)
{
  AnalyticScene scene = SomeLayers();
  scene.Translucent.clear();
  vtkNew<vtkABufferPass> pass;
  EXPECT_EQ(Compare(Draw(scene, pass), Exact(scene)).Largest, 0);
  EXPECT_EQ(pass->GetStatistics()->GetFragments(), 0);
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, DrawsASceneThatIsEntirelyOffTheScreen)
{
  AnalyticScene scene;
  scene.Background = { { 0.2, 0.4, 0.6 } };
  scene.Translucent = { { { 500, 0, 600, 100, 0.5, { { 1, 0, 0 } }, 0.5 } },
    { { 0, -100, 100, -10, 0.5, { { 1, 0, 0 } }, 0.5 } } };
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  EXPECT_EQ(Compare(Draw(scene, pass), Exact(scene)).Largest, 0);
  EXPECT_EQ(pass->GetStatistics()->GetFragments(), 0);
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, FollowsWhatComesAndGoes)
{
  const AnalyticScene scene = SomeLayers();
  View view(scene);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture whole = view.Render();
  vtkPropCollection* props = view.Renderer->GetViewProps();
  std::vector<vtkProp*> layers;
  for (int i = static_cast<int>(scene.Opaque.size()); i < props->GetNumberOfItems(); ++i)
  {
    layers.push_back(vtkProp::SafeDownCast(props->GetItemAsObject(i)));
  }
  AnalyticScene none = scene;
  none.Translucent.clear();
  for (int frame = 0; frame < 2; ++frame)
  {
    for (vtkProp* layer : layers)
    {
      layer->VisibilityOff();
    }
    EXPECT_EQ(Compare(view.Render(), Exact(none)).Largest, 0);
    for (vtkProp* layer : layers)
    {
      layer->VisibilityOn();
    }
    EXPECT_EQ(Compare(view.Render(), whole).Largest, 0);
  }
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, FollowsTheWindowsSize)
{
  View view(SomeLayers());
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture before = view.Render();
  for (int width : { 40, 640, 1, 333 })
  {
    AnalyticScene scene = RandomLayers(width, 120, 61, 20, 0.05, 0.6);
    view.Window->SetSize(width, 120);
    view.Renderer->RemoveAllViewProps();
    scene.AddTo(view.Renderer);
    const PictureDifference difference = Compare(view.Render(), Exact(scene));
    EXPECT_LE(difference.Largest, 1.5) << "width " << width << ": " << difference;
  }
}

//------------------------------------------------------------------------------
TEST_F(TestFrame, OutlivesItsWindowAndIsOutlived)
{
  auto pass = vtkSmartPointer<vtkAdaptiveTransparencyPass>::New();
  {
    View view(SomeLayers());
    view.SetPass(pass);
    view.Render();
    pass->GetStatistics();
  }
  EXPECT_EQ(pass->GetReferenceCount(), 1);
  pass = nullptr; // after its window

  View view(SomeLayers());
  pass = vtkSmartPointer<vtkAdaptiveTransparencyPass>::New();
  view.SetPass(pass);
  const Picture drawn = view.Render();
  view.SetPass(nullptr);
  pass = nullptr; // before its window
  pass = vtkSmartPointer<vtkAdaptiveTransparencyPass>::New();
  view.SetPass(pass);
  EXPECT_EQ(Compare(drawn, view.Render()).Largest, 0);
  view.Window->Finalize(); // the context goes, the window and the pass stay
  EXPECT_EQ(Compare(drawn, view.Render()).Largest, 0);
}
