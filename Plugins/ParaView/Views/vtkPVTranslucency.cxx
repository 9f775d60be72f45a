// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTranslucency.h"

#include "vtkPVRanksPass.h"
#include "vtkPVSamplesPass.h"
#include "vtkTranslucencyFactory.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyStatistics.h"

#include "vtkCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPVRenderView.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkProcessModule.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSynchronizedRenderers.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPVTranslucency);

namespace
{
const std::string None = "None";

// The member that holds it has no other door: derived classes may name it.
class ViewWithSynchronizer : public vtkPVRenderView
{
public:
  static vtkPVSynchronizedRenderer* Get(vtkPVRenderView* view)
  {
    return view->*(&ViewWithSynchronizer::SynchronizedRenderers);
  }
};

int GetIndex(const std::string& technique)
{
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    if (vtkTranslucencyFactory::GetTechniqueName(i) == technique)
    {
      return i;
    }
  }
  return -1;
}

std::string GetNameOrNone(int index)
{
  return index < 0 ? None : vtkTranslucencyFactory::GetTechniqueName(index);
}

std::string GetNames()
{
  std::string names = None;
  for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
  {
    names += ", " + vtkTranslucencyFactory::GetTechniqueName(i);
  }
  return names;
}
}

//------------------------------------------------------------------------------
struct vtkPVTranslucency::Internals
{
  using Values = std::map<std::string, std::string>; // by keyword

  std::string Technique = None;
  std::map<std::string, Values> Options; // by technique
  bool MeasureTimes = false;
  int Samples = 1;

  vtkSmartPointer<vtkRenderPass> Pass;     // null where ParaView draws by itself
  vtkSmartPointer<vtkPVSamplesPass> Steps; // what the view has of it
  vtkNew<vtkPVRanksPass> Ranks;            // kept, since all ranks have to make its context at the same time

  vtkWeakPointer<vtkPVRenderView> View;
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long StartObserver = 0;
  unsigned long EndObserver = 0;

  vtkNew<vtkTranslucencyStatistics> Statistics;
  std::string Fallback;
  bool Agreed = true;
  bool HasUsedFXAA = false; // before the frame that is being drawn

  vtkPVSynchronizedRenderer* GetSynchronizer() { return this->View ? ViewWithSynchronizer::Get(this->View) : nullptr; }

  vtkSynchronizedRenderers* GetParallel()
  {
    vtkPVSynchronizedRenderer* synchronizer = this->GetSynchronizer();
    return synchronizer ? synchronizer->GetParallelSynchronizer() : nullptr;
  }

  // Whether each picture is composed of those of several ranks, which all draw at the same time.
  bool DrawsWithOtherRanks()
  {
    vtkSynchronizedRenderers* parallel = this->GetParallel();
    vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
    return parallel && parallel->IsA("vtkIceTSynchronizedRenderers") && ranks && ranks->GetNumberOfProcesses() > 1;
  }

  vtkOpenGLRenderWindow* GetWindowThatHasDrawn()
  {
    auto* window = this->View ? vtkOpenGLRenderWindow::SafeDownCast(this->View->GetRenderWindow()) : nullptr;
    return window && !window->GetNeverRendered() ? window : nullptr;
  }

  void Release(vtkRenderPass* pass)
  {
    vtkOpenGLRenderWindow* window = this->GetWindowThatHasDrawn();
    if (pass && window)
    {
      window->PushContext();
      pass->ReleaseGraphicsResources(window);
      window->PopContext();
    }
  }

  // What ranks have to have in common.
  std::string Describe()
  {
    std::string text = this->Technique + ' ' + std::to_string(this->Samples);
    for (const auto& option : this->Options[this->Technique])
    {
      text += ' ' + option.first + '=' + option.second;
    }
    return text;
  }
};

//------------------------------------------------------------------------------
vtkPVTranslucency::vtkPVTranslucency()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkPVTranslucency::~vtkPVTranslucency() = default;

//------------------------------------------------------------------------------
void vtkPVTranslucency::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Internal->Technique << "\n";
  os << indent << "Samples: " << this->Internal->Samples << "\n";
  os << indent << "MeasureTimes: " << this->Internal->MeasureTimes << "\n";
}

