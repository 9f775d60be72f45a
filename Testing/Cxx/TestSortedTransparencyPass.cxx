// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Blending in the order of depth: exact where objects, or polygons, lie one behind the other as a whole; and nothing of
// the user's is changed.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSortedTransparencyPass.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace
{
constexpr double LeastAlpha = 0.2;

// Over rounds source, destination and sum at each layer, by 1/255 at most together, of which each later layer hides a
// part.
constexpr double OverBound = 1 / LeastAlpha + 0.5;
constexpr double UnderBound = 1.5; // rounds once, and what shows through

struct Case
{
  std::string Name;
  int Order;
  int Operator;
  int Samples;
};

void PrintTo(const Case& value, std::ostream* os)
{
  *os << value.Name;
}

std::vector<Case> Cases(bool onlyCentroid)
{
  using Pass = vtkSortedTransparencyPass;
  std::vector<Case> cases;
  for (int samples : { 0, 4 })
  {
    for (const auto& [order, orderName] :
      { std::pair(Pass::Object, "Object"), { Pass::Centroid, "Centroid" }, { Pass::Backface, "Backface" } })
    {
      for (const auto& [which, operatorName] : { std::pair(Pass::Over, "Over"), { Pass::Under, "Under" } })
      {
        if (onlyCentroid && order != Pass::Centroid)
        {
          continue;
        }
        cases.push_back(
          { std::string(orderName) + operatorName + (samples > 0 ? "MultiSampled" : ""), order, which, samples });
      }
    }
  }
  return cases;
}

AnalyticScene Layers()
{
  return RandomLayers(200, 150, 201, 15, LeastAlpha, 0.8);
}

/// The same as one actor with many rectangles.
AnalyticScene OneActor()
{
  AnalyticScene scene = Layers().RoundedToBytes();
  Layer all;
  for (const Layer& layer : scene.Translucent)
  {
    all.push_back(layer.front());
  }
  scene.Translucent = { all };
  return scene;
}

vtkActor* LastActor(View& view)
{
  return vtkActor::SafeDownCast(view.Renderer->GetViewProps()->GetLastProp());
}

class TestSorted
  : public RenderTest
  , public testing::WithParamInterface<Case>
{
protected:
  void SetUp() override
  {
    RenderTest::SetUp();
    this->Pass->SetOrder(GetParam().Order);
    this->Pass->SetOperator(GetParam().Operator);
  }

  double GetBound() const { return GetParam().Operator == vtkSortedTransparencyPass::Over ? OverBound : UnderBound; }

  void ExpectExact(View& view, const AnalyticScene& scene, const std::string& what)
  {
    const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, this->GetBound()) << what << ": " << difference;
    EXPECT_EQ(this->Pass->GetStatistics()->GetFallback(), "");
  }

  vtkNew<vtkSortedTransparencyPass> Pass;
};

/// By centroid.
class TestSortedPolygons : public TestSorted
{
};
}

//------------------------------------------------------------------------------
TEST_P(TestSorted, IsExactForObjectsBehindEachOther)
{
  for (const AnalyticScene& scene : { Layers(), Layers().Reversed() })
  {
    View view(scene, GetParam().Samples);
    view.SetPass(this->Pass);
    this->ExpectExact(view, scene, "layers");
  }
}

//------------------------------------------------------------------------------
// Equal depths: the one drawn later is in front, whichever way they are blended.
TEST_P(TestSorted, KeepsTheOrderOfDrawingAtEqualDepths)
{
  AnalyticScene scene = Layers();
  for (Layer& layer : scene.Translucent)
  {
    layer.front().Depth = 0.25;
  }
  View view(scene, GetParam().Samples);
  view.SetPass(this->Pass);
  this->ExpectExact(view, scene, "layers of one depth");
}

