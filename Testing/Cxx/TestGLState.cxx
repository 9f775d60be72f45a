// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpenGL is left as it was found, without an error, whatever is drawn and also when something fails.
#include "GLState.h"
#include "RenderTest.h"
#include "WatchedPass.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCommand.h>
#include <vtkFragmentStorage.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyOption.h>
#include <vtkTranslucencyPass.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkTranslucencyVTKVersion.h>

#include <array>

namespace
{
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
  { "Cells", [](View& view, vtkFragmentListPass*) { RandomMosaic(400, 300, 1, 3, 0.1, 0.5).AddTo(view.Renderer); },
    false },
  { "LitSurface", [](View& view, vtkFragmentListPass*) { AddBall(view.Renderer, false, 200, 100, 0); }, false },
  { "PointsAsSpheres", [](View& view, vtkFragmentListPass*) { AddBall(view.Renderer, true, 200, 100, 0); }, false },
  { "Tiles", [](View&, vtkFragmentListPass* pass) { pass->GetStorage()->SetMemoryLimit(1); }, false },
  { "Timers", [](View&, vtkFragmentListPass* pass) { pass->MeasureTimesOn(); }, false },
  { "Viewport", [](View& view, vtkFragmentListPass*) { view.Renderer->SetViewport(0.25, 0.1, 0.8, 0.7); }, false },
  { "TBufferInTiles",
    [](View&, vtkFragmentListPass* pass)
    {
      pass->SetStorageDesign(vtkFragmentListPass::TBuffer);
      pass->GetStorage()->SetMemoryLimit(1);
    },
    false },
  { "MBufferTimed", // and of other sections from the second frame on
    [](View&, vtkFragmentListPass* pass)
    {
      pass->SetStorageDesign(vtkFragmentListPass::MBuffer);
      pass->MeasureTimesOn();
    },
    false },
  { "TooLittleMemory", [](View&, vtkFragmentListPass* pass) { pass->GetStorage()->SetMemoryLimit(0.001); }, true },
};

/// VTK's mappers leave their textures bound, and bind what they need before each use.
bool IsLeftByMappers(const std::string& name)
{
  return name.compare(0, 19, "GL_TEXTURE_BINDING_") == 0;
}

/// In several frames.
void ExpectNothingChanges(View& view, WatchedPass* watched, bool fallsBack)
{
  for (int frame = 0; frame < 3; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    view.Window->Render();
    EXPECT_EQ(!watched->Pass->GetStatistics()->GetFallback().empty(), fallsBack);
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
}

/// More layers than are resolved in registers.
AnalyticScene Deep()
{
  AnalyticScene scene;
  Layer layer;
  for (int i = 1; i <= 300; ++i)
  {
    layer.push_back({ 190, 140, 210, 150, i / 65536.0, { { 1, 0, 0.2 } }, 3 / 255.0 });
  }
  scene.Translucent = { layer };
  return scene;
}
}

class TestGLState
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Situation, bool>>
{
};

//------------------------------------------------------------------------------
TEST_P(TestGLState, IsAsItWasFound)
{
  const auto& [situation, exact] = GetParam();
  View view(RandomLayers(400, 300, 31, 20, 0.1, 0.5));
  vtkSmartPointer<vtkFragmentListPass> pass;
  if (exact)
  {
    pass = vtkSmartPointer<vtkABufferPass>::New();
  }
  else
  {
    pass = vtkSmartPointer<vtkAdaptiveTransparencyPass>::New();
  }
  vtkNew<WatchedPass> watched;
  watched->Pass = pass;
  view.SetTranslucentPass(watched);
  situation.Arrange(view, pass);

  ExpectNothingChanges(view, watched, situation.FallsBack);
  if (situation.FallsBack)
  {
    TakeMessages();
  }
}

using TestGLStateOfCounting = RenderTest;

