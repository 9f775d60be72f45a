// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// What people do with a scene besides looking at it: selecting, picking, moving the camera.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkAreaPicker.h>
#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkCullerCollection.h>
#include <vtkHardwareSelector.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkLineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp3DCollection.h>
#include <vtkPropPicker.h>
#include <vtkProperty.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSphereSource.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

namespace
{
struct Technique
{
  std::string Name;
  std::function<vtkSmartPointer<vtkTranslucencyPass>()> New;
  int Samples;
};

void PrintTo(const Technique& value, std::ostream* os)
{
  *os << value.Name;
}

std::vector<Technique> Techniques()
{
  std::vector<Technique> techniques;
  for (int samples : { 0, 4 })
  {
    const std::string suffix = samples > 0 ? "MultiSampled" : "";
    techniques.push_back({ "Exact" + suffix,
      [] { return vtkSmartPointer<vtkTranslucencyPass>(vtkSmartPointer<vtkABufferPass>::New()); }, samples });
    techniques.push_back({ "Adaptive" + suffix,
      [] { return vtkSmartPointer<vtkTranslucencyPass>(vtkSmartPointer<vtkAdaptiveTransparencyPass>::New()); },
      samples });
  }
  return techniques;
}

/// Balls that reach through each other, one of them opaque.
class Balls : public View
{
public:
  explicit Balls(int samples)
    : View(200, 160, samples)
  {
    for (int i = 0; i < 4; ++i)
    {
      vtkNew<vtkSphereSource> source;
      source->SetThetaResolution(30);
      source->SetPhiResolution(30);
      source->SetCenter(0.5 * i, 0.2 * (i % 2), 0.3 * ((i + 1) % 3));
      source->SetRadius(0.5);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(source->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetOpacity(i == 1 ? 1 : 0.4);
      this->Renderer->AddActor(actor);
      this->Numbers[actor] = i;
    }
    this->Renderer->ResetCamera();
  }

  using Ids = std::set<std::pair<int, vtkIdType>>; // the ball's number, and that of its cell or point

  Ids Select(int association)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(20, 10, 170, 140);
    selector->SetFieldAssociation(association);
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    Ids ids;
    for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
    {
      vtkSelectionNode* node = selection->GetNode(i);
      auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
      auto* list = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
      for (vtkIdType k = 0; k < list->GetNumberOfTuples(); ++k)
      {
        ids.insert({ this->Numbers.at(prop), list->GetValue(k) });
      }
    }
    return ids;
  }

  // -1 for what is none.
  int GetNumber(vtkProp* ball) const
  {
    const auto found = this->Numbers.find(ball);
    return found == this->Numbers.end() ? -1 : found->second;
  }

private:
  std::map<vtkProp*, int> Numbers;
};

class TestInteraction
  : public RenderTest
  , public testing::WithParamInterface<Technique>
{
};
}

//------------------------------------------------------------------------------
TEST_P(TestInteraction, SelectsTheSameCellsAndPoints)
{
  for (int association : { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    Balls stock(GetParam().Samples);
    stock.Render();
    const Balls::Ids expected = stock.Select(association);
    ASSERT_GT(expected.size(), 100u);

    Balls balls(GetParam().Samples);
    balls.SetPass(GetParam().New());
    const Picture before = balls.Render();
    EXPECT_EQ(balls.Select(association), expected);
    EXPECT_EQ(Compare(balls.Render(), before).Largest, 0) << "after selecting";
  }
}

//------------------------------------------------------------------------------
// Pickers by depth find what is opaque, as they do with blending.
TEST_P(TestInteraction, LeavesTheDepthOfWhatIsOpaque)
{
  Balls stock(GetParam().Samples);
  stock.Render();
  Balls balls(GetParam().Samples);
  balls.SetPass(GetParam().New());
  balls.Render();
  const auto depths = [](View& view)
  {
    std::vector<float> values(200 * 160);
    view.Window->GetZbufferData(0, 0, 199, 159, values.data());
    return values;
  };
  const std::vector<float> expected = depths(stock);
  ASSERT_LT(*std::min_element(expected.begin(), expected.end()), 1);
  EXPECT_EQ(depths(balls), expected);
}

//------------------------------------------------------------------------------
TEST_P(TestInteraction, MovingCameraReusesEveryBuffer)
{
  Balls balls(GetParam().Samples);
  const auto pass = GetParam().New();
  balls.SetPass(pass);
  vtkTypeInt64 least = VTK_TYPE_INT64_MAX; // fragments
  vtkTypeInt64 most = 0;
  vtkTypeInt64 bytes = 0;
  for (int frame = 0; frame < 60; ++frame)
  {
    balls.Renderer->GetActiveCamera()->Azimuth(6);
    balls.Renderer->ResetCameraClippingRange();
    balls.Render();
    vtkTranslucencyStatistics* statistics = pass->GetStatistics();
    least = std::min(least, statistics->GetFragments());
    most = std::max(most, statistics->GetFragments());
    // The first frame that finds the view moved makes room for more movement.
    bytes = frame <= 1 ? statistics->GetBytes() : bytes;
    EXPECT_EQ(statistics->GetBytes(), bytes) << "frame " << frame;
  }
  EXPECT_GT(most, 1.5 * least);
}

//------------------------------------------------------------------------------
// Where the balls' boxes lie tells how much room the first frame needs; what it held, how much the others do.
TEST_P(TestInteraction, DrawsFirstFramesAndMovingViewsOnce)
{
  Balls balls(GetParam().Samples);
  const auto pass = GetParam().New();
  balls.SetPass(pass);
  for (int frame = 0; frame < 40; ++frame)
  {
    SCOPED_TRACE(frame);
    if (frame == 20) // in a larger window, too
    {
      balls.Window->SetSize(330, 250);
    }
    balls.Renderer->GetActiveCamera()->Azimuth(9);
    balls.Renderer->GetActiveCamera()->Dolly(frame % 20 < 10 ? 1.05 : 0.95);
    balls.Renderer->ResetCameraClippingRange();
    balls.Render();
    EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 1);
  }
  vtkNew<vtkSphereSource> source; // a prop that is new
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.4);
  balls.Renderer->AddActor(actor);
  balls.Render();
  EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 1);
}

