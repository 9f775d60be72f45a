// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "Basics/Failure.h"
#include "Basics/Messages.h"
#include "Scenes/Camera.h"
#include "Scenes/Scene.h"

#include "vtkActor.h"
#include "vtkAutomaticTransparencyPass.h"
#include "vtkCamera.h"
#include "vtkFragmentListPass.h"
#include "vtkFragmentTracePass.h"
#include "vtkFramebufferPass.h"
#include "vtkLight.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPixelBufferObject.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkStorageCountPass.h"
#include "vtkTextureObject.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFactory.h"
#include "vtkTranslucencyMaterial.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyStatistics.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVisibilityFunctionPass.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace
{
vtkSmartPointer<vtkLight> MakeLight(const Light& light)
{
  auto made = vtkSmartPointer<vtkLight>::New();
  switch (light.Type)
  {
    case Light::Kind::Headlight:
      made->SetLightTypeToHeadlight();
      break;
    case Light::Kind::Camera:
      made->SetLightTypeToCameraLight();
      break;
    case Light::Kind::Scene:
      made->SetLightTypeToSceneLight();
      break;
  }
  made->SetPosition(light.Position.data());
  made->SetFocalPoint(light.Target.data());
  made->SetColor(light.Tint.data());
  made->SetIntensity(light.Intensity);
  return made;
}

// The actor with a mapper of its own, so that the shaders of two renderers do not take each other's place.
vtkSmartPointer<vtkActor> CopyActor(vtkActor* actor)
{
  auto copy = vtkSmartPointer<vtkActor>::New();
  copy->ShallowCopy(actor);
  copy->SetShaderProperty(actor->GetShaderProperty());
  copy->SetForceOpaque(actor->GetForceOpaque()); // which the copy leaves out, as the next
  copy->SetForceTranslucent(actor->GetForceTranslucent());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->vtkPolyDataMapper::ShallowCopy(
    actor->GetMapper()); // its OpenGL override warns of properties that it copies itself
  copy->SetMapper(mapper);
  double transmission[3];
  vtkTranslucencyPass::GetTransmissionColor(actor, transmission);
  vtkTranslucencyPass::SetTransmissionColor(copy, transmission[0], transmission[1], transmission[2]);
  vtkTranslucencyMaterial::SetMaterial(copy, vtkTranslucencyMaterial::GetMaterial(actor));
  return copy;
}
}

//------------------------------------------------------------------------------
Stage::Stage(const std::array<int, 2>& size, int samples, bool transparent)
  : Transparent(transparent)
{
  this->Window->SetAlphaBitPlanes(transparent ? 1 : 0);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(samples > 1 ? samples : 0);
  this->Window->SwapBuffersOff();
  this->Window->SetSize(16, 16);
  this->Window->Render(); // makes the context, which the limits are asked of
  Messages::Get()->ThrowError("no OpenGL window can be opened");
  if (!this->GetOpenGLWindow())
  {
    throw Failure(
      "the render window is a " + std::string(this->Window->GetClassName()) + ", expected an OpenGL window");
  }
  // VTK takes what the driver has.
  const int given = std::max(1, this->GetOpenGLWindow()->GetRenderFramebuffer()->GetMultiSamples());
  if (given != samples)
  {
    throw Failure("samples are " + std::to_string(samples) +
      ", but of windows with several samples a pixel this driver has only those of " + std::to_string(given));
  }
  const int limit = vtkTextureObject::GetMaximumTextureSize(this->GetOpenGLWindow());
  if (size[0] > limit || size[1] > limit)
  {
    throw Failure("size is " + std::to_string(size[0]) + "x" + std::to_string(size[1]) + ", expected at most " +
      std::to_string(limit) + "x" + std::to_string(limit) + ", this driver's limit");
  }
  this->Window->SetSize(size[0], size[1]);
}

//------------------------------------------------------------------------------
Stage::~Stage() = default;

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* Stage::GetOpenGLWindow()
{
  return vtkOpenGLRenderWindow::SafeDownCast(this->Window);
}

//------------------------------------------------------------------------------
vtkCamera* Stage::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void Stage::SetCamera(vtkCamera* camera)
{
  this->Camera = camera;
}

//------------------------------------------------------------------------------
int Stage::Add(const Scene& scene, const TechniqueChoice& technique)
{
  return this->AddPass(scene, technique, MakePass(technique));
}

//------------------------------------------------------------------------------
int Stage::AddTrace(const Scene& scene)
{
  return this->AddPass(scene, { "trace", "trace", {} }, vtkSmartPointer<vtkFragmentTracePass>::New());
}