TEST_F(TestGLStateOfCounting, IsAsItWasFound)
{
  View view(RandomLayers(400, 300, 31, 20, 0.1, 0.5));
  vtkNew<WatchedPass> watched;
  watched->Pass = NewCounting({ { "storage", "r-buffer" } });
  view.SetTranslucentPass(watched);
  ExpectNothingChanges(view, watched, false);
}

INSTANTIATE_TEST_SUITE_P(Situations, TestGLState, testing::Combine(testing::ValuesIn(Situations), testing::Bool()),
  [](const auto& info) { return std::get<0>(info.param).Name + (std::get<1>(info.param) ? "Exact" : "Adaptive"); });

namespace
{
/// A technique's choices one by one, but for those that drivers may lack.
std::vector<std::pair<std::string, std::string>> GetChoices(vtkTranslucencyPass* pass)
{
  std::vector<std::pair<std::string, std::string>> choices;
  for (const vtkTranslucencyOption& option : pass->GetOptions())
  {
    for (const std::string& choice : option.Choices)
    {
      if (option.Name != "CriticalSection")
      {
        choices.emplace_back(option.Keyword, choice);
      }
    }
  }
  return choices;
}

/// Null where it is VTK's own.
vtkSmartPointer<vtkTranslucencyPass> NewPass(const std::string& technique)
{
  const auto pass = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(technique));
  return vtkTranslucencyPass::SafeDownCast(pass);
}
}

//------------------------------------------------------------------------------
using TestGLStateOfTechniques = RenderTest;

