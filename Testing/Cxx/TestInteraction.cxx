// What people do with a scene besides looking at it: selecting, picking, moving the camera.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkHardwareSelector.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSphereSource.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
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
      [] { return vtkSmartPointer<vtkTranslucencyPass>(vtkSmartPointer<vtkABufferPass>::New()); },
      samples });
    techniques.push_back({ "Adaptive" + suffix,
      []
      {
        return vtkSmartPointer<vtkTranslucencyPass>(
          vtkSmartPointer<vtkAdaptiveTransparencyPass>::New());
      },
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

  using Ids =
    std::set<std::pair<int, vtkIdType>>; // the ball's number, and that of its cell or point

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
  for (int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
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

INSTANTIATE_TEST_SUITE_P(Techniques, TestInteraction, testing::ValuesIn(Techniques()),
  [](const auto& info) { return info.param.Name; });
