// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// What must not become slow without anyone noticing: ratios of times taken in turn, with bounds that only a cliff
// passes.
#include "RenderTest.h"

#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <chrono>

class TestSpeed : public RenderTest
{
protected:
  /// Milliseconds: the shortest of some resolves.
  double GetResolveTime(vtkAdaptiveTransparencyPass* pass)
  {
    View view(this->Scene);
    view.SetPass(pass);
    pass->MeasureTimesOn();
    double shortest = VTK_DOUBLE_MAX;
    for (int frame = 0; frame < 4; ++frame)
    {
      view.Render();
      shortest = std::min(shortest, pass->GetStatistics()->GetResolveTime());
    }
    return shortest;
  }

  const AnalyticScene Scene = RandomMosaic(128, 128, 1, 150, 0.02, 0.1);
};

//------------------------------------------------------------------------------
// The steps of 64 nodes are four times those of 16, and were measured to take four to six times as long. A compiler
// that does not unroll a loop over the nodes makes the resolve ten times slower.
TEST_F(TestSpeed, NodesStayInRegistersUpTo64)
{
  for (int removal : { vtkAdaptiveTransparencyPass::Underestimate, vtkAdaptiveTransparencyPass::Overestimate,
         vtkAdaptiveTransparencyPass::Mixed })
  {
    vtkNew<vtkAdaptiveTransparencyPass> few;
    vtkNew<vtkAdaptiveTransparencyPass> many;
    few->SetNodeRemoval(removal);
    many->SetNodeRemoval(removal);
    few->SetNodeCount(16);
    many->SetNodeCount(64);
    const double least = this->GetResolveTime(few);
    EXPECT_LT(this->GetResolveTime(many), 10 * least) << "removal " << removal;
  }
}

// Where the driver keeps no shaders of other runs, as ctest has it: what is compiled for the first frame is compiled
// for all of them, also by a driver that compiles for states (vtkTranslucencySamplers). The second frame took a
// twentieth of the first one's time, and half of it where shaders were compiled again.
TEST_F(TestSpeed, TheSecondFrameCompilesNothing)
{
  for (int samples : { 0, 4 })
  {
    SCOPED_TRACE(samples);
    View view(RandomMosaic(80, 60, 2, 20, 0.02, 0.5), samples);
    view.SetPass(vtkSmartPointer<vtkABufferPass>::New());
    const auto timeFrame = [&view]
    {
      using Clock = std::chrono::steady_clock;
      const auto begin = Clock::now();
      view.Render();
      return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    };
    const double first = timeFrame();
    EXPECT_LT(timeFrame(), first / 4) << "milliseconds";
  }
}