TEST_F(TestGLStateOfTechniques, IsAsItWasFound)
{
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const std::string name = vtkTranslucencyFactory::GetTechniqueName(i);
    const auto declared = NewPass(name);
    if (!declared)
    {
      continue;
    }
    auto choices = GetChoices(declared);
    choices.emplace_back(); // all defaults
    if (name == "auto")
    {
      choices.emplace_back("budget_mebibytes", "0.1"); // by another technique from the second frame on
    }
    for (const auto& [keyword, choice] : choices)
    {
      for (int samples : { 0, 4 })
      {
        SCOPED_TRACE(name + " " + keyword + "=" + choice + ", samples " + std::to_string(samples));
        View view(RandomLayers(50, 40, 32, 6, 0.1, 0.5), samples);
        AddBall(view.Renderer, true, 25, 20, 0);
        vtkNew<WatchedPass> watched;
        watched->Pass = NewPass(name);
        EXPECT_TRUE(keyword.empty() || watched->Pass->SetOption(keyword, choice));
        if (keyword == "precision") // of fixed memory, and else a warning
        {
          EXPECT_TRUE(watched->Pass->SetOption("memory", "fixed"));
        }
        view.SetTranslucentPass(watched);
        ExpectNothingChanges(view, watched, false);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestGLStateOfTechniques, IsAsItWasFoundWithTransmissionColors)
{
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const std::string name = vtkTranslucencyFactory::GetTechniqueName(i);
    for (int samples : { 0, 4 })
    {
      vtkNew<WatchedPass> watched;
      watched->Pass = NewPass(name);
      if (watched->Pass)
      {
        SCOPED_TRACE(name + ", samples " + std::to_string(samples));
        View view(RandomLayers(50, 40, 32, 6, 0.1, 0.5).Transmitting(33), samples);
        view.SetTranslucentPass(watched);
        ExpectNothingChanges(view, watched, false);
        EXPECT_EQ(TakeMessages().empty(), watched->Pass->KeepsTransmissionColors());
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestGLStateOfTechniques, IsAsItWasFoundWhereListsAreLinkedAnew)
{
  for (const std::string& design : AllStorages())
  {
    SCOPED_TRACE(design);
    View view(Deep());
    const auto pass = NewTechnique("exact", { { "storage", design } });
    vtkNew<WatchedPass> watched;
    watched->Pass = pass;
    view.SetTranslucentPass(watched);
    ExpectNothingChanges(view, watched, false);
    EXPECT_TRUE(vtkFragmentListPass::SafeDownCast(pass)->GetStorage()->GetLinks() != vtkFragmentStorage::Links::None);
  }
}

namespace
{
/// Draws by another pass with something bound that is deleted while it draws, when VTK first meets a mapper.
class DeletingPass : public WatchedPass
{
public:
  static DeletingPass* New() { VTK_STANDARD_NEW_BODY(DeletingPass); }
  vtkTypeMacro(DeletingPass, WatchedPass);

  void Render(const vtkRenderState* state) override
  {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* const source = "#version 430\nlayout(local_size_x = 1) in;\nvoid main() {}\n";
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    this->Program = glCreateProgram();
    glAttachShader(this->Program, shader);
    glLinkProgram(this->Program);
    glDeleteShader(shader);
    glUseProgram(this->Program);
    glGenVertexArrays(1, &this->VertexArray);
    glBindVertexArray(this->VertexArray);
    glGenBuffers(static_cast<GLsizei>(this->Buffers.size()), this->Buffers.data());
    glBindBuffer(GL_ARRAY_BUFFER, this->Buffers[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Buffers[1]);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Buffers[2]);
    glBufferData(GL_SHADER_STORAGE_BUFFER, 64, nullptr, GL_STATIC_DRAW);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, this->Buffers[2], 0, 64);
    this->Superclass::Render(state);
  }

  void DeleteBound()
  {
    if (this->Deleted)
    {
      return;
    }
    glDeleteProgram(this->Program);
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(static_cast<GLsizei>(this->Buffers.size()), this->Buffers.data());
    this->Deleted = true;
    // Nobody else gets the names again; they are of nothing until they are bound.
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(static_cast<GLsizei>(this->Buffers.size()), this->Buffers.data());
  }

  bool Deleted = false;

private:
  GLuint Program = 0;
  GLuint VertexArray = 0;
  std::array<GLuint, 3> Buffers{};
};
}

TEST_F(TestGLStateOfTechniques, WhatIsDeletedMeanwhileIsNotBoundAgain)
{
  View view(RandomLayers(50, 40, 32, 6, 0.1, 0.5));
  vtkNew<DeletingPass> deleting;
  deleting->Pass = NewTechnique("exact");
  view.SetTranslucentPass(deleting);
  view.Renderer->GetActors()->GetLastActor()->GetMapper()->AddObserver(
    vtkCommand::UpdateShaderEvent, deleting.Get(), &DeletingPass::DeleteBound);
  view.Window->Render();
  EXPECT_TRUE(deleting->Deleted);
  EXPECT_EQ(deleting->ErrorsAfter, std::vector<std::string>());
  for (const char* name : { "GL_ARRAY_BUFFER_BINDING", "GL_VERTEX_ARRAY_BINDING" })
  {
    EXPECT_EQ(deleting->After[name], std::vector<double>{ 0 }) << name;
  }
}

//------------------------------------------------------------------------------
// Drivers need not have them there, and Mesa takes the wrong blocks for written if both shaders of a program have some
// (Documentation/Drivers.md).
TEST_F(TestGLStateOfTechniques, VertexShadersHaveNoStorageBlocks)
{
  View view(RandomLayers(64, 48, 3, 40, 0.05, 0.6));
  view.SetPass(NewTechnique("exact", {}));
  view.Render();
  view.Window->MakeCurrent();
  int resolves = 0;
  constexpr GLuint most = 1000; // names of programs and shaders
  for (GLuint shader = 1; shader < most; ++shader)
  {
    GLint type = 0;
    GLint length = 0;
    if (glIsShader(shader))
    {
      glGetShaderiv(shader, GL_SHADER_TYPE, &type);
      glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
    }
    if (type == GL_VERTEX_SHADER && length > 0)
    {
      std::string source(static_cast<std::size_t>(length), ' ');
      glGetShaderSource(shader, length, nullptr, &source[0]);
      EXPECT_EQ(source.find("layout(std430"), std::string::npos) << "vertex shader " << shader;
      resolves += source.find("uniform vec4 frameTileNumbers") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GT(resolves, 1);
}
