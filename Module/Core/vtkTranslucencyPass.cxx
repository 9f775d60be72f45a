#include "vtkTranslucencyPass.h"

#include "vtkTranslucencyFirstAttachment.h"
#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyInternals.h"
#include "vtkTranslucencyOption.h"
#include "vtkTranslucencyRenderStepsPass.h"
#include "vtkTranslucencyShader.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkDepthPeelingPass.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointGaussianMapper.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <numeric>
#include <regex>

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

// Draws these faces only, of them those that the actor's own culling leaves: set when the actor is about to be drawn, after its property.
void CullFaces(vtkOpenGLState* state, vtkTranslucencyFrame::Faces drawn, vtkProp* prop)
{
  if (drawn == vtkTranslucencyFrame::Faces::All)
  {
    return;
  }
  const bool back = drawn == vtkTranslucencyFrame::Faces::Back;
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool hidden =
    actor && (back ? actor->GetProperty()->GetBackfaceCulling() : actor->GetProperty()->GetFrontfaceCulling());
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(hidden ? GL_FRONT_AND_BACK : back ? GL_FRONT : GL_BACK);
}

// True if a fragment shader gives its fragments a depth of its own.
bool SetsDepth(const std::string& fragmentShader)
{
  static const std::regex assignment("gl_FragDepth\\s*=[^=]");
  return std::regex_search(fragmentShader, assignment);
}

bool HasTransmissionColor(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys && keys->Has(vtkTranslucencyPass::TRANSMISSION_COLOR());
}

// What VTK draws by adding it to the picture.
bool IsEmissive(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor ? vtkPointGaussianMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper && mapper->GetEmissive() && !HasTransmissionColor(prop);
}

// The same of a prop or one of its parts.
bool HoldsEmissive(vtkProp* prop)
{
  if (vtkActor::SafeDownCast(prop) || HasTransmissionColor(prop))
  {
    return IsEmissive(prop);
  }
  vtkNew<vtkPropCollection> parts;
  prop->GetActors(parts);
  vtkCollectionSimpleIterator i;
  parts->InitTraversal(i);
  bool any = false;
  while (vtkProp* part = parts->GetNextProp(i))
  {
    any = any || IsEmissive(part);
  }
  return any;
}
}

//------------------------------------------------------------------------------
// The step that a pass is when it draws alone. It does not own the pass, which owns the steps.
class vtkTranslucencyStep : public vtkRenderPass
{
public:
  static vtkTranslucencyStep* New();
  vtkTypeMacro(vtkTranslucencyStep, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    vtkRenderPass* volumes = this->Pass->VolumetricPass;
    this->Pass->RenderTranslucent(state, volumes ? volumes : this->Pass->Internal->VolumesAlone);
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
  }

  vtkTranslucencyPass* Pass = nullptr;
};
vtkStandardNewMacro(vtkTranslucencyStep);
vtkStandardNewMacro(vtkTranslucencyHook);

//------------------------------------------------------------------------------
vtkTranslucencyPass::vtkTranslucencyPass()
  : Internal(new Internals)
{
  this->Internal->Hook->Pass = this;
  this->TranslucentPass = vtkTranslucentPass::New();
}

