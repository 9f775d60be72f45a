// OpenGL is left as it was found, without an error, whatever is drawn and also when something fails.
#include "GLState.h"
#include "RenderTest.h"

#include <vtkFourierOpacityPass.h>
#include <vtkFragmentStorage.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkTranslucencyPass.h>
#include <vtkTranslucencyStatistics.h>

namespace
{
/// Renders another pass and looks at OpenGL before and after.
class WatchedPass : public vtkRenderPass
{
public:
  static WatchedPass* New();
  vtkTypeMacro(WatchedPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    this->ErrorsBefore = TakeGLErrors();
    this->Before = QueryGLState();
    this->Pass->Render(state);
    this->ErrorsAfter = TakeGLErrors();
    this->After = QueryGLState();
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Pass->ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkTranslucencyPass> Pass;
  GLState Before;
  GLState After;
  std::vector<std::string> ErrorsBefore;
  std::vector<std::string> ErrorsAfter;
};
vtkStandardNewMacro(WatchedPass);

struct Situation
{
  std::string Name;
  std::function<void(View&, vtkFragmentListPass*)> Arrange;
  bool FallsBack;
};

void PrintTo(const Situation& value, std::ostream* os)
{
  *os << value.Name;
}

const Situation Situations[] = {
  { "Rectangles", [](View&, vtkFragmentListPass*) {}, false },
  { "Cells",
    [](View& view, vtkFragmentListPass*)
    { RandomMosaic(400, 300, 1, 3, 0.1, 0.5).AddTo(view.Renderer); },
    false },
  { "LitSurface", [](View& view, vtkFragmentListPass*) { AddBall(view.Renderer, false, 200, 100, 0); }, false },
  { "PointsAsSpheres", [](View& view, vtkFragmentListPass*) { AddBall(view.Renderer, true, 200, 100, 0); }, false },
  { "Tiles", [](View&, vtkFragmentListPass* pass) { pass->GetStorage()->SetMemoryLimit(1); },
    false },
  { "Timers", [](View&, vtkFragmentListPass* pass) { pass->MeasureTimesOn(); }, false },
  { "Viewport",
    [](View& view, vtkFragmentListPass*) { view.Renderer->SetViewport(0.25, 0.1, 0.8, 0.7); },
    false },
  { "TooLittleMemory",
    [](View&, vtkFragmentListPass* pass) { pass->GetStorage()->SetMemoryLimit(0.001); }, true },
};

struct Kind
{
  std::string Name;
  std::function<vtkSmartPointer<vtkFragmentListPass>()> New;
  bool Stores; // fragments, for which there may be too little memory
};

void PrintTo(const Kind& value, std::ostream* os)
{
  *os << value.Name;
}

const Kind Kinds[] = {
  { "Exact", [] { return vtkSmartPointer<vtkABufferPass>::New(); }, true },
  { "Adaptive", [] { return vtkSmartPointer<vtkAdaptiveTransparencyPass>::New(); }, true },
  { "FourierFixed",
    []
    {
      auto pass = vtkSmartPointer<vtkFourierOpacityPass>::New();
      pass->SetMemory(vtkAbsorbancePass::Fixed);
      return pass;
    },
    false },
};

/// VTK's mappers leave their textures bound, and bind what they need before each use.
bool IsLeftByMappers(const std::string& name)
{
  return name.compare(0, 19, "GL_TEXTURE_BINDING_") == 0;
}
}

class TestGLState
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Situation, Kind>>
{
};

//------------------------------------------------------------------------------
TEST_P(TestGLState, IsAsItWasFound)
{
  const auto& [situation, kind] = GetParam();
  View view(RandomLayers(400, 300, 31, 20, 0.1, 0.5));
  const vtkSmartPointer<vtkFragmentListPass> pass = kind.New();
  const bool fallsBack = situation.FallsBack && kind.Stores;
  vtkNew<WatchedPass> watched;
  watched->Pass = pass;
  view.SetTranslucentPass(watched);
  situation.Arrange(view, pass);

  for (int frame = 0; frame < 3; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    view.Window->Render();
    pass->GetStatistics()->GetDeepestPixel(); // reads buffers back
    EXPECT_EQ(!pass->GetStatistics()->GetFallback().empty(), fallsBack);
    EXPECT_EQ(watched->ErrorsBefore, std::vector<std::string>());
    EXPECT_EQ(watched->ErrorsAfter, std::vector<std::string>());
    EXPECT_EQ(TakeGLErrors(), std::vector<std::string>());
    for (const auto& before : watched->Before)
    {
      if (!IsLeftByMappers(before.first))
      {
        EXPECT_EQ(before.second, watched->After[before.first]) << before.first;
      }
    }
  }
  EXPECT_GT(watched->Before.size(), 150u);
  if (fallsBack)
  {
    TakeMessages();
  }
}

INSTANTIATE_TEST_SUITE_P(Situations, TestGLState,
  testing::Combine(testing::ValuesIn(Situations), testing::ValuesIn(Kinds)),
  [](const auto& info)
  { return std::get<0>(info.param).Name + std::get<1>(info.param).Name; });
