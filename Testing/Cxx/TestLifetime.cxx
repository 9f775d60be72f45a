// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpenGL objects of a pass: gone with it, or when they are released, whatever happens to its windows.
#include "GLState.h"
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkAutomaticTransparencyPass.h>
#include <vtkFragmentStorage.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkTranslucencyVTKVersion.h>

#include <functional>
#include <map>
#include <regex>

namespace
{
/// How many there are of each kind in the window's context.
using Objects = std::map<std::string, int>;

Objects CountObjects(View& view)
{
  constexpr GLuint MostNames = 1024; // drivers give the lowest that is free
  view.Window->MakeCurrent();
  Objects objects;
  for (GLuint name = 1; name <= MostNames; ++name)
  {
    objects["buffers"] += glIsBuffer(name);
    objects["framebuffers"] += glIsFramebuffer(name);
    objects["renderbuffers"] += glIsRenderbuffer(name);
    objects["queries"] += glIsQuery(name);
    objects["textures"] += glIsTexture(name);
    objects["vertex arrays"] += glIsVertexArray(name);
  }
  return objects;
}

AnalyticScene Layers()
{
  return RandomLayers(100, 75, 81, 12, 0.1, 0.5);
}

struct Case
{
  std::string Name;
  std::function<vtkSmartPointer<vtkTranslucencyPass>()> New;
  int Samples;
};

void PrintTo(const Case& value, std::ostream* os)
{
  *os << value.Name;
}

class TestLifetime
  : public RenderTest
  , public testing::WithParamInterface<Case>
{
protected:
  /// A view as it is after it has drawn without the pass: what VTK itself makes is there.
  struct Watched
  {
    explicit Watched(int samples)
      : Shown(Layers(), samples)
    {
      AddBall(this->Shown.Renderer, true, 50, 37.5, -0.6); // for which the opaque depth is copied
      this->Shown.Render();
      this->Before = CountObjects(this->Shown);
    }

    void ExpectNoneLeft(const std::string& when)
    {
      EXPECT_EQ(CountObjects(this->Shown), this->Before) << when;
      EXPECT_TRUE(TakeGLErrors().empty()) << when;
    }

    View Shown;
    Objects Before;
  };
};
}

//------------------------------------------------------------------------------
TEST_P(TestLifetime, ReleasesAllThatItMade)
{
  Watched watched(GetParam().Samples);
  View& view = watched.Shown;
  auto pass = GetParam().New();
  view.SetPass(pass);
  const Picture drawn = view.Render();
  if (GetParam().Name.compare(0, 6, "sorted") != 0) // blends into the window's own picture
  {
    EXPECT_NE(CountObjects(view), watched.Before);
  }
  pass->ReleaseGraphicsResources(view.Window);
  watched.ExpectNoneLeft("after ReleaseGraphicsResources");
  EXPECT_EQ(Compare(view.Render(), drawn).Largest, 0);
  view.SetPass(nullptr);
  EXPECT_EQ(pass->GetReferenceCount(), 1); // mappers that have drawn with it don't keep it alive
  view.Render();
  pass = nullptr;
  watched.ExpectNoneLeft("after its end");
}

//------------------------------------------------------------------------------
TEST_P(TestLifetime, FramesMakeNothingAnew)
{
  Watched watched(GetParam().Samples);
  View& view = watched.Shown;
  view.SetPass(GetParam().New());
  for (int frame = 0; frame < 3; ++frame)
  {
    view.Render(); // gives back what the frame before took too much, of an M-buffer the second one, too
  }
  Objects first = CountObjects(view);
  for (int frame = 0; frame < 5; ++frame)
  {
    view.Render();
  }
  Objects last = CountObjects(view);
  first.erase("queries"); // each of VTK's mappers makes one when it has been drawn a hundred times, to time itself
  last.erase("queries");
  EXPECT_EQ(last, first);
  EXPECT_TRUE(TakeGLErrors().empty());
}

//------------------------------------------------------------------------------
TEST_P(TestLifetime, SharedByTwoWindowsLeavesNothingInEither)
{
  Watched first(GetParam().Samples);
  Watched second(GetParam().Samples);
  auto pass = GetParam().New();
  first.Shown.SetPass(pass);
  second.Shown.SetPass(pass);
  const Picture drawn = first.Shown.Render();
  for (int turn = 0; turn < 3; ++turn)
  {
    EXPECT_EQ(Compare(second.Shown.Render(), drawn).Largest, 0);
    EXPECT_EQ(Compare(first.Shown.Render(), drawn).Largest, 0);
  }
  first.Shown.SetPass(nullptr);
  second.Shown.SetPass(nullptr);
  first.Shown.Render();
  second.Shown.Render();
  EXPECT_EQ(pass->GetReferenceCount(), 1);
  pass = nullptr;
  first.ExpectNoneLeft("in the first window");
  second.ExpectNoneLeft("in the second window");
}

