// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOutputWindow.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkSphereSource.h>
#include <vtkStorageTable.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyOption.h>
#include <vtkTranslucencyPass.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <algorithm>
#include <cctype>

namespace
{
/// Keeps VTK's messages instead of showing them.
class MessageLog : public vtkOutputWindow
{
public:
  static MessageLog* New();
  vtkTypeMacro(MessageLog, vtkOutputWindow);

  void DisplayText(const char* text) override { this->Messages.emplace_back(text); }

  std::vector<std::string> Messages;
};
vtkStandardNewMacro(MessageLog);

MessageLog* Log()
{
  static vtkNew<MessageLog> log;
  return log;
}

/// Stays connected to the display while tests come and go: an X server that loses its last client resets itself, and
/// turns away who comes in meanwhile.
class Display : public testing::Environment
{
public:
  void SetUp() override
  {
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(true);
    this->Window->SetSize(1, 1);
    this->Window->Render();
  }
  void TearDown() override { this->Window = nullptr; }

private:
  vtkSmartPointer<vtkRenderWindow> Window;
};

const testing::Environment* const Connected = testing::AddGlobalTestEnvironment(new Display);
}

//------------------------------------------------------------------------------
View::View(int width, int height, int samples)
{
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(samples);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
View::View(const AnalyticScene& scene, int samples)
  : View(scene.Width, scene.Height, samples)
{
  scene.AddTo(this->Renderer);
}

//------------------------------------------------------------------------------
void View::SetTranslucentPass(vtkRenderPass* pass)
{
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(pass);
  this->Renderer->SetPass(steps);
}

//------------------------------------------------------------------------------
Picture View::Render()
{
  this->Window->Render();
  return Capture(this->Window);
}

//------------------------------------------------------------------------------
void RenderTest::SetUp()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // the log is shown where it matters
  vtkOutputWindow::SetInstance(Log());
  Log()->Messages.clear();
}

//------------------------------------------------------------------------------
void RenderTest::TearDown()
{
  for (const std::string& message : TakeMessages())
  {
    ADD_FAILURE() << "VTK says: " << message;
  }
#ifdef __SANITIZE_ADDRESS__
  // Not at the process' end, when the drivers, which hold what is theirs, have been closed.
  EXPECT_EQ(__lsan_do_recoverable_leak_check(), 0);
#endif
}

//------------------------------------------------------------------------------
std::vector<std::string> RenderTest::TakeMessages()
{
  return std::exchange(Log()->Messages, {});
}

//------------------------------------------------------------------------------
bool KeepsDrawOrder(View& view)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(view.Window);
  window->MakeCurrent();
  return vtkTranslucencyCapabilities::Probe(window).KeepsDrawOrder;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTranslucencyPass> NewTechnique(const std::string& name, const Settings& settings)
{
  auto pass = vtkSmartPointer<vtkTranslucencyPass>::Take(
    vtkTranslucencyPass::SafeDownCast(vtkTranslucencyFactory::CreateTechnique(name)));
  Apply(pass, settings);
  return pass;
}

//------------------------------------------------------------------------------
void Apply(vtkTranslucencyPass* pass, const Settings& settings)
{
  for (const auto& setting : settings)
  {
    EXPECT_TRUE(pass->SetOption(setting.first, setting.second)) << setting.first << "=" << setting.second;
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkStorageCountPass> NewCounting(const Settings& settings)
{
  auto pass = vtkSmartPointer<vtkStorageCountPass>::New();
  Apply(pass, settings);
  return pass;
}

//------------------------------------------------------------------------------
void PrintTo(const Way& way, std::ostream* os)
{
  *os << way.Technique << " " << way.Option << " " << way.Choice;
}

//------------------------------------------------------------------------------
std::vector<Way> AllWays()
{
  std::vector<Way> ways{ { "peel", "method", "front-to-back" }, { "peel", "method", "bucket-sort" },
    { "sorted", "order", "centroid" } };
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const std::string name = vtkTranslucencyFactory::GetTechniqueName(i);
    ways.push_back({ name, "", "" });
    const auto pass = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(name));
    auto* own = vtkTranslucencyPass::SafeDownCast(pass);
    const std::vector<vtkTranslucencyOption> options = own ? own->GetOptions() : std::vector<vtkTranslucencyOption>();
    const bool hasMemories = std::any_of(
      options.begin(), options.end(), [](const vtkTranslucencyOption& option) { return option.Keyword == "memory"; });
    if (hasMemories)
    {
      ways.push_back({ name, "memory", "fixed" });
    }
  }
  return ways;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderPass> NewPass(const Way& way)
{
  if (way.Option.empty())
  {
    return vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(way.Technique));
  }
  return NewTechnique(way.Technique, { { way.Option, way.Choice } });
}

//------------------------------------------------------------------------------
const std::vector<std::string>& AllStorages()
{
  return vtkStorageTable::GetNames();
}

//------------------------------------------------------------------------------
std::string StorageInNames(const std::string& storage)
{
  std::string name;
  bool begins = true;
  for (char letter : storage)
  {
    if (letter != '-')
    {
      name += begins ? static_cast<char>(std::toupper(letter)) : letter;
    }
    begins = letter == '-';
  }
  return name;
}

//------------------------------------------------------------------------------
std::vector<std::string> OwnTechniques()
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    const std::string name = vtkTranslucencyFactory::GetTechniqueName(i);
    const auto pass = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(name));
    if (vtkTranslucencyPass::SafeDownCast(pass))
    {
      names.push_back(name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
Picture Draw(const AnalyticScene& scene, vtkTranslucencyPass* pass)
{
  View view(scene);
  view.SetPass(pass);
  return view.Render();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAdaptiveTransparencyPass> NewAdaptive(int nodeCount, Reference::Removal removal)
{
  auto pass = vtkSmartPointer<vtkAdaptiveTransparencyPass>::New();
  pass->SetNodeCount(nodeCount);
  pass->SetNodeRemoval(static_cast<int>(removal));
  return pass;
}

//------------------------------------------------------------------------------
Compositor AdaptiveCompositor(int nodeCount, Reference::Removal removal, bool corrected)
{
  return [=](const std::vector<Reference::Fragment>& fragments)
  { return Reference::CompositeAdaptive(fragments, nodeCount, removal, corrected); };
}

//------------------------------------------------------------------------------
void AddBall(vtkRenderer* renderer, bool impostors, double x, double y, double z)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(60);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(mapper);
  ball->SetScale(1, 1, 0.005); // the depths of an analytic scene are two units long
  ball->SetPosition(x, y, z);
  ball->GetProperty()->SetOpacity(0.5);
  if (impostors)
  {
    ball->GetProperty()->SetRepresentationToPoints();
    ball->GetProperty()->SetRenderPointsAsSpheres(true);
    ball->GetProperty()->SetPointSize(20);
  }
  renderer->AddActor(ball);
}