//------------------------------------------------------------------------------
const std::vector<vtkStorageSimulator::Fragment>& Stage::GetFragments(int trace)
{
  auto* pass = vtkFragmentTracePass::SafeDownCast(this->Players[trace].Pass);
  const std::string missing = pass->GetMissing(this->GetOpenGLWindow());
  if (!missing.empty())
  {
    throw Failure("fragments can't be traced: the driver lacks " + missing);
  }
  return pass->GetFragments();
}

//------------------------------------------------------------------------------
int Stage::AddPass(const Scene& scene, const TechniqueChoice& technique, vtkRenderPass* pass)
{
  Player player;
  player.Technique = technique;
  player.Pass = pass;
  player.Renderer = vtkSmartPointer<vtkRenderer>::New();
  const Background behind = BackgroundOf(scene);
  player.Renderer->SetBackground(behind.value_or(Color{ { 0, 0, 0 } }).data());
  player.Renderer->SetBackgroundAlpha(behind ? 1 : 0);
  player.Renderer->DrawOff();
  bool transmits = false;
  bool hasMaterials = false;
  for (const Part& part : scene.Parts)
  {
    player.Renderer->AddActor(CopyActor(part.Actor));
    double transmission[3];
    vtkTranslucencyPass::GetTransmissionColor(part.Actor, transmission);
    transmits = transmits || transmission[0] > 0 || transmission[1] > 0 || transmission[2] > 0;
    hasMaterials = hasMaterials || vtkTranslucencyMaterial::GetMaterial(part.Actor);
  }
  if ((transmits || hasMaterials) && !vtkTranslucencyPass::SafeDownCast(player.Pass))
  {
    const std::string what = transmits && hasMaterials ? "transmission colours and materials"
      : transmits                                      ? "transmission colours"
                                                       : "materials";
    Messages::Get()->DisplayWarningText(("technique '" + technique.Label + "' draws without " + what).c_str());
  }
  for (const Light& light : scene.Lights)
  {
    player.Renderer->AddLight(MakeLight(light));
  }
  vtkTranslucencyFactory::Enable(player.Renderer, player.Pass.Get());
  this->Window->AddRenderer(player.Renderer);
  if (!this->Camera)
  {
    const int* size = this->Window->GetSize();
    this->Camera = vtkSmartPointer<vtkCamera>::New();
    SetUpCamera(scene, static_cast<double>(size[0]) / size[1], this->Camera);
  }
  player.Renderer->SetActiveCamera(this->Camera);
  player.Renderer->ResetCameraClippingRange();
  this->Players.push_back(player);
  return static_cast<int>(this->Players.size()) - 1;
}

//------------------------------------------------------------------------------
double Stage::Draw(int technique)
{
  for (std::size_t i = 0; i < this->Players.size(); ++i)
  {
    this->Players[i].Renderer->SetDraw(static_cast<int>(i) == technique);
  }
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  this->CheckFrame(this->Players[technique]);
  return elapsed.count();
}

//------------------------------------------------------------------------------
std::vector<float> Stage::DrawInFloats(int technique)
{
  vtkRenderer* renderer = this->Players[technique].Renderer;
  const vtkSmartPointer<vtkRenderPass> whole = renderer->GetPass();
  vtkNew<vtkFramebufferPass> floats;
  floats->SetColorFormat(vtkTextureObject::Float32);
  floats->SetDelegatePass(whole);
  renderer->SetPass(floats);
  this->Draw(technique);
  const int* size = this->Window->GetSize();
  constexpr int channels = 4;
  std::vector<float> pixels(static_cast<std::size_t>(channels) * size[0] * size[1]);
  unsigned int extent[] = { static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]) };
  vtkIdType increments[] = { 0, 0 };
  const auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(floats->GetColorTexture()->Download());
  buffer->Download2D(VTK_FLOAT, pixels.data(), extent, channels, increments);
  floats->ReleaseGraphicsResources(this->Window);
  renderer->SetPass(whole);
  Messages::Get()->ThrowError("the picture can't be read back");
  return pixels;
}

//------------------------------------------------------------------------------
void Stage::Settle(int technique)
{
  constexpr int enough = 10; // frames of one choice, more than it takes to tell that another one is needed
  constexpr int most = 200;
  auto* automatic = vtkAutomaticTransparencyPass::SafeDownCast(this->Players[technique].Pass);
  std::string chosen;
  for (int frame = 0, same = 0; automatic && same < enough && frame < most; ++frame)
  {
    this->Draw(technique);
    same = automatic->GetChosen() == chosen ? same + 1 : 0;
    chosen = automatic->GetChosen();
  }
}

//------------------------------------------------------------------------------
void Stage::Orbit(double degrees)
{
  if (degrees != 0)
  {
    this->Camera->Azimuth(degrees);
    this->Players.front().Renderer->ResetCameraClippingRange();
  }
}

