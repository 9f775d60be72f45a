// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// A pass that chooses among the techniques: what it chooses within budgets, and that it draws what the chosen one
// draws.
#include "RenderTest.h"

#include <vtkAutomaticTransparencyPass.h>
#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPropCollection.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyMaterial.h>
#include <vtkTranslucencyOption.h>
#include <vtkTranslucencyStatistics.h>

#include <limits>
#include <sstream>

namespace
{
// 16 bytes for each of 450,000 fragments and 4 for each pixel: 7 MiB in lists. 12 a pixel and layer, and 24: 3.4 MiB in
// 8 layers. 60 a pixel for a wavelet in half floats: 1.7 MiB.
AnalyticScene Scene()
{
  return RandomLayers(200, 150, 2, 30, 0.1, 0.6);
}

vtkSmartPointer<vtkTranslucencyPass> New(const std::string& technique)
{
  std::istringstream parts(technique);
  std::string part;
  std::getline(parts, part, ':');
  auto pass = vtkSmartPointer<vtkTranslucencyPass>::Take(
    vtkTranslucencyPass::SafeDownCast(vtkTranslucencyFactory::CreateTechnique(part)));
  while (std::getline(parts, part, ':'))
  {
    EXPECT_TRUE(pass->SetOption(part.substr(0, part.find('=')), part.substr(part.find('=') + 1)));
  }
  return pass;
}

double Mebibytes(vtkTranslucencyPass* pass)
{
  return static_cast<double>(pass->GetStatistics()->GetBytes()) / (1024 * 1024);
}

using Names = std::vector<std::string>;

/// The choices of that many frames, each once as long as it stays.
Names Choices(View& view, vtkAutomaticTransparencyPass* pass, int frames)
{
  Names choices;
  for (int frame = 0; frame < frames; ++frame)
  {
    view.Window->Render();
    if (choices.empty() || choices.back() != pass->GetChosen())
    {
      choices.push_back(pass->GetChosen());
    }
  }
  return choices;
}

using TestAutomatic = RenderTest;
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, IsExactWithoutABudget)
{
  vtkNew<vtkAutomaticTransparencyPass> pass;
  EXPECT_EQ(pass->GetChosen(), "");
  EXPECT_EQ(pass->GetReason(), "");
  View view(Scene());
  view.SetPass(pass);
  EXPECT_EQ(Choices(view, pass, 10), Names{ "exact" });
  EXPECT_NE(pass->GetReason().find("no budget"), std::string::npos) << pass->GetReason();
  EXPECT_EQ(pass->GetStatistics()->GetGatherTime(), -1); // nothing waits for the GPU
  EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
  EXPECT_GT(pass->GetStatistics()->GetFragments(), 200 * 150);
}