//------------------------------------------------------------------------------
TEST_P(TestLifetime, WindowIsClosedAndReopened)
{
  Watched watched(GetParam().Samples);
  View& view = watched.Shown;
  const auto pass = GetParam().New();
  view.SetPass(pass);
  const Picture drawn = view.Render();
  const Objects open = CountObjects(view);
  for (int turn = 0; turn < 3; ++turn)
  {
    view.Window->Finalize();
    EXPECT_EQ(Compare(view.Render(), drawn).Largest, 0);
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  }
  EXPECT_LE(CountObjects(view).at("buffers"), open.at("buffers"));
  EXPECT_LE(CountObjects(view).at("textures"), open.at("textures"));
  EXPECT_TRUE(TakeGLErrors().empty());
}

//------------------------------------------------------------------------------
class TestLifetimeOfChosen : public TestLifetime
{
};

// What a pass has left for another technique has left nothing behind.
TEST_F(TestLifetimeOfChosen, EndsWithTheChoice)
{
  for (int samples : { 0, 4 })
  {
    Watched watched(samples);
    View& view = watched.Shown;
    auto pass = vtkSmartPointer<vtkAutomaticTransparencyPass>::New();
    pass->SetBudgetMebibytes(0.75);
    view.SetPass(pass);
    view.Render();
    const std::string first = pass->GetChosen();
    view.Render();
    EXPECT_NE(pass->GetChosen(), first);
    EXPECT_GT(CountObjects(view).at("queries"), watched.Before.at("queries"));
    pass->ReleaseGraphicsResources(view.Window);
    watched.ExpectNoneLeft("after ReleaseGraphicsResources");
    view.Render();
    view.SetPass(nullptr);
    view.Render();
    EXPECT_EQ(pass->GetReferenceCount(), 1);
    pass = nullptr;
    watched.ExpectNoneLeft("after its end");
  }
}

//------------------------------------------------------------------------------
class TestLifetimeOfStorage : public TestLifetime
{
};

TEST_F(TestLifetimeOfStorage, EndsWithTheDesign)
{
  Watched watched(0);
  View& view = watched.Shown;
  auto pass = vtkSmartPointer<vtkABufferPass>::New();
  view.SetPass(pass);
  const Picture drawn = view.Render();
  const int designs = static_cast<int>(AllStorages().size());
  for (int next = 1; next <= designs; ++next)
  {
    const int design = next % designs;
    SCOPED_TRACE(design);
    const vtkSmartPointer<vtkFragmentStorage> before = pass->GetStorage();
    EXPECT_GT(before->GetBytes(), 0);
    pass->SetStorageDesign(design);
    EXPECT_EQ(before->GetReferenceCount(), 1);
    EXPECT_EQ(before->GetBytes(), 0);
    watched.ExpectNoneLeft("after another design");
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_EQ(Compare(view.Render(), drawn).Largest, 0);
      EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    }
  }
  view.SetPass(nullptr);
  view.Render();
  EXPECT_EQ(pass->GetReferenceCount(), 1);
  pass = nullptr;
  watched.ExpectNoneLeft("after its end");
}

namespace
{
std::vector<Case> Cases()
{
  std::vector<Case> cases;
  for (int samples : { 0, 4 })
  {
    const std::string suffix = samples > 0 ? "MultiSampled" : "";
    // With a choice that holds other objects than the default does, too.
    std::vector<Way> ways = AllWays();
    for (const std::string& storage : AllStorages())
    {
      if (storage == "t-buffer" || (storage != "linked-list" && samples == 0))
      {
        ways.push_back({ "exact", "storage", storage });
      }
    }
    for (const Way& way : ways)
    {
      const auto create = [way]
      { return vtkSmartPointer<vtkTranslucencyPass>(vtkTranslucencyPass::SafeDownCast(NewPass(way))); };
      if (create())
      {
        cases.push_back(
          { std::regex_replace(way.Technique + way.Choice, std::regex("-"), "") + suffix, create, samples });
      }
    }
  }
  const auto createCounted = [] { return NewCounting({ { "storage", "r-buffer" } }); };
  cases.push_back({ "exactrbufferCounted", createCounted, 0 });
  return cases;
}
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, TestLifetime, testing::ValuesIn(Cases()), [](const auto& info) { return info.param.Name; });