//------------------------------------------------------------------------------
TEST_P(TestSortedPolygons, AreSortedAnewWhenDataOrTransformationChange)
{
  const AnalyticScene scene = OneActor();
  AnalyticScene turned = scene;
  for (Rectangle& rectangle : turned.Translucent.front())
  {
    rectangle.Depth = 1 - rectangle.Depth;
  }
  View view(scene, GetParam().Samples);
  view.SetPass(this->Pass);
  this->ExpectExact(view, scene, "at first");

  vtkActor* actor = LastActor(view);
  actor->SetScale(1, 1, -1);
  this->ExpectExact(view, turned, "transformed");

  vtkPoints* points = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput()->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double* point = points->GetPoint(i);
    points->SetPoint(i, point[0], point[1], -point[2]);
  }
  points->Modified();
  this->ExpectExact(view, scene, "with other data");

  this->Pass->SetOrder(vtkSortedTransparencyPass::Object);
  EXPECT_GE(Compare(view.Render(), scene.Compute(Reference::CompositeExact)).Largest, 50);
}

//------------------------------------------------------------------------------
// Shaders are built anew, and polygons sorted, only if something has changed.
TEST_P(TestSorted, LeavesActorsAsTheyAre)
{
  const AnalyticScene scene = OneActor();
  View view(scene, GetParam().Samples);
  view.SetPass(this->Pass);
  view.Render();
  vtkActor* actor = LastActor(view);
  const auto times = [actor]
  {
    return std::vector<vtkMTimeType>{ actor->GetMTime(), actor->GetProperty()->GetMTime(),
      actor->GetMapper()->GetMTime(), actor->GetMapper()->GetInput()->GetMTime() };
  };
  const std::vector<vtkMTimeType> before = times();
  const Picture drawn = view.Render();
  EXPECT_EQ(this->Pass->GetStatistics()->GetShaderBuilds(), 0);
  EXPECT_EQ(view.Render(), drawn);
  EXPECT_EQ(this->Pass->GetStatistics()->GetShaderBuilds(), 0);
  EXPECT_EQ(times(), before);
  EXPECT_EQ(actor->GetProperty()->GetFrontfaceCulling(), 0);
}

INSTANTIATE_TEST_SUITE_P(
  Orders, TestSorted, testing::ValuesIn(Cases(false)), [](const auto& info) { return info.param.Name; });
INSTANTIATE_TEST_SUITE_P(
  Orders, TestSortedPolygons, testing::ValuesIn(Cases(true)), [](const auto& info) { return info.param.Name; });

namespace
{
/// Two balls, one before the other, of another colour inside: else it does not matter which faces are in front.
void AddBalls(View& view)
{
  AnalyticScene empty;
  empty.Width = 200;
  empty.Height = 150;
  empty.AddTo(view.Renderer);
  vtkNew<vtkProperty> inside;
  inside->SetColor(1, 0, 0);
  inside->SetOpacity(0.5);
  for (const auto& [x, z] : { std::pair(80, 0.5), std::pair(120, -0.5) })
  {
    AddBall(view.Renderer, false, x, 75, z);
    vtkProperty* outside = LastActor(view)->GetProperty();
    LastActor(view)->SetBackfaceProperty(inside);
    for (vtkProperty* side : { outside, inside.Get() })
    {
      side->LightingOff(); // VTK lights what is mirrored from the wrong side
      side->SetAmbient(1);
      side->SetDiffuse(0);
    }
  }
}

/// How a view of balls differs between the pass and the exact one.
double DifferenceToExact(int order, int samples, const std::function<void(vtkActor*)>& arrange)
{
  View view(200, 150, samples);
  AddBalls(view);
  arrange(LastActor(view));
  vtkNew<vtkSortedTransparencyPass> sorted;
  sorted->SetOrder(order);
  view.SetPass(sorted);
  const Picture drawn = view.Render();
  view.SetPass(vtkSmartPointer<vtkABufferPass>::New());
  return Compare(drawn, view.Render()).Largest;
}
}

//------------------------------------------------------------------------------
using TestBackface = RenderTest;