//------------------------------------------------------------------------------
// With one sample and with four, alone and among the steps of vtkRenderStepsPass.
TEST_F(TestAutomatic, DrawsWhatFitsIntoMemoryAsTheChosenOneDoes)
{
  const AnalyticScene scene = Scene();
  const struct
  {
    double Budget;
    int Samples;
    Names Expected;
  } cases[] = {
    { 20, 0, { "exact" } },
    { 6.5, 0, { "exact", "hybrid:layers=16" } },
    { 5, 0, { "exact", "hybrid:layers=8" } },
    { 3, 0, { "exact", "wavelet:memory=fixed:precision=half" } },
    { 1, 0, { "exact", "weighted" } },
    { 20, 4, { "exact" } },
    { 7, 4, { "exact", "wavelet:memory=fixed:precision=half" } },
    { 5, 4, { "exact", "weighted" } },
  };
  for (const auto& one : cases)
  {
    for (const bool alone : { true, false })
    {
      SCOPED_TRACE(std::to_string(one.Budget) + " MiB, " + std::to_string(one.Samples) + " samples");
      vtkNew<vtkAutomaticTransparencyPass> pass;
      pass->SetBudgetMebibytes(one.Budget);
      View view(scene, one.Samples);
      alone ? view.SetPass(pass) : view.SetTranslucentPass(pass);
      EXPECT_EQ(Choices(view, pass, 10), one.Expected) << pass->GetReason();
      const Picture drawn = view.Render();
      EXPECT_LE(Mebibytes(pass), one.Budget);
      EXPECT_EQ(pass->GetStatistics()->GetTiles(), 1);
      EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
      EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
      std::ostringstream budget;
      budget << "memory budget of " << one.Budget << " MiB";
      EXPECT_NE(pass->GetReason().find(budget.str()), std::string::npos) << pass->GetReason();
      View other(scene, one.Samples);
      const auto chosen = New(one.Expected.back());
      other.SetPass(chosen);
      other.Render(); // lists find out how much there is
      EXPECT_EQ(Compare(drawn, other.Render()).Largest, 0);
      EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), chosen->GetStatistics()->GetGeometryPasses());
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, StaysWithinMemoryFromTheFirstFrameOn)
{
  const AnalyticScene scene = Scene();
  for (const int samples : { 0, 4 })
  {
    vtkNew<vtkAutomaticTransparencyPass> pass;
    pass->SetBudgetMebibytes(3);
    View view(scene, samples);
    view.SetPass(pass);
    for (int frame = 0; frame < 3; ++frame)
    {
      const Picture drawn = view.Render();
      EXPECT_LE(Mebibytes(pass), 3) << pass->GetChosen();
      if (frame == 0)
      {
        EXPECT_EQ(pass->GetChosen(), "exact");
        EXPECT_GT(pass->GetStatistics()->GetTiles(), 1);
        EXPECT_LE(Compare(drawn, scene.Compute(Reference::CompositeExact)).Largest, 2);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, WithTooLittleForAnythingDrawsNevertheless)
{
  vtkNew<vtkAutomaticTransparencyPass> pass;
  pass->SetBudgetMebibytes(0.01);
  View view(Scene());
  view.SetPass(pass);
  EXPECT_EQ(Choices(view, pass, 10).back(), "weighted");
  EXPECT_NE(pass->GetReason().find("nothing fits"), std::string::npos) << pass->GetReason();
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, ReturnsToTheBetterOneWhenLessIsSeen)
{
  vtkNew<vtkAutomaticTransparencyPass> pass;
  pass->SetBudgetMebibytes(3);
  View view(Scene());
  view.SetPass(pass);
  EXPECT_EQ(Choices(view, pass, 5).back(), "wavelet:memory=fixed:precision=half");
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  const double scale = camera->GetParallelScale();
  for (int frame = 1; frame <= 10; ++frame)
  {
    camera->SetParallelScale(scale * (1 + 0.2 * frame)); // a ninth of the fragments in the end
    view.Window->Render();
  }
  EXPECT_EQ(Choices(view, pass, 5), Names{ "exact" });
  EXPECT_NE(pass->GetReason().find("better than wavelet:memory=fixed"), std::string::npos) << pass->GetReason();
  camera->SetParallelScale(scale);
  EXPECT_EQ(Choices(view, pass, 10), (Names{ "exact", "wavelet:memory=fixed:precision=half" }));
}

//------------------------------------------------------------------------------
// A wavelet in targets would take the mean of transmission colours, and what keeps no fragments would not absorb.
TEST_F(TestAutomatic, ChoosesAmongThoseThatDrawWhatThePropsAskFor)
{
  vtkNew<vtkAutomaticTransparencyPass> pass;
  pass->SetBudgetMebibytes(3);
  View view(Scene());
  view.SetPass(pass);
  EXPECT_EQ(Choices(view, pass, 5).back(), "wavelet:memory=fixed:precision=half");
  vtkProp* prop = view.Renderer->GetViewProps()->GetLastProp();
  vtkTranslucencyPass::SetTransmissionColor(prop, 1, 0.5, 0);
  EXPECT_EQ(Choices(view, pass, 5).back(), "hybrid:layers=4");
  vtkNew<vtkTranslucencyMaterial> material;
  material->SetAttenuationColor(0.5, 0.6, 0.7);
  material->SetAttenuationDistance(0.1);
  vtkTranslucencyMaterial::SetMaterial(prop, material);
  for (const std::string& choice : Choices(view, pass, 5))
  {
    EXPECT_TRUE(choice == "exact" || choice.find("adaptive") == 0) << choice;
  }
  EXPECT_LE(Mebibytes(pass), 3);
  vtkTranslucencyMaterial::SetMaterial(prop, nullptr);
  vtkTranslucencyPass::SetTransmissionColor(prop, 0, 0, 0);
  EXPECT_EQ(Choices(view, pass, 5).back(), "wavelet:memory=fixed:precision=half");
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, ComesToRestWithinAnyTime)
{
  for (const double budget : { 0.001, 5.0, 1e6 })
  {
    vtkNew<vtkAutomaticTransparencyPass> pass;
    pass->SetBudgetMilliseconds(budget);
    View view(Scene());
    view.SetPass(pass);
    const Names choices = Choices(view, pass, 100);
    EXPECT_EQ(choices.front(), "exact");
    EXPECT_EQ(Choices(view, pass, 50), Names{ choices.back() }) << budget;
    EXPECT_GE(pass->GetStatistics()->GetGatherTime(), 0);
    EXPECT_NE(pass->GetReason().find("time budget of "), std::string::npos) << pass->GetReason();
    if (budget == 1e6)
    {
      EXPECT_EQ(choices, Names{ "exact" });
    }
    if (budget == 0.001)
    {
      EXPECT_NE(pass->GetReason().find("no technique is expected to fit"), std::string::npos) << pass->GetReason();
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, TakesTheFastestWithinTheTolerance)
{
  vtkNew<vtkAutomaticTransparencyPass> pass;
  View view(Scene());
  view.SetPass(pass);
  const struct
  {
    double Tolerance;
    std::string Expected;
  } cases[] = { { 0, "exact" }, { 0.002, "adaptive:nodes=16" }, { 0.05, "weighted" }, { 0, "exact" } };
  for (const auto& one : cases)
  {
    pass->SetTolerance(one.Tolerance);
    EXPECT_EQ(Choices(view, pass, 3), Names{ one.Expected });
  }
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, LeavesOutWhatTheDriverCanNotRun)
{
  const auto hybrid = New("hybrid");
  hybrid->SetCriticalSection(vtkTranslucencyPass::Interlock);
  vtkNew<vtkAutomaticTransparencyPass> pass;
  pass->SetCriticalSection(vtkTranslucencyPass::Interlock);
  pass->SetBudgetMebibytes(5);
  View view(Scene());
  view.SetPass(pass);
  const bool can = [&]
  {
    view.Window->Render();
    return hybrid->GetMissing(vtkOpenGLRenderWindow::SafeDownCast(view.Window)).empty();
  }();
  EXPECT_EQ(Choices(view, pass, 5).back(), can ? "hybrid:layers=8" : "wavelet:memory=fixed:precision=half");
  pass->SetCriticalSection(vtkTranslucencyPass::Automatic);
  EXPECT_EQ(Choices(view, pass, 5).back(), "hybrid:layers=8");
}

//------------------------------------------------------------------------------
// Programs set what they want before each frame.
TEST_F(TestAutomatic, KnowsWhatItHasMeasuredWhereABudgetStaysTheSame)
{
  constexpr double none = 0.001;
  vtkNew<vtkAutomaticTransparencyPass> pass;
  pass->SetBudgetMilliseconds(none);
  View view(Scene());
  view.SetPass(pass);
  const std::string settled = Choices(view, pass, 100).back();
  EXPECT_NE(settled, "exact"); // what it would begin with anew
  pass->SetBudgetMilliseconds(none);
  EXPECT_EQ(Choices(view, pass, 5), Names{ settled });
  pass->SetBudgetMilliseconds(-1);
  EXPECT_EQ(TakeMessages().size(), 1u);
  EXPECT_EQ(Choices(view, pass, 5), Names{ settled });
}

//------------------------------------------------------------------------------
TEST_F(TestAutomatic, RefusesOptionsOutOfRange)
{
  vtkNew<vtkAutomaticTransparencyPass> pass;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void()>>> refused{
    { "BudgetMilliseconds is -1, expected", [&] { pass->SetBudgetMilliseconds(-1); } },
    { "BudgetMilliseconds is nan, expected", [&] { pass->SetBudgetMilliseconds(nan); } },
    { "BudgetMebibytes is -1, expected", [&] { pass->SetBudgetMebibytes(-1); } },
    { "Tolerance is 1.5, expected", [&] { pass->SetTolerance(1.5); } },
    { "Tolerance is -0.5, expected", [&] { pass->SetTolerance(-0.5); } },
    { "tolerance is '2', expected", [&] { EXPECT_FALSE(pass->SetOption("tolerance", "2")); } },
    { "no option 'nodes', expected one of: budget_milliseconds, budget_mebibytes, tolerance",
      [&] { EXPECT_FALSE(pass->SetOption("nodes", "8")); } }
  };
  const vtkMTimeType before = pass->GetMTime();
  for (const auto& one : refused)
  {
    one.second();
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u) << one.first;
    EXPECT_NE(messages[0].find(one.first), std::string::npos) << messages[0];
  }
  EXPECT_EQ(pass->GetMTime(), before);
  for (const vtkTranslucencyOption& option : pass->GetOptions())
  {
    EXPECT_EQ(option.Get(), option.Default) << option.Name;
  }
  EXPECT_TRUE(pass->SetOption("budget_mebibytes", "64"));
  EXPECT_EQ(pass->GetBudgetMebibytes(), 64);
}
