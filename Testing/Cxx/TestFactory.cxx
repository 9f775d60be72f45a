// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The techniques by name: each draws, and those that promise a right picture draw it.
#include "RenderTest.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkTranslucencyFactory.h>

#include <algorithm>

using TestFactory = RenderTest;

namespace
{
AnalyticScene SomeLayers()
{
  return RandomLayers(200, 160, 101, 20, 0.1, 0.6);
}

PictureDifference FromExact(const std::string& name, const AnalyticScene& scene)
{
  View view(scene);
  EXPECT_NE(vtkTranslucencyFactory::Enable(view.Renderer, name), nullptr);
  return Compare(view.Render(), scene.Compute(Reference::CompositeExact));
}
}

//------------------------------------------------------------------------------
TEST_F(TestFactory, DrawsRightByTheTechniquesThatPromiseIt)
{
  for (const auto& [name, bound] :
    { std::pair<std::string, double>{ "exact", 1.5 }, { "adaptive", 8 }, { "vtk-peel", 4 } })
  {
    const PictureDifference difference = FromExact(name, SomeLayers());
    EXPECT_LE(difference.Largest, bound) << name << ": " << difference;
  }
}

//------------------------------------------------------------------------------
TEST_F(TestFactory, BlendsInTheOrderOfDrawing)
{
  AnalyticScene sorted = SomeLayers();
  std::sort(sorted.Translucent.begin(), sorted.Translucent.end(),
    [](const Layer& a, const Layer& b) { return a[0].Depth > b[0].Depth; });
  EXPECT_LE(FromExact("blend", sorted).Largest, 20 * 0.5 + 1) << "each layer is rounded to a byte";
  EXPECT_GE(FromExact("blend", sorted.Reversed()).Largest, 50);
}

//------------------------------------------------------------------------------
TEST_F(TestFactory, DrawsSomethingByEveryTechnique)
{
  AnalyticScene opaque = SomeLayers();
  opaque.Translucent.clear();
  const Picture empty = opaque.Compute(Reference::CompositeExact);
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const std::string name = vtkTranslucencyFactory::GetTechniqueName(i);
    EXPECT_FALSE(vtkTranslucencyFactory::GetTechniqueHelp(i).empty()) << name;
    View view(SomeLayers());
    vtkTranslucencyFactory::Enable(view.Renderer, name);
    EXPECT_GT(Compare(view.Render(), empty).RootMeanSquare, 0.05) << name;
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(view.Window);
    EXPECT_EQ(vtkTranslucencyFactory::GetMissing(name, window), "") << name;
  }
  EXPECT_EQ(vtkTranslucencyFactory::GetTechniqueName(-1), "");
  EXPECT_EQ(vtkTranslucencyFactory::GetTechniqueName(1000), "");
}

//------------------------------------------------------------------------------
// There is no context yet in which something could have been made.
TEST_F(TestFactory, ExchangesAndTakesOutBeforeTheFirstFrame)
{
  View view(SomeLayers());
  vtkTranslucencyFactory::Enable(view.Renderer, "exact");
  vtkTranslucencyFactory::Enable(view.Renderer, "adaptive");
  vtkTranslucencyFactory::Disable(view.Renderer);
  EXPECT_EQ(view.Renderer->GetPass(), nullptr);
}

//------------------------------------------------------------------------------
TEST_F(TestFactory, RefusesANameThatIsNone)
{
  EXPECT_EQ(vtkTranslucencyFactory::CreateTechnique("magic"), nullptr);
  std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("'magic', expected one of: exact, adaptive, "), std::string::npos) << messages[0];
  View view(10, 10);
  vtkRenderPass* pass = vtkTranslucencyFactory::Enable(view.Renderer, "exact");
  EXPECT_EQ(vtkTranslucencyFactory::Enable(view.Renderer, ""), nullptr);
  EXPECT_EQ(vtkTranslucencyFactory::GetTechnique(view.Renderer), pass);
  vtkTranslucencyFactory::Disable(view.Renderer);
  EXPECT_EQ(vtkTranslucencyFactory::GetTechnique(view.Renderer), nullptr);
  EXPECT_EQ(TakeMessages().size(), 1u);
  EXPECT_EQ(vtkTranslucencyFactory::Enable(nullptr, "exact"), nullptr);
  EXPECT_EQ(vtkTranslucencyFactory::GetTechnique(nullptr), nullptr);
  EXPECT_EQ(TakeMessages().size(), 2u);
}
