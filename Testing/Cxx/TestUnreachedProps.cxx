// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Props whose shaders the techniques' text does not reach: those that draw by actors of their own, and shaders of the
// user's own.
#include "RenderTest.h"
#include "WatchedPass.h"

#include <vtkActor.h>
#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyStatistics.h>

#include <cmath>
#include <tuple>

namespace
{
/// Draws by an actor of which no pass is told.
class HidingProp : public vtkProp
{
public:
  static HidingProp* New();
  vtkTypeMacro(HidingProp, vtkProp);

  double* GetBounds() override { return this->Actor->GetBounds(); }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return this->Actor->HasTranslucentPolygonalGeometry(); }
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    return this->Actor->RenderTranslucentPolygonalGeometry(viewport);
  }
  int RenderOpaqueGeometry(vtkViewport* viewport) override { return this->Actor->RenderOpaqueGeometry(viewport); }
  void ReleaseGraphicsResources(vtkWindow* window) override { this->Actor->ReleaseGraphicsResources(window); }

  vtkSmartPointer<vtkActor> Actor;
};
vtkStandardNewMacro(HidingProp);

const char* const OwnShader = "//VTK::System::Dec\n"
                              "//VTK::Output::Dec\n"
                              "void main() { gl_FragData[0] = vec4(1.0, 0.5, 0.0, 0.5); }\n";

// Hides the last actors of a view behind props, which are then drawn last, too.
void HideLast(View& view, int count)
{
  std::vector<vtkSmartPointer<vtkActor>> translucent;
  vtkPropCollection* props = view.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(props->GetItemAsObject(i));
    if (actor && actor->HasTranslucentPolygonalGeometry())
    {
      translucent.emplace_back(actor);
    }
  }
  ASSERT_GE(translucent.size(), static_cast<std::size_t>(count));
  for (auto actor = translucent.end() - count; actor != translucent.end(); ++actor)
  {
    view.Renderer->RemoveViewProp(*actor);
    vtkNew<HidingProp> hiding;
    hiding->Actor = *actor;
    view.Renderer->AddViewProp(hiding);
  }
}

void AddCube(View& view)
{
  vtkNew<vtkAnnotatedCubeActor> cube;
  cube->SetFaceTextVisibility(false);
  cube->SetTextEdgesVisibility(false);
  cube->GetCubeProperty()->SetOpacity(0.4);
  cube->GetCubeProperty()->SetColor(1, 1, 0);
  cube->GetCubeProperty()->LightingOff();
  view.Renderer->AddViewProp(cube);
}

vtkSmartPointer<vtkActor> AddSphereOfOwnShader(View& view)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.5);
  actor->GetShaderProperty()->SetFragmentShaderCode(OwnShader);
  view.Renderer->AddActor(actor);
  return actor;
}

void LookAtAll(View& view)
{
  view.Renderer->SetBackground(0.2, 0.3, 0.4);
  view.Renderer->GetActiveCamera()->ParallelProjectionOn();
  view.Renderer->ResetCamera();
}

// A channel of the pixel in the middle, or the mean of the pixels around it where layers have masks.
double Middle(const Picture& picture, int channel, int radius)
{
  double sum = 0;
  int count = 0;
  for (int y = picture.Height / 2 - radius; y <= picture.Height / 2 + radius; ++y)
  {
    for (int x = picture.Width / 2 - radius; x <= picture.Width / 2 + radius; ++x)
    {
      sum += picture.At(x, y, channel);
      ++count;
    }
  }
  return sum / count;
}

// Two layers of this colour over the background of LookAtAll; light that adds up hides nothing.
double TwoLayers(const std::string& technique, double background, double color, double opacity)
{
  const double through = technique == "additive" ? 1 : (1 - opacity) * (1 - opacity);
  const double light = technique == "additive" ? 2 * opacity * color : (1 - through) * color;
  return 255 * std::min(1.0, through * background + light);
}

void ExpectWarningOf(const std::vector<std::string>& messages, const std::string& name)
{
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("Warning"), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find(name), std::string::npos) << messages[0];
}
}

class TestUnreachedProps
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<std::string, int>>
{
protected:
  std::string Technique = std::get<0>(this->GetParam());
  int Samples = std::get<1>(this->GetParam());
  bool Masked = this->Technique == "screendoor";

  void ExpectTwoLayers(const Picture& picture, const Reference::Color& color, double opacity)
  {
    const Reference::Color background{ { 0.2, 0.3, 0.4 } };
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(Middle(picture, channel, this->Masked ? 7 : 0),
        TwoLayers(this->Technique, background[channel], color[channel], opacity), this->Masked ? 16 : 1.6)
        << "channel " << channel;
    }
  }
};

//------------------------------------------------------------------------------
TEST_P(TestUnreachedProps, AreDrawnAsReachedOnesAre)
{
  const AnalyticScene scene = RandomLayers(64, 48, 73, 9, 0.1, 0.8);
  View reached(scene, this->Samples);
  View unreached(scene, this->Samples);
  HideLast(unreached, 3);
  reached.SetPass(NewTechnique(this->Technique));
  unreached.SetPass(NewTechnique(this->Technique));
  const Picture expected = reached.Render();
  for (int frame = 0; frame < 2; ++frame)
  {
    const PictureDifference difference = Compare(unreached.Render(), expected);
    EXPECT_LE(this->Masked ? difference.RootMeanSquare : difference.Largest, this->Masked ? 0.2 : 1.0) << difference;
  }
  ExpectWarningOf(TakeMessages(), "HidingProp");
}