//------------------------------------------------------------------------------
vtkTranslucencyPass::~vtkTranslucencyPass()
{
  this->Internal->Hook->Pass = nullptr;
  this->ReleaseGraphicsResources(nullptr);
  this->SetTranslucentPass(nullptr);
  this->SetVolumetricPass(nullptr);
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeasureTimes: " << this->MeasureTimes << "\n";
  os << indent << "CountAccesses: " << this->CountAccesses << "\n";
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
  this->Internal->Statistics->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& kept = *this->Internal;
  // OpenGL objects go with their context: where it is gone, or another has taken its place, nothing is left to delete.
  vtkOpenGLRenderWindow* owner = kept.Window;
  const bool alive = owner && kept.Context && owner->GetGenericContext() == kept.Context;
  if (alive)
  {
    owner->PushContext();
  }
  this->ReleaseTechniqueResources(alive);
  // VTK's passes want their window, also one that is about to go and has lost its weak pointers: not all that they have follows it.
  for (vtkRenderPass* pass : { static_cast<vtkRenderPass*>(this->TranslucentPass), this->VolumetricPass,
         static_cast<vtkRenderPass*>(kept.Peeling), static_cast<vtkRenderPass*>(kept.Steps) })
  {
    if (pass && window)
    {
      pass->ReleaseGraphicsResources(window);
    }
  }
  kept.Release(alive);
  if (alive)
  {
    owner->PopContext();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::Internals::Release(bool alive)
{
  this->FrameBlock.Release(alive);
  this->StatisticsBlock.Release(alive);
  this->SampleColors.Release(alive);
  this->PixelFragments.Release(alive);
  this->Unreached.Release();
  this->Layers.Release(alive);
  this->GatherKey.clear();
  this->GatherText.clear();
  this->Programs.clear();
  this->Plan.clear();
  if (this->VertexArray != 0 && alive)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->VertexArray = 0;
  // VTK's own objects follow their window by themselves.
  this->OpaqueDepth = nullptr;
  this->OpaqueFramebuffer = nullptr;
  this->Peeling = nullptr;
  this->Window = nullptr;
  this->Context = nullptr;
}

//------------------------------------------------------------------------------
const vtkTranslucencyPass::Internals::ResolveStatistics&
vtkTranslucencyPass::Internals::GetResolveStatistics()
{
  if (!this->Resolved)
  {
    this->Resolved.emplace();
    this->StatisticsBlock.Download(&*this->Resolved, sizeof(ResolveStatistics));
  }
  return *this->Resolved;
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
  return this->GetCapabilities(window).MissingForStorage;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::SetCriticalSection(int section)
{
  if (section < Automatic || section > Unprotected)
  {
    vtkErrorMacro(<< "CriticalSection is " << section
                  << ", expected Automatic (0), Interlock (1), Spinlock (2) or Unprotected (3)");
    return;
  }
  if (this->CriticalSection != section)
  {
    this->CriticalSection = section;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyOption vtkTranslucencyPass::GetCriticalSectionOption()
{
  return { "CriticalSection", "critical_section", vtkTranslucencyOption::Kind::Choice, Automatic, 0, 3,
    { "auto", "interlock", "spinlock", "none" },
    "what keeps fragments of one pixel apart; auto is none on software rasterizers, which shade them one after the other, interlock "
    "where the driver has it, else spinlock",
    [this] { return this->GetCriticalSection(); },
    [this](double value) { this->SetCriticalSection(static_cast<int>(value)); } };
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPass::GetMissingForCriticalSection(vtkOpenGLRenderWindow* window)
{
  const bool lacking = this->CriticalSection == Interlock && this->GetCapabilities(window).Interlock.empty();
  return lacking ? "GL_ARB_fragment_shader_interlock" : "";
}

//------------------------------------------------------------------------------
const char* vtkTranslucencyPass::GetSelectedCriticalSection(const vtkTranslucencyCapabilities& capabilities) const
{
  switch (this->CriticalSection)
  {
    case Interlock:
      return "Interlock";
    case Spinlock:
      return "Spinlock";
    case Unprotected:
      return "None";
    default:
      return capabilities.KeepsDrawOrder ? "None" : capabilities.Interlock.empty() ? "Spinlock" : "Interlock";
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::SetTransmissionColor(vtkProp* prop, double red, double green, double blue)
{
  if (!prop)
  {
    vtkGenericWarningMacro(<< "SetTransmissionColor: the prop is null");
    return;
  }
  for (double channel : { red, green, blue })
  {
    if (!(channel >= 0 && channel <= 1))
    {
      vtkErrorWithObjectMacro(prop,
        << "the transmission colour is (" << red << ", " << green << ", " << blue << "), expected three numbers from 0 to 1");
      return;
    }
  }
  double before[3];
  if (HasTransmissionColor(prop) && GetTransmissionColor(prop, before) && before[0] == red && before[1] == green && before[2] == blue)
  {
    return;
  }
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Set(TRANSMISSION_COLOR(), red, green, blue);
  prop->Modified();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::GetTransmissionColor(vtkProp* prop, double color[3])
{
  const double* kept = HasTransmissionColor(prop) ? prop->GetPropertyKeys()->Get(TRANSMISSION_COLOR()) : nullptr;
  const double unset = IsEmissive(prop) ? 1 : 0;
  bool valid = true;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = kept ? kept[i] : unset;
    valid = valid && color[i] >= 0 && color[i] <= 1;
    color[i] = color[i] > 0 ? std::min(color[i], 1.0) : 0; // NaN becomes 0
  }
  return valid;
}

//------------------------------------------------------------------------------
vtkTranslucencyPass::Internals::Transmitting vtkTranslucencyPass::Internals::CountTransmitting(const vtkRenderState* state)
{
  Transmitting result;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    double color[3];
    if (!GetTransmissionColor(prop, color))
    {
      result.Invalid = prop->GetClassName();
    }
    const bool emissive = HoldsEmissive(prop);
    const bool transmits = emissive || color[0] > 0 || color[1] > 0 || color[2] > 0;
    if (transmits && prop->HasTranslucentPolygonalGeometry())
    {
      ++result.Props;
      result.Emissive += emissive ? 1 : 0;
    }
  }
  return result;
}

//------------------------------------------------------------------------------
const vtkTranslucencyCapabilities& vtkTranslucencyPass::GetCapabilities(
  vtkOpenGLRenderWindow* window)
{
  Internals& kept = *this->Internal;
  if (kept.Window != window || kept.Context != window->GetGenericContext())
  {
    this->ReleaseGraphicsResources(nullptr);
    kept.Window = window;
    kept.Context = window->GetGenericContext();
    kept.Capabilities = vtkTranslucencyCapabilities::Probe(window);
  }
  return kept.Capabilities;
}

//------------------------------------------------------------------------------
vtkTranslucencyStatistics* vtkTranslucencyPass::GetStatistics()
{
  return this->Internal->Statistics;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::RenderAlone(const vtkRenderState* state)
{
  Internals& kept = *this->Internal;
  if (!kept.Steps)
  {
    vtkNew<vtkTranslucencyStep> step;
    step->Pass = this;
    kept.Steps = vtkSmartPointer<vtkTranslucencyRenderStepsPass>::New();
    kept.Steps->SetTranslucentPass(step);
    kept.Steps->SetVolumetricPass(nullptr);
  }
  kept.Steps->RenderAlone(state);
  this->NumberOfRenderedProps = kept.Steps->GetNumberOfRenderedProps();
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
  Internals& kept = *this->Internal;
  vtkRenderer* renderer = state->GetRenderer();
  this->NumberOfRenderedProps = 0;
  kept.Statistics->Reset();
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
    const std::string driver = this->GetCapabilities(window).Renderer;
    const std::string missing = this->GetMissing(window);
    if (!missing.empty())
    {
      this->RenderFallback(state, volumetricPass, "the driver (" + driver + ") lacks " + missing, true);
      return;
    }
    kept.Volumes.Find(state, volumetricPass, this->DividesVolumes());
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
  const vtkTranslucencyGLState found(window, true);
  vtkTranslucencyFrame frame(this, state, window, found);
  std::string error;
  whole = true; // nothing has been composited yet
  int tiles = 0;
  while ((whole ? error.empty() : true) && frame.NextTile())
  {
    ++tiles;
    if (this->RenderStages(frame))
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
  this->Internal->Statistics->SetTiles(tiles);
  if (error.empty())
  {
    frame.ReportAccesses();
  }
  return error;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::Internals::DrawReached(const vtkRenderState* state)
{
  this->Hook->PreRender(state);
  this->Gathering = true;
  this->Hook->Pass->TranslucentPass->Render(state);
  this->Gathering = false;
  this->Hook->PostRender(state);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::FindUnreached(const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  Internals& kept = *this->Internal;
  if (!kept.Unreached.TakeMissed())
  {
    return false;
  }
  const vtkTranslucencyGLState found(window, true);
  const std::string props =
    kept.Unreached.Find(state, window, [&kept](const vtkRenderState* one) { kept.DrawReached(one); });
  this->WarnOfUnreached(props);
  return !props.empty();
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::WarnOfUnreached(const std::string& props)
{
  if (!props.empty() && this->Internal->UnreachedKinds.insert(props).second)
  {
    vtkWarningMacro(<< props << " draws by shaders that the pass can't reach, those of actors within it or of the user's own; it is drawn by "
                    << "itself, once for each of its layers, which are then among all others");
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::RenderGathered(const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  Internals& kept = *this->Internal;
  kept.Unreached.LookAgain(state, window, [&kept](const vtkRenderState* one) { kept.DrawReached(one); });
  bool whole = true;
  std::string error = this->RenderTiles(state, window, whole);
  while (whole && this->FindUnreached(state, window))
  {
    error = this->RenderTiles(state, window, whole);
  }
  kept.Statistics->SetFragments(kept.PlanFragments);
  kept.Statistics->SetBytes(
    kept.FrameBlock.GetBytes() + kept.StatisticsBlock.GetBytes() + kept.SampleColors.GetBytes() +
    kept.PixelFragments.GetBytes() + kept.Layers.GetBytes() + this->GetTechniqueBytes());
  kept.Statistics->SetGatherTime(kept.GatherTime);
  kept.Statistics->SetResolveTime(kept.ResolveTime);
  kept.Statistics->SetDeepestPixel(kept.GetResolveStatistics().DeepestPixel);
  this->NumberOfRenderedProps =
    kept.RenderedProps + static_cast<int>(kept.Volumes.GetProps().size());
  if (kept.GetResolveStatistics().Unfinished)
  {
    vtkErrorMacro(<< "a pixel has more fragments than the driver's loops can take; it is drawn incompletely");
  }
  if (!error.empty() && whole)
  {
    this->RenderFallback(state, kept.Volumes.GetPass(), error, false);
    return;
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error << "; part of the picture is drawn by blending");
    kept.Statistics->SetFallback("blending");
  }
  const std::string undivided = kept.Volumes.DrawUndivided(state);
  if (!undivided.empty() && undivided != kept.UndividedVolumes)
  {
    const std::string expected = this->DividesVolumes()
      ? "expected those of vtkGPUVolumeRayCastMapper with an ImageSampleDistance of 1, not within assemblies"
      : "only techniques that keep all fragments divide them, as exact and adaptive do";
    vtkWarningMacro(<< "volumes of " << undivided << " are drawn over the translucent surfaces: " << expected);
  }
  kept.UndividedVolumes = undivided;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::RenderFallback(const vtkRenderState* state, vtkRenderPass* volumetricPass,
  const std::string& reason, bool lacking)
{
  Internals& kept = *this->Internal;
  const vtkTranslucencyGLState found(kept.Window, kept.Capabilities.MissingForStorage.empty());
  // Depth peeling copies the depth buffer, which fails where it is multi-sampled: nothing would be drawn.
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  const bool peel = samples == 0;
  const std::string instead = reason + "; drawing by " + (peel ? "depth peeling" : "blending, in drawing order") + " instead" +
    (Internals::CountTransmitting(state).Props > 0 ? ", without transmission colours" : "");
  if (kept.Warned != reason && lacking)
  {
    vtkWarningMacro(<< instead);
  }
  else if (kept.Warned != reason)
  {
    vtkErrorMacro(<< instead);
  }
  kept.Warned = reason;
  kept.Statistics->SetFallback(peel ? "peeling" : "blending");
  vtkRenderPass* drawing = this->TranslucentPass;
  if (peel)
  {
    if (!kept.Peeling)
    {
      // Not dual depth peeling, which ends too early in front of opaque surfaces (vtkStockPeelingPass).
      kept.Peeling = vtkSmartPointer<vtkDepthPeelingPass>::New();
      kept.Peeling->SetMaximumNumberOfPeels(VTK_INT_MAX); // until every pixel is done
      kept.Peeling->SetOcclusionRatio(0);
    }
    kept.Peeling->SetTranslucentPass(this->TranslucentPass);
    drawing = kept.Peeling;
    const std::string warning = kept.Guard.Render(kept.Peeling, state, kept.Window, [&] { drawing->Render(state); });
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

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::PreReplaceShaderValues(std::string&, std::string&,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  Internals& kept = *this->Internal;
  if (!kept.Gathering || !vtkTranslucencyVolumes::IsRayCaster(mapper))
  {
    return true;
  }
  kept.Statistics->SetShaderBuilds(kept.Statistics->GetShaderBuilds() + 1);
  return kept.Volumes.PreReplaceShaderValues(fragmentShader, mapper->GetClassName(), kept.GatherError);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::PostReplaceShaderValues(std::string&, std::string&,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  Internals& kept = *this->Internal;
  if (!kept.Gathering)
  {
    return true;
  }
  if (vtkTranslucencyVolumes::IsRayCaster(mapper))
  {
    return kept.Volumes.PostReplaceShaderValues(fragmentShader, mapper->GetClassName(), kept.GatherError);
  }
  kept.Statistics->SetShaderBuilds(kept.Statistics->GetShaderBuilds() + 1);
  this->InsertGather(fragmentShader, mapper->GetClassName()); // what it can't be put into is met when it is drawn by
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::InsertGather(std::string& fragmentShader, const std::string& who)
{
  const Internals& kept = *this->Internal;
  const bool setsDepth = SetsDepth(fragmentShader);
  std::string system = "//VTK::System::Dec\n" + std::string(vtkTranslucencyShader::GetExtensions());
  std::string declarations = kept.GatherText;
  const bool tests = setsDepth && kept.GatherStores;
  if (tests)
  {
    vtkTranslucencyShader test;
    test.Assemble("Common/OpaqueDepth.glsl", {});
    declarations += test.GetText();
  }
  else if (kept.GatherStores)
  {
    system += "layout(early_fragment_tests) in;\n#ifdef GL_ARB_post_depth_coverage\n"
              "layout(post_depth_coverage) in;\n#endif\n"; // the samples that pass the test
  }
  const std::string depth = setsDepth ? "gl_FragDepth" : "gl_FragCoord.z";
  const std::string call = std::regex_replace(kept.GatherCall, std::regex("GATHERED_DEPTH"), depth);
  const std::string reject = std::string(tests ? "if (behindOpaque(gl_FragDepth)) { discard; }\n" : "") +
    (kept.GatherRejects ? "rejectFragment(" + depth + ");\n" : "");

  std::string text = fragmentShader;
  std::string error;
  using Shader = vtkTranslucencyShader;
  if (!Shader::Substitute(text, "//VTK::System::Dec", system, who, error) ||
    !Shader::Substitute(text, "//VTK::DepthPeeling::Dec", declarations, who, error) ||
    !Shader::Substitute(text, "//VTK::DepthPeeling::Impl", call, who, error) ||
    !(reject.empty() || Shader::Substitute(text, "//VTK::DepthPeeling::PreColor", reject, who, error)))
  {
    return false;
  }
  fragmentShader = kept.GatherFetches ? Shader::FreeOutputs(text) : text;
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& kept = *this->Internal;
  if (!kept.Gathering)
  {
    return true;
  }
  if (vtkTranslucencyVolumes::IsRayCaster(mapper))
  {
    kept.Volumes.SetShaderParameters(program);
    return true;
  }
  // vtkOpenGLImageSliceMapper turns it on and, like the mappers of points and edges, leaves it on.
  kept.Window->GetState()->vtkglDepthMask(kept.GatherWritesDepth ? GL_TRUE : GL_FALSE);
  kept.KeepGatherBlending(); // vtkPointGaussianMapper has set its own, if it is emissive
  CullFaces(kept.Window->GetState(), kept.GatherFaces, prop);
  vtkTranslucencyFrame::SetUniforms(program, kept.GatherUniforms);
  if (program->IsUniformUsed("gatherTransmission"))
  {
    double color[3];
    GetTransmissionColor(prop, color);
    program->SetUniform3f("gatherTransmission", color);
  }
  const char* sampler = "translucencyOpaqueDepth";
  if (!program->IsUniformUsed(sampler))
  {
    return true;
  }
  if (!kept.OpaqueDepthCaptured && !kept.CaptureOpaqueDepth())
  {
    kept.GatherError = "the depth buffer can't be copied";
    return false;
  }
  program->SetUniformi(sampler, kept.OpaqueDepthUnit);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPass::Internals::CaptureOpaqueDepth()
{
  vtkOpenGLState* state = this->Window->GetState();
  const int width = this->Viewport[0] + this->Viewport[2];
  const int height = this->Viewport[1] + this->Viewport[3];
  if (!this->OpaqueDepth)
  {
    this->OpaqueDepth = vtkSmartPointer<vtkTextureObject>::New();
    this->OpaqueDepth->SetContext(this->Window);
    this->OpaqueDepth->SetMinificationFilter(vtkTextureObject::Nearest);
    this->OpaqueDepth->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->OpaqueFramebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->OpaqueFramebuffer->SetContext(this->Window);
  }

  // A depth buffer can be copied to one of its own format only.
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  const auto query = [drawn](GLenum name, GLenum attachment) {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  const GLint bits =
    query(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, drawn ? GL_DEPTH_ATTACHMENT : GL_DEPTH);
  const GLint type =
    query(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, drawn ? GL_DEPTH_ATTACHMENT : GL_DEPTH);
  const bool stencil =
    query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, drawn ? GL_STENCIL_ATTACHMENT : GL_STENCIL) != GL_NONE;
  if (static_cast<int>(this->OpaqueDepth->GetWidth()) != width ||
    static_cast<int>(this->OpaqueDepth->GetHeight()) != height || bits != this->OpaqueDepthBits)
  {
    this->OpaqueDepthBits = bits;
    // VTK makes textures in the next free unit, and leaves them bound there.
    vtkTextureUnitManager* units = this->Window->GetTextureUnitManager();
    const int unit = units->Allocate();
    units->Free(unit);
    state->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + unit));
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    if (stencil)
    {
      this->OpaqueDepth->AllocateDepthStencil(width, height);
    }
    else
    {
      this->OpaqueDepth->AllocateDepth(width, height,
        type == GL_FLOAT ? vtkTextureObject::Float32
          : bits == 32   ? vtkTextureObject::Fixed32
          : bits == 24   ? vtkTextureObject::Fixed24
                         : vtkTextureObject::Fixed16);
    }
    this->OpaqueDepth->Deactivate();
    state->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  }

  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(drawn));
  this->OpaqueFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->OpaqueFramebuffer->AddDepthAttachment(this->OpaqueDepth);
  while (glGetError() != GL_NO_ERROR)
  {
    // an older error is not this copy's
  }
  const auto& from = this->Viewport;
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(from[0], from[1], width, height, from[0], from[1], width, height,
    GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glEnable(GL_SCISSOR_TEST);
  const bool copied = glGetError() == GL_NO_ERROR;
  state->PopFramebufferBindings();
  this->ActivateOpaqueDepth();
  this->OpaqueDepth->SendParameters();
  this->OpaqueDepthCaptured = true;
  return copied;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::Internals::ActivateOpaqueDepth()
{
  this->OpaqueDepthUnit = this->Window->GetTextureUnitManager()->Allocate();
  this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + this->OpaqueDepthUnit));
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &this->OpaqueDepthUnitBefore);
  glBindTexture(GL_TEXTURE_2D, this->OpaqueDepth->GetHandle());
}

//------------------------------------------------------------------------------
void vtkTranslucencyPass::Internals::DeactivateOpaqueDepth()
{
  this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + this->OpaqueDepthUnit));
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(this->OpaqueDepthUnitBefore));
  this->Window->GetTextureUnitManager()->Free(this->OpaqueDepthUnit);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTranslucencyPass::GetShaderStageMTime()
{
  return this->Internal->GatherTextTime;
}
