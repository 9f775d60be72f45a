// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyPass.h"

#include "vtkTranslucencyFallback.h"
#include "vtkTranslucencyFirstAttachment.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyOption.h"
#include "vtkTranslucencyPeelingGuard.h"
#include "vtkTranslucencyRenderStepsPass.h"
#include "vtkTranslucencyResources.h"
#include "vtkTranslucencyTransmission.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkDepthPeelingPass.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
vtkInformationKeyRestrictedMacro(vtkTranslucencyPass, TRANSMISSION_COLOR, DoubleVector, 3);
vtkCxxSetObjectMacro(vtkTranslucencyPass, TranslucentPass, vtkRenderPass);
vtkCxxSetObjectMacro(vtkTranslucencyPass, VolumetricPass, vtkRenderPass);

namespace
{
bool HasTranslucentGeometry(const vtkRenderState* state)
{
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    if (vtkTranslucencyProp(state, i)->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
// The step that a pass is when it draws alone. It does not own the pass, which owns the steps.
class vtkTranslucencyStep : public vtkRenderPass
{
public:
  static vtkTranslucencyStep* New();
  vtkTypeMacro(vtkTranslucencyStep, vtkRenderPass);

  void Render(const vtkRenderState* state) override { this->NumberOfRenderedProps = this->Draw(state); }

  std::function<int(const vtkRenderState*)> Draw; // gives the number of props
};
vtkStandardNewMacro(vtkTranslucencyStep);

//------------------------------------------------------------------------------
// What only the pass itself needs.
struct vtkTranslucencyPass::Internals
{
  vtkTranslucencyResources Resources;

  // Alone, the pass draws by these steps, of which it is one.
  vtkSmartPointer<vtkTranslucencyRenderStepsPass> Steps;
  vtkNew<vtkVolumetricPass> VolumesAlone;

  vtkSmartPointer<vtkTranslucencyPass> Other;   // the fallback
  bool StandsIn = false;                        // whether this pass is one,
  bool BackgroundChanged = false;               // and the other one has changed what is behind it
  vtkSmartPointer<vtkDepthPeelingPass> Peeling; // where that fails
  vtkTranslucencyPeelingGuard Guard;

  // What was last warned of: the reason for a fallback, and volumes that are drawn over the surfaces.
  std::string Fallback;
  std::string UndividedVolumes;
};

//------------------------------------------------------------------------------
vtkTranslucencyPass::vtkTranslucencyPass()
  : Internal(new Internals)
{
  this->TranslucentPass = vtkTranslucentPass::New();
}

//------------------------------------------------------------------------------
vtkTranslucencyPass::~vtkTranslucencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
  this->SetTranslucentPass(nullptr);
  this->SetVolumetricPass(nullptr);
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeasureTimes: " << this->MeasureTimes << "\n";
  os << indent << "CriticalSection: " << this->CriticalSection << "\n";
  os << indent << "TranslucentPass:\n";
  if (this->TranslucentPass)
  {
    this->TranslucentPass->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "VolumetricPass:" << (this->VolumetricPass ? "\n" : " (none)\n");
  if (this->VolumetricPass)
  {
    this->VolumetricPass->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Statistics:\n";
  this->Internal->Resources.Statistics->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkTranslucencyResources& kept = this->Internal->Resources;
  // OpenGL objects go with their context: where it is gone, or another has taken its place, nothing is left to delete.
  vtkOpenGLRenderWindow* owner = kept.Window;
  const bool alive = owner && kept.Context && owner->GetGenericContext() == kept.Context;
  // VTK gives a context back with X, not with EGL and OSMesa. Without references, a window is about to go.
  auto* asking = vtkOpenGLRenderWindow::SafeDownCast(window);
  const bool givesBack = asking && asking != owner && asking->GetReferenceCount() > 0 && asking->IsCurrent();
  if (alive)
  {
    owner->PushContext();
  }
  this->ReleaseTechniqueResources(alive);
  // VTK's passes want their window, also one that is about to go and has lost its weak pointers: not all that they have
  // follows it.
  for (vtkRenderPass* pass : std::initializer_list<vtkRenderPass*>{ this->TranslucentPass, this->VolumetricPass,
         this->Internal->Other, this->Internal->Peeling, this->Internal->Steps })
  {
    if (pass && window)
    {
      pass->ReleaseGraphicsResources(window);
    }
  }
  kept.Release(alive);
  this->Internal->Other = nullptr;
  this->Internal->Peeling = nullptr;
  if (alive)
  {
    owner->PopContext();
  }
  if (givesBack)
  {
    asking->MakeCurrent();
  }
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkTranslucencyPass::GetOptions()
{
  return {};
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::SetOption(const std::string& keyword, const std::string& value)
{
  std::string known;
  for (const vtkTranslucencyOption& option : this->GetOptions())
  {
    if (option.Keyword == keyword)
    {
      double number = 0;
      std::string error;
      if (!option.Parse(value, number, error))
      {
        vtkErrorMacro(<< error);
        return false;
      }
      option.Set(number);
      return option.Get() == number; // if not, the property has said why
    }
    known += (known.empty() ? "" : ", ") + option.Keyword;
  }
  vtkErrorMacro(<< "there is no option '" << keyword << "', expected one of: " << known);
  return false;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::GetOption(const std::string& keyword)
{
  for (const vtkTranslucencyOption& option : this->GetOptions())
  {
    if (option.Keyword == keyword)
    {
      return option.Format(option.Get());
    }
  }
  vtkErrorMacro(<< "there is no option '" << keyword << "'");
  return "";
}

//------------------------------------------------------------------------------
int vtkTranslucencyPass::GetNumberOfOptions()
{
  return static_cast<int>(this->GetOptions().size());
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::GetOptionKeyword(int index)
{
  const auto options = this->GetOptions();
  return index >= 0 && index < static_cast<int>(options.size()) ? options[index].Keyword : "";
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::GetOptionHelp(int index)
{
  const auto options = this->GetOptions();
  if (index < 0 || index >= static_cast<int>(options.size()))
  {
    return "";
  }
  const vtkTranslucencyOption& option = options[index];
  return option.Help + " (" + option.Range() + ", default " + option.Format(option.Default) + ")";
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::GetMissing(vtkOpenGLRenderWindow* window)
{
  return window ? this->FindMissing(this->GetCapabilities(window)) : "a window";
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::GetMissing(int major, int minor)
{
  return this->FindMissing(vtkTranslucencyCapabilities::OfVersion(major, minor));
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::UsesStorage(const vtkTranslucencyCapabilities&) const
{
  return false;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::FindMissing(const vtkTranslucencyCapabilities& capabilities) const
{
  return this->UsesStorage(capabilities) ? capabilities.MissingForStorage : capabilities.MissingForTargets;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::SetCriticalSection(int section)
{
  vtkTranslucencyOption::SetProperty(
    this, { this->GetCriticalSectionOption() }, "CriticalSection", this->CriticalSection, section);
}

//------------------------------------------------------------------------------
vtkTranslucencyOption vtkTranslucencyPass::GetCriticalSectionOption()
{
  return { "CriticalSection", "critical_section", vtkTranslucencyOption::Kind::Choice, Automatic, 0, 3,
    { "auto", "interlock", "spinlock", "none" },
    "what keeps fragments of one pixel apart; auto is none on software rasterizers, which shade them one after the "
    "other, interlock "
    "where the driver has it, else spinlock",
    [this] { return this->GetCriticalSection(); },
    [this](double value) { this->SetCriticalSection(static_cast<int>(value)); } };
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::FindMissingForCriticalSection(const vtkTranslucencyCapabilities& capabilities) const
{
  if (this->CriticalSection == Interlock)
  {
    return capabilities.Interlock.empty() ? "GL_ARB_fragment_shader_interlock" : "";
  }
  const bool locks = this->CriticalSection == Spinlock ||
    (this->CriticalSection == Automatic && !capabilities.KeepsDrawOrder && capabilities.Interlock.empty());
  return locks ? capabilities.MissingForRetries : "";
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::SetTransmissionColor(vtkProp* prop, double red, double green, double blue)
{
  vtkTranslucencyTransmission::SetColor(prop, { { red, green, blue } });
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::GetTransmissionColor(vtkProp* prop, double color[3])
{
  return vtkTranslucencyTransmission::GetColor(prop, color);
}

//------------------------------------------------------------------------------
const vtkTranslucencyCapabilities& vtkTranslucencyPass::GetCapabilities(vtkOpenGLRenderWindow* window)
{
  vtkTranslucencyResources& kept = this->Internal->Resources;
  if (kept.Window != window || kept.Context != window->GetGenericContext())
  {
    this->ReleaseGraphicsResources(nullptr);
    // Which leaves the context of the other window current where VTK can't give it back: with EGL and OSMesa.
    window->MakeCurrent();
    kept.Window = window;
    kept.Context = window->GetGenericContext();
    kept.Capabilities = vtkTranslucencyCapabilities::Probe(window);
  }
  return kept.Capabilities;
}

//------------------------------------------------------------------------------
vtkTranslucencyStatistics* vtkTranslucencyPass::GetStatistics()
{
  return this->Internal->Resources.Statistics;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::RenderAlone(const vtkRenderState* state)
{
  vtkSmartPointer<vtkTranslucencyRenderStepsPass>& steps = this->Internal->Steps;
  if (!steps)
  {
    vtkNew<vtkTranslucencyStep> step;
    step->Draw = [this](const vtkRenderState* drawn)
    {
      this->RenderTranslucent(drawn, this->VolumetricPass ? this->VolumetricPass : this->Internal->VolumesAlone);
      return this->GetNumberOfRenderedProps();
    };
    steps = vtkSmartPointer<vtkTranslucencyRenderStepsPass>::New();
    steps->SetTranslucentPass(step);
    steps->SetVolumetricPass(nullptr);
  }
  steps->RenderAlone(state);
  this->NumberOfRenderedProps = steps->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  if (renderer->GetPass() == this)
  {
    this->RenderAlone(state);
  }
  else
  {
    this->RenderTranslucent(state, this->VolumetricPass);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass)
{
  vtkTranslucencyResources& kept = this->Internal->Resources;
  vtkRenderer* renderer = state->GetRenderer();
  this->NumberOfRenderedProps = 0;
  kept.Statistics->Reset();
  kept.Background.BeginFrame(this->Internal->BackgroundChanged);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->TranslucentPass)
  {
    vtkErrorMacro(<< (window ? "TranslucentPass is null" : "an OpenGL render window is needed"));
    return;
  }
  const vtkTranslucencyFirstAttachment first(state);
  const bool surfaces = HasTranslucentGeometry(state);
  if (surfaces && !renderer->GetSelector())
  {
    const vtkTranslucencyCapabilities& capabilities = this->GetCapabilities(window);
    this->HasStorage = capabilities.MissingForStorage.empty();
    const std::string missing = this->FindMissing(capabilities);
    if (!missing.empty())
    {
      this->RenderFallback(state, volumetricPass, "the driver (" + capabilities.Renderer + ") lacks " + missing, true);
      return;
    }
    kept.Mappers->GetVolumes().Find(state, volumetricPass, this->KeepsFragments());
    this->RenderGathered(state, window);
    return;
  }
  // Nothing to put into order: there are only volumes, or it is ids that are drawn, which are not blended.
  for (vtkRenderPass* pass : { surfaces ? this->TranslucentPass : nullptr, volumetricPass })
  {
    if (pass)
    {
      pass->Render(state);
      this->NumberOfRenderedProps += pass->GetNumberOfRenderedProps();
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::RenderTiles(const vtkRenderState* state, vtkOpenGLRenderWindow* window, bool& whole)
{
  const vtkTranslucencyGLState found(window, this->HasStorage);
  vtkTranslucencyFrame frame(
    this, this->Internal->Resources, state, window, found, this->UsesStorage(this->Internal->Resources.Capabilities));
  std::string error;
  whole = true; // nothing has been composited yet
  int tiles = 0;
  while ((whole ? error.empty() : true) && frame.NextTile())
  {
    ++tiles;
    vtkTranslucencyResources& kept = this->Internal->Resources;
    if (kept.Background.Change(frame, kept.Mappers->GetOpaqueDepth()) && this->RenderStages(frame))
    {
      whole = false;
      continue;
    }
    error = frame.GetError();
    if (!whole)
    {
      frame.Blend();
    }
  }
  this->Internal->Resources.Statistics->SetTiles(tiles);
  return error;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::FindUnreached(const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  vtkTranslucencyResources& kept = this->Internal->Resources;
  if (!kept.Unreached.TakeMissed())
  {
    return false;
  }
  const vtkTranslucencyGLState found(window, this->HasStorage);
  const std::string props = kept.Unreached.Find(
    state, window, [&](const vtkRenderState* one) { kept.Mappers->Draw(one, this->TranslucentPass); });
  kept.Unreached.Warn(this, props);
  return !props.empty();
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::RenderGathered(const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  vtkTranslucencyResources& kept = this->Internal->Resources;
  kept.Unreached.LookAgain(
    state, window, [&](const vtkRenderState* one) { kept.Mappers->Draw(one, this->TranslucentPass); });
  bool whole = true;
  std::string error = this->RenderTiles(state, window, whole);
  while (whole && this->FindUnreached(state, window))
  {
    error = this->RenderTiles(state, window, whole);
  }
  vtkTranslucencyVolumes& volumes = kept.Mappers->GetVolumes();
  kept.Statistics->SetShaderBuilds(kept.Mappers->TakeShaderBuilds());
  kept.Statistics->SetFragments(kept.Tiles.GetFragments());
  kept.Statistics->SetBytes(kept.GetBytes() + this->GetTechniqueBytes());
  kept.Statistics->SetGatherTime(kept.GatherTime);
  kept.Statistics->SetResolveTime(kept.ResolveTime);
  kept.Statistics->SetDeepestPixel(kept.Resolved.GetDeepestPixel());
  this->NumberOfRenderedProps = kept.RenderedProps + static_cast<int>(volumes.GetProps().size());
  if (kept.Resolved.IsUnfinished())
  {
    vtkErrorMacro(<< "a pixel has more fragments than the driver's loops can take; it is drawn incompletely");
  }
  if (!error.empty() && whole)
  {
    this->RenderFallback(state, volumes.GetPass(), error, false);
    return;
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error << "; part of the picture is drawn by blending");
    kept.Statistics->SetFallback("blending");
  }
  const std::string undivided = volumes.DrawUndivided(state);
  if (!undivided.empty() && undivided != this->Internal->UndividedVolumes)
  {
    const std::string expected = this->KeepsFragments()
      ? "expected those of vtkGPUVolumeRayCastMapper with an ImageSampleDistance of 1, not within assemblies"
      : "only techniques that keep all fragments divide them, as exact and adaptive do";
    vtkWarningMacro(<< "volumes of " << undivided << " are drawn over the translucent surfaces: " << expected);
  }
  this->Internal->UndividedVolumes = undivided;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::SayFallback(const std::string& reason, bool lacking, const std::string& instead)
{
  if (this->Internal->Fallback != reason && lacking)
  {
    vtkWarningMacro(<< reason << "; drawing by " << instead << " instead");
  }
  else if (this->Internal->Fallback != reason)
  {
    vtkErrorMacro(<< reason << "; drawing by " << instead << " instead");
  }
  this->Internal->Fallback = reason;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::RenderFallback(
  const vtkRenderState* state, vtkRenderPass* volumetricPass, const std::string& reason, bool lacking)
{
  vtkTranslucencyResources& kept = this->Internal->Resources;
  vtkSmartPointer<vtkTranslucencyPass>& other = this->Internal->Other;
  if (this->Internal->StandsIn || !kept.Capabilities.MissingForTargets.empty())
  {
    this->RenderByVTK(state, volumetricPass, reason, lacking);
    return;
  }
  this->SayFallback(reason, lacking, "depth peeling");
  if (!other)
  {
    other.TakeReference(vtkTranslucencyNewFallback(this->HasStorage));
    other->Internal->StandsIn = true;
  }
  other->Internal->BackgroundChanged = kept.Background.IsChanged();
  other->SetTranslucentPass(this->TranslucentPass);
  other->SetMeasureTimes(this->MeasureTimes);
  other->RenderTranslucent(state, volumetricPass);
  kept.Statistics->Copy(other->GetStatistics());
  if (kept.Statistics->GetFallback().empty())
  {
    kept.Statistics->SetFallback("peeling");
  }
  this->NumberOfRenderedProps = other->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
// By what VTK has, where the fallback can't draw, either.
void vtkTranslucencyPass::RenderByVTK(
  const vtkRenderState* state, vtkRenderPass* volumetricPass, const std::string& reason, bool lacking)
{
  vtkTranslucencyResources& kept = this->Internal->Resources;
  vtkSmartPointer<vtkDepthPeelingPass>& peeling = this->Internal->Peeling;
  const vtkTranslucencyGLState found(kept.Window, this->HasStorage);
  // Depth peeling copies the depth buffer, which fails where it is multi-sampled: nothing would be drawn.
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  const bool peel = samples == 0;
  this->SayFallback(reason, lacking,
    std::string(peel ? "VTK's depth peeling" : "blending, in drawing order,") +
      vtkTranslucencyTransmission::DescribeLost(state));
  kept.Statistics->SetFallback(peel ? "peeling" : "blending");
  vtkRenderPass* drawing = this->TranslucentPass;
  if (peel)
  {
    if (!peeling)
    {
      // Not dual depth peeling, which ends too early in front of opaque surfaces (vtkStockPeelingPass).
      peeling = vtkSmartPointer<vtkDepthPeelingPass>::New();
      peeling->SetMaximumNumberOfPeels(VTK_INT_MAX); // until every pixel is done
      peeling->SetOcclusionRatio(0);
    }
    peeling->SetTranslucentPass(this->TranslucentPass);
    drawing = peeling;
    const std::string warning =
      this->Internal->Guard.Render(peeling, state, kept.Window, [&] { drawing->Render(state); });
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
  else
  {
    drawing->Render(state);
  }
  this->NumberOfRenderedProps = drawing->GetNumberOfRenderedProps();
  if (volumetricPass)
  {
    volumetricPass->Render(state);
    this->NumberOfRenderedProps += volumetricPass->GetNumberOfRenderedProps();
  }
}
VTK_ABI_NAMESPACE_END