//------------------------------------------------------------------------------
TEST_P(TestUnreachedProps, CubeHasTwoLayers)
{
  View view(64, 64, this->Samples);
  AddCube(view);
  LookAtAll(view);
  view.SetPass(NewTechnique(this->Technique));
  this->ExpectTwoLayers(view.Render(), { { 1, 1, 0 } }, 0.4);
  ExpectWarningOf(TakeMessages(), "vtkAnnotatedCubeActor");
}

//------------------------------------------------------------------------------
TEST_P(TestUnreachedProps, ShaderOfTheUsersHasTwoLayers)
{
  View view(64, 64, this->Samples);
  AddSphereOfOwnShader(view);
  LookAtAll(view);
  view.SetPass(NewTechnique(this->Technique));
  this->ExpectTwoLayers(view.Render(), { { 1, 0.5, 0 } }, 0.5);
  ExpectWarningOf(TakeMessages(), "Actor with vtk");
}

INSTANTIATE_TEST_SUITE_P(Techniques, TestUnreachedProps,
  testing::Combine(testing::ValuesIn(OwnTechniques()), testing::Values(0, 4)),
  [](const auto& info) { return std::get<0>(info.param) + (std::get<1>(info.param) ? "Samples4" : ""); });

class TestUnreached : public RenderTest
{
};

//------------------------------------------------------------------------------
TEST_F(TestUnreached, StateIsAsItWas)
{
  const AnalyticScene scene = RandomLayers(64, 48, 73, 5, 0.1, 0.8);
  View view(scene);
  HideLast(view, 2);
  vtkNew<WatchedPass> watched;
  watched->Pass = NewTechnique("exact");
  view.SetTranslucentPass(watched);
  for (int frame = 0; frame < 2; ++frame)
  {
    view.Render();
    for (const auto& state : watched->Before)
    {
      EXPECT_EQ(watched->After.at(state.first), state.second) << state.first << ", frame " << frame;
    }
    EXPECT_TRUE(watched->ErrorsAfter.empty());
  }
  ExpectWarningOf(TakeMessages(), "HidingProp");
}

//------------------------------------------------------------------------------
TEST_F(TestUnreached, ShaderThatIsTakenBackIsReached)
{
  View view(64, 64);
  const auto actor = AddSphereOfOwnShader(view);
  LookAtAll(view);
  const auto pass = NewTechnique("exact");
  view.SetPass(pass);
  view.Render();
  EXPECT_GT(pass->GetStatistics()->GetGeometryPasses(), 0);
  ExpectWarningOf(TakeMessages(), "Actor");

  actor->GetShaderProperty()->SetFragmentShaderCode("");
  actor->GetProperty()->SetColor(0, 1, 0);
  actor->GetProperty()->LightingOff();
  const Picture picture = view.Render();
  EXPECT_NEAR(Middle(picture, 1, 0), TwoLayers("exact", 0.3, 1, 0.5), 1.6);

  actor->GetShaderProperty()->SetFragmentShaderCode(OwnShader);
  EXPECT_NEAR(Middle(view.Render(), 0, 0), TwoLayers("exact", 0.2, 1, 0.5), 1.6);
}

//------------------------------------------------------------------------------
TEST_F(TestUnreached, MoreLayersThanAreCountedAreAnError)
{
  AnalyticScene scene;
  scene.Width = 16;
  scene.Height = 16;
  scene.Translucent.emplace_back();
  for (int i = 0; i < 300; ++i)
  {
    scene.Translucent[0].push_back({ 0, 0, 16, 16, (1000 + i) / 65536.0, { { 1, 1, 1 } }, 1.0 / 255 });
  }
  View view(scene);
  HideLast(view, 1);
  view.SetPass(NewTechnique("exact"));
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_GE(messages.size(), 2u); // the first says that it is drawn by itself, the last how the fallback draws it
  EXPECT_NE(messages[1].find("more than 255 layers"), std::string::npos) << messages[1];
}

//------------------------------------------------------------------------------
// VTK's depth peeling would never end.
TEST_F(TestUnreached, StockPeelingEnds)
{
  for (bool cube : { true, false })
  {
    View view(64, 64);
    if (cube)
    {
      AddCube(view);
    }
    else
    {
      AddSphereOfOwnShader(view);
    }
    LookAtAll(view);
    view.SetTranslucentPass(vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique("vtk-peel")));
    EXPECT_NEAR(Middle(view.Render(), 0, 0), TwoLayers("vtk-peel", 0.2, 1, cube ? 0.4 : 0.5), 1.6);
    ExpectWarningOf(TakeMessages(), "Actor");
  }
}

//------------------------------------------------------------------------------
// Depths that are no numbers are left in every drawing.
TEST_F(TestUnreached, PeelingEndsWhereDepthsAreNoNumbers)
{
  for (const char* technique : { "vtk-peel", "peel" })
  {
    View view(64, 64);
    const auto actor = AddSphereOfOwnShader(view);
    actor->GetShaderProperty()->SetFragmentShaderCode("");
    actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Depth::Impl", true, "gl_FragDepth = 0.0 / (gl_FragCoord.z - gl_FragCoord.z);\n", false);
    LookAtAll(view);
    view.SetTranslucentPass(vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(technique)));
    view.Render();
  }
}

//------------------------------------------------------------------------------
TEST_F(TestUnreached, StockPeelingRefusesSamples)
{
  const AnalyticScene scene = RandomLayers(64, 48, 71, 1, 0.3, 0.6);
  View view(scene, 4);
  view.SetTranslucentPass(vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique("vtk-peel")));
  view.Render();
  EXPECT_LE(Compare(view.Render(), scene.Compute(Reference::CompositeExact)).Largest, 2) << "one layer may be blended";
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("4 samples"), std::string::npos) << messages[0];
}