TEST_F(TestBackface, IsExactForConvexObjects)
{
  const std::pair<std::string, std::function<void(vtkActor*)>> arrangements[] = {
    { "as it is", [](vtkActor*) {} }, { "mirrored", [](vtkActor* ball) { ball->SetScale(-1, 1, 0.005); } },
    { "without back faces", [](vtkActor* ball) { ball->GetProperty()->BackfaceCullingOn(); } },
    { "without front faces", [](vtkActor* ball) { ball->GetProperty()->FrontfaceCullingOn(); } },
    { "as lines",
      [](vtkActor* ball)
      { ball->GetProperty()->SetRepresentationToWireframe(); } }, // in one colour: of lines, none is behind
  };
  for (int samples : { 0, 4 })
  {
    for (const auto& [name, arrange] : arrangements)
    {
      EXPECT_LE(DifferenceToExact(vtkSortedTransparencyPass::Backface, samples, arrange), 4) << name << ", " << samples;
    }
  }
  EXPECT_GE(DifferenceToExact(vtkSortedTransparencyPass::Object, 0, [](vtkActor*) {}), 20);
}

//------------------------------------------------------------------------------
using TestSortedOptions = RenderTest;

TEST_F(TestSortedOptions, NamesMappersThatCanNotBeSorted)
{
  const AnalyticScene scene = OneActor();
  View view(scene);
  vtkActor* actor = LastActor(view);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(actor->GetMapper()->GetInput());
  actor->SetMapper(mapper);
  vtkNew<vtkSortedTransparencyPass> pass;
  view.SetPass(pass);
  const Picture byObject = view.Render();
  EXPECT_TRUE(TakeMessages().empty());
  pass->SetOrder(vtkSortedTransparencyPass::Centroid);
  EXPECT_EQ(view.Render(), byObject);
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("polygons of vtkDataSetMapper are not sorted"), std::string::npos) << messages[0];
}

//------------------------------------------------------------------------------
// Nothing overlaps here: sorted or not, it is the same picture.
TEST_F(TestSortedOptions, CellsOfSeveralKindsKeepTheirColors)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const auto add = [&](vtkCellArray* cells, std::initializer_list<std::array<double, 3>> corners)
  {
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const auto& corner : corners)
    {
      cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
    }
    const auto number = static_cast<unsigned char>(lines->GetNumberOfCells() + polygons->GetNumberOfCells());
    const unsigned char color[] = { static_cast<unsigned char>(60 * number), 0,
      static_cast<unsigned char>(255 - 60 * number) };
    colors->InsertNextTypedTuple(color);
  };
  add(lines, { { 10, 20, 0 }, { 190, 20, 0 } });
  add(lines, { { 10, 40, -0.8 }, { 190, 40, -0.8 } });
  add(polygons, { { 10, 60, 0.5 }, { 60, 60, 0.5 }, { 60, 140, 0.5 } });
  add(polygons, { { 100, 60, -0.5 }, { 150, 60, -0.5 }, { 150, 140, -0.5 }, { 100, 140, -0.5 } });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);

  AnalyticScene empty;
  empty.Width = 200;
  empty.Height = 150;
  View view(empty);
  const Picture background = view.Render();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.5);
  view.Renderer->AddActor(actor);
  vtkNew<vtkSortedTransparencyPass> pass;
  view.SetPass(pass);
  const Picture unsorted = view.Render();
  EXPECT_GE(Compare(unsorted, background).Largest, 50);
  pass->SetOrder(vtkSortedTransparencyPass::Centroid);
  EXPECT_EQ(view.Render(), unsorted);
}

//------------------------------------------------------------------------------
TEST_F(TestSortedOptions, OutOfRangeAreErrorsAndChangeNothing)
{
  vtkNew<vtkSortedTransparencyPass> pass;
  const vtkMTimeType before = pass->GetMTime();
  for (int value : { -1, 3 })
  {
    pass->SetOrder(value);
    std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("Order is " + std::to_string(value) + ", expected object (0)"), std::string::npos)
      << messages[0];
    pass->SetOperator(value);
    messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("Operator is " + std::to_string(value) + ", expected over (0)"), std::string::npos)
      << messages[0];
  }
  EXPECT_EQ(pass->GetMTime(), before);
  EXPECT_EQ(pass->GetOption("order"), "object");
  EXPECT_EQ(pass->GetOption("operator"), "over");
  EXPECT_TRUE(pass->SetOption("operator", "under"));
  EXPECT_EQ(pass->GetOperator(), vtkSortedTransparencyPass::Under);
}