//------------------------------------------------------------------------------
void Stage::CheckFrame(const Player& player)
{
  const std::string context = "technique '" + player.Technique.Label + "'";
  Messages::Get()->ThrowError(context);
  auto* pass = vtkTranslucencyPass::SafeDownCast(player.Pass);
  const bool stoodIn = pass && !pass->GetStatistics()->GetFallback().empty();
  if (stoodIn && pass->GetMissing(this->GetOpenGLWindow()).empty())
  {
    throw Failure(context + ": " + Messages::Get()->TakeWarning());
  }
}

//------------------------------------------------------------------------------
FrameStatistics Stage::GetStatistics(int technique)
{
  FrameStatistics statistics;
  auto* pass = vtkTranslucencyPass::SafeDownCast(this->Players[technique].Pass);
  if (pass)
  {
    vtkTranslucencyStatistics* from = pass->GetStatistics();
    statistics.Fallback = from->GetFallback();
    statistics.Known = statistics.Fallback.empty(); // counts are the technique's own, not its stand-in's
    statistics.Fragments = from->GetFragments();
    statistics.DeepestPixel = from->GetDeepestPixel();
    statistics.Mebibytes = from->GetBytes() / (1024.0 * 1024.0);
    statistics.Tiles = from->GetTiles();
    statistics.GeometryPasses = from->GetGeometryPasses();
    statistics.ScreenPasses = from->GetScreenPasses();
    statistics.ShaderBuilds = from->GetShaderBuilds();
    statistics.Transmittances = CountTransmittances(pass);
  }
  if (auto* automatic = vtkAutomaticTransparencyPass::SafeDownCast(pass))
  {
    statistics.Chosen = automatic->GetChosen();
    statistics.Reason = automatic->GetReason();
  }
  return statistics;
}

//------------------------------------------------------------------------------
std::optional<StageTimes> Stage::DrawMeasured(int technique)
{
  auto* pass = vtkTranslucencyPass::SafeDownCast(this->Players[technique].Pass);
  if (!pass)
  {
    return {};
  }
  pass->MeasureTimesOn();
  this->Draw(technique);
  vtkTranslucencyStatistics* statistics = pass->GetStatistics();
  const StageTimes times{ statistics->GetGatherTime(), statistics->GetResolveTime() };
  pass->MeasureTimesOff();
  if (times.Gather < 0 || times.Resolve < 0)
  {
    return {};
  }
  return times;
}

//------------------------------------------------------------------------------
std::optional<StorageCounts> Stage::CountStorage(int technique)
{
  auto* pass = vtkFragmentListPass::SafeDownCast(this->Players[technique].Pass);
  if (!pass)
  {
    return {};
  }
  auto* choosing = vtkVisibilityFunctionPass::SafeDownCast(pass);
  if (choosing && choosing->GetMemory() == vtkVisibilityFunctionPass::Fixed)
  {
    return {};
  }
  // In the technique's place, with its storage.
  vtkNew<vtkStorageCountPass> counting;
  counting->SetStorage(pass->GetStorage());
  vtkRenderer* renderer = this->Players[technique].Renderer;
  vtkTranslucencyFactory::Enable(renderer, counting.Get());
  this->Draw(technique);
  vtkTranslucencyFactory::Enable(renderer, static_cast<vtkRenderPass*>(pass));
  if (counting->GetAccesses() < 0)
  {
    return {};
  }
  return StorageCounts{ static_cast<int>(counting->GetSectionFragments()),
    counting->GetPackedBytes() / (1024.0 * 1024.0), counting->GetStores(), counting->GetReads(),
    counting->GetTableAccesses(), counting->GetSecondDepthAccesses(), counting->GetFrameBufferAccesses(),
    counting->GetAccesses() };
}

//------------------------------------------------------------------------------
std::unique_ptr<Picture> Stage::Read()
{
  const int* size = this->Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int back = 0;
  if (this->Transparent)
  {
    this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, back, pixels);
  }
  else
  {
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, back, pixels);
  }
  Messages::Get()->ThrowError("the picture can't be read back");
  return NewPicture(size[0], size[1], this->Transparent ? 4 : 3, pixels->GetPointer(0));
}

//------------------------------------------------------------------------------
std::string Stage::GetDriver()
{
  return vtkTranslucencyCapabilities::Probe(this->GetOpenGLWindow()).Renderer;
}

//------------------------------------------------------------------------------
std::string Stage::GetMissing(const std::string& technique)
{
  return vtkTranslucencyFactory::GetMissing(technique, this->GetOpenGLWindow());
}