//------------------------------------------------------------------------------
// Boxes that are much larger than what is drawn in them.
TEST_P(TestInteraction, GivesBackWhatTheFirstFrameTookTooMuch)
{
  View view(200, 160, GetParam().Samples);
  const auto add = [&view](double y, double x1, double y1)
  {
    vtkNew<vtkLineSource> source;
    source->SetPoint1(-1, y, 0);
    source->SetPoint2(x1, y1, 0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(0.4);
    view.Renderer->AddActor(actor);
  };
  for (int i = 0; i < 8; ++i)
  {
    add(-1, 1, 1 - 0.1 * i);
  }
  view.Renderer->ResetCamera();
  const auto pass = GetParam().New();
  view.SetPass(pass);
  view.Render();
  const vtkTypeInt64 first = pass->GetStatistics()->GetBytes();
  view.Render();
  const vtkTypeInt64 bytes = pass->GetStatistics()->GetBytes();
  EXPECT_LT(bytes, first / 2);
  view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetBytes(), bytes);
}

//------------------------------------------------------------------------------
// Pickers by ray (vtkCellPicker), by frustum (vtkAreaPicker) and of props (vtkPropPicker, by hardware) after a frame of
// the pass.
TEST_P(TestInteraction, PickersFindWhatTheyFindWithout)
{
  Balls balls(GetParam().Samples);
  const auto pick = [&balls]
  {
    balls.Window->Render();
    std::vector<int> found;
    vtkNew<vtkCellPicker> ray;
    vtkNew<vtkPropPicker> prop;
    for (const auto& at : { std::array<double, 2>{ { 100, 80 } }, { { 60, 70 } }, { { 140, 90 } }, { { 3, 3 } } })
    {
      ray->Pick(at[0], at[1], 0, balls.Renderer);
      found.push_back(static_cast<int>(ray->GetCellId()));
      found.push_back(balls.GetNumber(ray->GetActor()));
      prop->Pick(at[0], at[1], 0, balls.Renderer);
      found.push_back(balls.GetNumber(prop->GetActor()));
    }
    vtkNew<vtkAreaPicker> area;
    area->AreaPick(20, 20, 90, 140, balls.Renderer);
    found.push_back(area->GetProp3Ds()->GetNumberOfItems());
    return found;
  };
  const std::vector<int> without = pick();
  balls.SetPass(GetParam().New());
  EXPECT_EQ(pick(), without);
  EXPECT_EQ(std::count(without.begin(), without.end(), -1), 3) << "nothing lies in the corner, all else is hit";
}

//------------------------------------------------------------------------------
TEST_P(TestInteraction, PropsOutsideOfTheFrustumAreCulled)
{
  Balls balls(GetParam().Samples);
  const auto pass = GetParam().New();
  balls.SetPass(pass);
  const Picture all = balls.Render();
  const int drawn = pass->GetNumberOfRenderedProps();
  vtkNew<vtkSphereSource> source;
  source->SetCenter(40, 0, 0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> outside;
  outside->SetMapper(mapper);
  outside->GetProperty()->SetOpacity(0.5);
  balls.Renderer->AddActor(outside);
  EXPECT_EQ(Compare(all, balls.Render()).Largest, 0);
  EXPECT_EQ(pass->GetNumberOfRenderedProps(), drawn);
  balls.Renderer->GetCullers()->RemoveAllItems();
  EXPECT_EQ(Compare(all, balls.Render()).Largest, 0);
  EXPECT_EQ(pass->GetNumberOfRenderedProps(), drawn + 1) << "without cullers it is drawn, where nobody sees it";
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, TestInteraction, testing::ValuesIn(Techniques()), [](const auto& info) { return info.param.Name; });