//------------------------------------------------------------------------------
bool vtkPVTranslucency::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView || this->Internal->View)
  {
    vtkErrorMacro("the view is a " << (view ? view->GetClassName() : "null") << ", expected one vtkPVRenderView");
    return false;
  }
  Internals& kept = *this->Internal;
  kept.View = renderView;
  kept.Renderer = renderView->GetRenderer();
  constexpr float first = 1; // before what ParaView does there
  kept.StartObserver = kept.Renderer->AddObserver(vtkCommand::StartEvent, this, &vtkPVTranslucency::BeginFrame, first);
  kept.EndObserver = kept.Renderer->AddObserver(vtkCommand::EndEvent, this, &vtkPVTranslucency::EndFrame);
  this->PutIn();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPVTranslucency::RemoveFromView(vtkView* view)
{
  Internals& kept = *this->Internal;
  if (view != kept.View) // as for a view that is being deleted
  {
    return false;
  }
  kept.Renderer->RemoveObserver(kept.StartObserver);
  kept.Renderer->RemoveObserver(kept.EndObserver);
  kept.Technique = None;
  this->MakePasses();
  kept.View = nullptr;
  return true;
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetTechnique(const char* name)
{
  const std::string technique = name ? name : "";
  if (technique != None && GetIndex(technique) < 0)
  {
    vtkErrorMacro("TranslucencyTechnique is '" << technique << "', expected one of: " << GetNames()
                                               << "; the view draws by '" << this->Internal->Technique
                                               << "' as before");
    return;
  }
  if (this->Internal->Technique != technique)
  {
    this->Internal->Technique = technique;
    this->MakePasses();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetIntegerOption(const char* option, int value)
{
  this->SetOption(option, std::to_string(value));
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetRealOption(const char* option, double value)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  this->SetOption(option, text.str());
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetChoiceOption(const char* option, const char* value)
{
  this->SetOption(option, value ? value : "");
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetOption(const char* option, const std::string& value)
{
  std::istringstream words(option ? option : "");
  std::string technique;
  std::string keyword;
  words >> technique >> keyword;
  vtkSmartPointer<vtkRenderPass> trial;
  if (GetIndex(technique) >= 0)
  {
    trial = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(technique));
  }
  auto* own = vtkTranslucencyPass::SafeDownCast(trial);
  if (!own)
  {
    vtkErrorMacro("there is no technique '"
      << technique << "' with options (for '" << keyword << "' = '" << value
      << "'): the plugins of the client and the server are of different releases");
    return;
  }
  const std::string byDefault = own->GetOption(keyword);
  if (!own->SetOption(keyword, value)) // an error of its, which tells what was expected
  {
    return;
  }
  Internals& kept = *this->Internal;
  const std::string read = own->GetOption(keyword);
  Internals::Values& values = kept.Options[technique];
  const auto found = values.find(keyword);
  if (read == (found == values.end() ? byDefault : found->second))
  {
    return;
  }
  auto* drawing = kept.Technique == technique ? vtkTranslucencyPass::SafeDownCast(kept.Pass) : nullptr;
  if (read != byDefault)
  {
    values[keyword] = read;
    if (drawing)
    {
      drawing->SetOption(keyword, read);
    }
  }
  else
  {
    values.erase(keyword); // for some passes an option that was set to its default is not as one that was not set
    if (drawing)
    {
      this->MakePasses();
    }
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetSamples(int samples)
{
  Internals& kept = *this->Internal;
  if (samples < 1 || samples > 8)
  {
    vtkErrorMacro("TranslucencySamples is " << samples << ", expected 1 to 8; the view draws with " << kept.Samples
                                            << " as before");
    return;
  }
  kept.Samples = samples;
  if (kept.Steps)
  {
    kept.Steps->SetSamples(samples);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetMeasureTimes(bool measure)
{
  this->Internal->MeasureTimes = measure;
  if (auto* own = vtkTranslucencyPass::SafeDownCast(this->Internal->Pass))
  {
    own->SetMeasureTimes(measure);
  }
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::SetRelease(const char* release)
{
  if (std::string(release ? release : "") != TRANSLUCENCY_RELEASE)
  {
    vtkErrorMacro("the server's plugin Translucency is of release "
      << (release ? release : "(none)") << ", and this one is " TRANSLUCENCY_RELEASE
      << ": load the same release in the client and in the server");
  }
}

//------------------------------------------------------------------------------
// What draws, anew.
void vtkPVTranslucency::MakePasses()
{
  Internals& kept = *this->Internal;
  const vtkSmartPointer<vtkRenderPass> before = kept.Steps;
  kept.Pass = nullptr;
  kept.Steps = nullptr;
  if (kept.Technique != None)
  {
    kept.Pass = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(kept.Technique));
    if (auto* own = vtkTranslucencyPass::SafeDownCast(kept.Pass))
    {
      own->SetMeasureTimes(kept.MeasureTimes);
      for (const auto& option : kept.Options[kept.Technique])
      {
        own->SetOption(option.first, option.second);
      }
    }
    kept.Steps = vtkSmartPointer<vtkPVSamplesPass>::New();
    kept.Steps->SetSamples(kept.Samples);
    kept.Steps->SetDelegate(vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateSteps(kept.Pass)));
  }
  vtkPVSynchronizedRenderer* synchronizer = kept.GetSynchronizer();
  if (synchronizer && synchronizer->GetRenderPass() == before)
  {
    synchronizer->SetRenderPass(kept.Steps);
  }
  kept.Release(before);
}

//------------------------------------------------------------------------------
// Ray tracing takes the place of the technique, and gives it back: what has been there then may not be what is wanted
// now.
void vtkPVTranslucency::PutIn()
{
  Internals& kept = *this->Internal;
  vtkPVSynchronizedRenderer* synchronizer = kept.GetSynchronizer();
  if (synchronizer && !synchronizer->GetRenderPass())
  {
    synchronizer->SetRenderPass(kept.Steps);
  }
}

//------------------------------------------------------------------------------
// Several samples take the place of FXAA. Where ranks draw, ParaView asks for it here, and smooths what it has put
// together.
void vtkPVTranslucency::BeginFrame()
{
  Internals& kept = *this->Internal;
  this->PutIn();
  kept.HasUsedFXAA = kept.Renderer->GetUseFXAA();
  kept.Renderer->SetUseFXAA(kept.HasUsedFXAA && !(kept.Steps && kept.Samples > 1));
  if (kept.DrawsWithOtherRanks())
  {
    const int can = vtkPVRanksPass::CanRender(kept.GetParallel(), kept.Renderer, kept.Steps) ? 1 : 0;
    int allCan = 0;
    vtkMultiProcessController::GetGlobalController()->AllReduce(&can, &allCan, 1, vtkCommunicator::MIN_OP);
    if (allCan)
    {
      kept.Ranks->PutIn(kept.GetParallel());
    }
  }
}

//------------------------------------------------------------------------------
void vtkPVTranslucency::EndFrame()
{
  this->Internal->Ranks->TakeOut();
  this->Internal->Renderer->SetUseFXAA(this->Internal->HasUsedFXAA);
  this->CompareRanks();
}

//------------------------------------------------------------------------------
bool vtkPVTranslucency::IsDrawnByServer()
{
  vtkPVRenderView* view = this->Internal->View;
  return view && vtkProcessModule::GetProcessType() == vtkProcessModule::PROCESS_CLIENT &&
    view->GetUseDistributedRenderingForRender();
}

//------------------------------------------------------------------------------
vtkTranslucencyStatistics* vtkPVTranslucency::GetStatistics()
{
  Internals& kept = *this->Internal;
  auto* own = vtkTranslucencyPass::SafeDownCast(kept.Pass);
  vtkOpenGLRenderWindow* window = kept.GetWindowThatHasDrawn();
  if (!own || !window)
  {
    kept.Statistics->Reset();
  }
  else if (!kept.DrawsWithOtherRanks())
  {
    window->PushContext();
    kept.Statistics->Copy(own->GetStatistics());
    window->PopContext();
  }
  return kept.Statistics;
}

//------------------------------------------------------------------------------
// After a frame that all ranks have drawn: what they have found, together, and whether they draw by the same technique.
void vtkPVTranslucency::CompareRanks()
{
  Internals& kept = *this->Internal;
  if (!kept.DrawsWithOtherRanks())
  {
    return;
  }
  kept.Statistics->Reset();
  if (auto* own = vtkTranslucencyPass::SafeDownCast(kept.Pass))
  {
    kept.Statistics->Copy(own->GetStatistics());
  }
  vtkTranslucencyStatistics* found = kept.Statistics;
  const std::vector<double> sums{ static_cast<double>(found->GetFragments()), static_cast<double>(found->GetBytes()) };
  // Doubles hold 53 bits.
  const double description = static_cast<double>(std::hash<std::string>()(kept.Describe()) >> 11);
  const double fallback = found->GetFallback().empty() ? 0 : found->GetFallback() == "peeling" ? 1 : 2;
  const std::vector<double> largest{ description, -description, fallback, static_cast<double>(found->GetDeepestPixel()),
    static_cast<double>(found->GetTiles()), static_cast<double>(found->GetGeometryPasses()),
    static_cast<double>(found->GetScreenPasses()), static_cast<double>(found->GetShaderBuilds()),
    found->GetGatherTime(), found->GetResolveTime() };

  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  std::vector<double> sum(sums.size());
  std::vector<double> most(largest.size());
  ranks->AllReduce(sums.data(), sum.data(), static_cast<vtkIdType>(sums.size()), vtkCommunicator::SUM_OP);
  ranks->AllReduce(largest.data(), most.data(), static_cast<vtkIdType>(largest.size()), vtkCommunicator::MAX_OP);
  found->SetFragments(static_cast<vtkTypeInt64>(sum[0]));
  found->SetBytes(static_cast<vtkTypeInt64>(sum[1]));
  found->SetFallback(most[2] == 0 ? "" : most[2] == 1 ? "peeling" : "blending");
  found->SetDeepestPixel(static_cast<vtkTypeInt64>(most[3]));
  found->SetTiles(static_cast<int>(most[4]));
  found->SetGeometryPasses(static_cast<int>(most[5]));
  found->SetScreenPasses(static_cast<int>(most[6]));
  found->SetShaderBuilds(static_cast<int>(most[7]));
  found->SetGatherTime(most[8]);
  found->SetResolveTime(most[9]);

  const bool agreed = most[0] == -most[1];
  if (kept.Agreed && !agreed)
  {
    const int technique = GetIndex(kept.Technique);
    std::vector<int> techniques(ranks->GetNumberOfProcesses());
    ranks->AllGather(&technique, techniques.data(), 1);
    if (ranks->GetLocalProcessId() == 0)
    {
      std::string names;
      for (int other : techniques)
      {
        names += (names.empty() ? "" : ", ") + GetNameOrNone(other);
      }
      vtkErrorMacro("the ranks draw by different techniques, or options of them (rank by rank: "
        << names << "): set TranslucencyTechnique and the options as properties of the view, which reach all ranks");
    }
  }
  kept.Agreed = agreed;
}

//------------------------------------------------------------------------------
double vtkPVTranslucency::GetFragments()
{
  return static_cast<double>(this->GetStatistics()->GetFragments());
}

//------------------------------------------------------------------------------
double vtkPVTranslucency::GetDeepestPixel()
{
  return static_cast<double>(this->GetStatistics()->GetDeepestPixel());
}

//------------------------------------------------------------------------------
double vtkPVTranslucency::GetBytes()
{
  return static_cast<double>(this->GetStatistics()->GetBytes());
}

//------------------------------------------------------------------------------
int vtkPVTranslucency::GetTiles()
{
  return this->GetStatistics()->GetTiles();
}

//------------------------------------------------------------------------------
int vtkPVTranslucency::GetGeometryPasses()
{
  return this->GetStatistics()->GetGeometryPasses();
}

//------------------------------------------------------------------------------
int vtkPVTranslucency::GetScreenPasses()
{
  return this->GetStatistics()->GetScreenPasses();
}

//------------------------------------------------------------------------------
int vtkPVTranslucency::GetShaderBuilds()
{
  return this->GetStatistics()->GetShaderBuilds();
}

//------------------------------------------------------------------------------
double vtkPVTranslucency::GetGatherTime()
{
  return this->GetStatistics()->GetGatherTime();
}

//------------------------------------------------------------------------------
double vtkPVTranslucency::GetResolveTime()
{
  return this->GetStatistics()->GetResolveTime();
}

//------------------------------------------------------------------------------
const char* vtkPVTranslucency::GetFallback()
{
  this->Internal->Fallback = this->GetStatistics()->GetFallback();
  return this->Internal->Fallback.c_str();
}
