// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAutomaticTransparencyPass.h"

#include "vtkTechniqueChooser.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFactory.h"
#include "vtkTranslucencyFingerprint.h"
#include "vtkTranslucencyMedia.h"
#include "vtkTranslucencyOption.h"
#include "vtkTranslucencyStatistics.h"
#include "vtkTranslucencyTransmission.h"
#include "vtkTranslucencyVTKVersion.h"
#include "vtkVisibilityFunctionPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <limits>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkAutomaticTransparencyPass);

namespace
{
constexpr double BytesPerMiB = 1024.0 * 1024.0;
constexpr double Any = std::numeric_limits<double>::infinity();

// A pass keeps a few words for each square of pixels besides, and blocks of uniforms.
constexpr double BytesOfSquares = 0.1; // a pixel
constexpr double BytesOfBlocks = 4096;

// The header's table.
const std::vector<vtkTechniqueChooser::Candidate> Candidates{
  { "exact", 0, 1, 16, 4 + BytesOfSquares, 0, 8 },
  { "adaptive:nodes=16", 0.00014, 0.98, 16, 4 + BytesOfSquares, 0, 8 },
  { "hybrid:layers=16", 0.00059, 3.6, 0, BytesOfSquares, 216, 0 },
  { "adaptive:nodes=8", 0.00122, 1.1, 16, 4 + BytesOfSquares, 0, 8 },
  { "hybrid:layers=8", 0.00204, 1.2, 0, BytesOfSquares, 120, 0 },
  { "wavelet:memory=fixed:precision=half", 0.00428, 2.7, 0, BytesOfSquares, 60, 0 },
  { "hybrid:layers=4", 0.00813, 0.8, 0, BytesOfSquares, 72, 0 },
  { "weighted", 0.0315, 0.5, 0, BytesOfSquares, 20, 0 },
};

// The same of drivers without storage buffers.
const std::vector<vtkTechniqueChooser::Candidate> CandidatesOfTargets{
  { "peel:method=bucket-sort", 0, 9, 0, BytesOfSquares, 256, 0 },
  { "wavelet:memory=fixed:rank=4", 0.00319, 3.9, 0, BytesOfSquares, 156, 0 },
  { "wavelet:memory=fixed:precision=half", 0.00428, 2.7, 0, BytesOfSquares, 60, 0 },
  { "weighted", 0.0315, 0.5, 0, BytesOfSquares, 20, 0 },
};

// "adaptive:nodes=8"
vtkSmartPointer<vtkTranslucencyPass> NewTechnique(const std::string& text)
{
  std::istringstream parts(text);
  std::string part;
  std::getline(parts, part, ':');
  const auto pass = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(part));
  vtkSmartPointer<vtkTranslucencyPass> technique = vtkTranslucencyPass::SafeDownCast(pass);
  while (std::getline(parts, part, ':'))
  {
    const std::size_t equals = part.find('=');
    technique->SetOption(part.substr(0, equals), part.substr(equals + 1));
  }
  return technique;
}

int GetSamples()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return std::max(1, samples);
}

// Of memory that the technique's own limit does not count.
double GetBytesOutsideLimit(const vtkTechniqueChooser::Candidate& candidate, const vtkTechniqueChooser::View& view)
{
  const double samples = view.Samples > 1 ? candidate.BytesOfSamples * view.Samples : 0;
  return BytesOfBlocks + (BytesOfSquares + samples) * view.Pixels;
}
}

//------------------------------------------------------------------------------
// Draws by another pass, and counts the samples that are drawn.
class vtkFragmentCountingPass : public vtkRenderPass
{
public:
  static vtkFragmentCountingPass* New();
  vtkTypeMacro(vtkFragmentCountingPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    // Depth peeling, which stands in where a technique can't run, has a query of its own around this, and there is but
    // one at a time.
    GLint others = 0;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &others);
    const bool counts = this->Wanted && others == 0;
    if (counts)
    {
      if (this->Used == this->Queries.size())
      {
        this->Queries.push_back(0);
        glGenQueries(1, &this->Queries.back());
      }
      glBeginQuery(GL_SAMPLES_PASSED, this->Queries[this->Used]);
    }
    this->Pass->Render(state);
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
    if (counts)
    {
      glEndQuery(GL_SAMPLES_PASSED);
      ++this->Used;
    }
  }

  /// Samples of all drawings since the last call. Waits for them.
  double Take()
  {
    double samples = 0;
    for (std::size_t i = 0; i < this->Used; ++i)
    {
      GLuint64 counted = 0;
      glGetQueryObjectui64v(this->Queries[i], GL_QUERY_RESULT, &counted);
      samples += static_cast<double>(counted);
    }
    this->Used = 0;
    return samples;
  }

  void Release(bool contextAlive)
  {
    if (contextAlive && !this->Queries.empty())
    {
      glDeleteQueries(static_cast<GLsizei>(this->Queries.size()), this->Queries.data());
    }
    this->Queries.clear();
    this->Used = 0;
  }

  vtkSmartPointer<vtkRenderPass> Pass;
  bool Wanted = false;

private:
  std::vector<GLuint> Queries; // one a drawing of a frame
  std::size_t Used = 0;
};
vtkStandardNewMacro(vtkFragmentCountingPass);

//------------------------------------------------------------------------------
vtkAutomaticTransparencyPass::vtkAutomaticTransparencyPass()
  : Chooser(new vtkTechniqueChooser(Candidates))
  , Counting(vtkSmartPointer<vtkFragmentCountingPass>::New())
{
}

//------------------------------------------------------------------------------
vtkAutomaticTransparencyPass::~vtkAutomaticTransparencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BudgetMilliseconds: " << this->BudgetMilliseconds << "\n";
  os << indent << "BudgetMebibytes: " << this->BudgetMebibytes << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Chosen: " << this->GetChosen() << "\n";
  os << indent << "Reason: " << this->GetReason() << "\n";
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::SetNumber(const char* name, double& member, double value)
{
  if (vtkTranslucencyOption::SetProperty(this, vtkAutomaticTransparencyPass::GetOptions(), name, member, value))
  {
    this->Chooser->SetBudget(
      { this->BudgetMilliseconds, this->BudgetMebibytes, this->Tolerance }); // forgets what was measured
  }
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::SetBudgetMilliseconds(double milliseconds)
{
  this->SetNumber("BudgetMilliseconds", this->BudgetMilliseconds, milliseconds);
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::SetBudgetMebibytes(double mebibytes)
{
  this->SetNumber("BudgetMebibytes", this->BudgetMebibytes, mebibytes);
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::SetTolerance(double tolerance)
{
  this->SetNumber("Tolerance", this->Tolerance, tolerance);
}

//------------------------------------------------------------------------------
std::string vtkAutomaticTransparencyPass::GetChosen()
{
  return this->Chosen;
}

//------------------------------------------------------------------------------
std::string vtkAutomaticTransparencyPass::GetReason()
{
  return this->Reason;
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkAutomaticTransparencyPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "BudgetMilliseconds", "budget_milliseconds", Kind::Real, 0, 0, Any, {},
             "what the translucent stages of a frame may take, in milliseconds; 0 for any time",
             [this] { return this->GetBudgetMilliseconds(); },
             [this](double value) { this->SetBudgetMilliseconds(value); } },
    { "BudgetMebibytes", "budget_mebibytes", Kind::Real, 0, 0, Any, {},
      "graphics memory that the pass may take, in MiB; 0 for any", [this] { return this->GetBudgetMebibytes(); },
      [this](double value) { this->SetBudgetMebibytes(value); } },
    { "Tolerance", "tolerance", Kind::Real, 0, 0, 1, {},
      "an expected error, as a root mean square where 1 is the full range, below which the fastest technique comes "
      "first; 0 for the best",
      [this] { return this->GetTolerance(); }, [this](double value) { this->SetTolerance(value); } } };
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Delegate)
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Counting->Release(contextAlive);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTranslucencyPass> vtkAutomaticTransparencyPass::NewDelegate(const std::string& technique)
{
  vtkSmartPointer<vtkTranslucencyPass> pass = NewTechnique(technique);
  pass->SetCriticalSection(this->CriticalSection);
  pass->SetTranslucentPass(this->Counting);
  return pass;
}

//------------------------------------------------------------------------------
// Those that the driver can run and that draw all that the props ask for; all if it can run none, so that the chosen
// one says what is missing. Without storage buffers none absorbs, and weighted alone keeps transmission colours, which
// is no reason to draw by it.
void vtkAutomaticTransparencyPass::FindCandidates(const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  const bool storage = this->GetCapabilities(window).MissingForStorage.empty();
  const bool transmits = storage && vtkTranslucencyTransmission::CountProps(state).Props > 0;
  const bool absorbs = storage && vtkTranslucencyMedia::CountProps(state) > 0;
  const std::string device = this->GetCapabilities(window).Renderer + ", " + std::to_string(this->CriticalSection) +
    (transmits ? ", transmits" : "") + (absorbs ? ", absorbs" : "");
  if (this->Device == device)
  {
    return;
  }
  this->Device = device;
  std::vector<vtkTechniqueChooser::Candidate> candidates;
  const std::vector<vtkTechniqueChooser::Candidate>& known = storage ? Candidates : CandidatesOfTargets;
  for (const vtkTechniqueChooser::Candidate& candidate : known)
  {
    const auto pass = this->NewDelegate(candidate.Name);
    const bool whole = (!transmits || pass->KeepsTransmissionColors()) && (!absorbs || pass->KeepsFragments());
    if (whole && pass->GetMissing(window).empty())
    {
      candidates.push_back(candidate);
    }
  }
  this->Chooser.reset(new vtkTechniqueChooser(candidates.empty() ? known : candidates));
  this->Chooser->SetBudget({ this->BudgetMilliseconds, this->BudgetMebibytes, this->Tolerance });
  this->Delegate = nullptr;
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::Choose(const vtkRenderState* state)
{
  // Gives new props room for a pass's key, which modifies them once.
  this->PreRender(state);
  this->PostRender(state);
  int size[2];
  int corner[2];
  state->GetRenderer()->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
  vtkTechniqueChooser::View view;
  view.Pixels = static_cast<double>(corner[0] + size[0]) * (corner[1] + size[1]); // as far as targets reach
  view.Samples = GetSamples();
  vtkTranslucencyFingerprint fingerprint;
  fingerprint.Add(view.Pixels);
  fingerprint.Add(view.Samples);
  fingerprint.AddView(state);
  view.Changed = fingerprint.GetNumbers() != this->LastView;
  this->LastView = fingerprint.GetNumbers();

  const int chosen = this->Chooser->Choose(view);
  const vtkTechniqueChooser::Candidate& candidate = this->Chooser->GetCandidate(chosen);
  this->Reason = this->Chooser->GetReason();
  if (!this->Delegate || this->Chosen != candidate.Name)
  {
    this->Chosen = candidate.Name;
    this->Delegate = nullptr; // first, with all that it holds
    this->Delegate = this->NewDelegate(candidate.Name);
  }
  const double budget = this->BudgetMebibytes * BytesPerMiB;
  // What does not fit can't be drawn in tiles, but for lists.
  const double limit = this->Chooser->GetBytes(chosen, view) <= budget || this->Delegate->KeepsFragments()
    ? budget - GetBytesOutsideLimit(candidate, view)
    : 0;
  auto* function = vtkVisibilityFunctionPass::SafeDownCast(this->Delegate);
  const bool limited = !function || function->KeepsFragments() || function->UsesInFixedMemory("MemoryLimit");
  for (const vtkTranslucencyOption& option : this->Delegate->GetOptions())
  {
    if (option.Keyword == "memory_limit" && limited)
    {
      option.Set(std::max(0.0, limit) / BytesPerMiB);
    }
  }
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::Observe()
{
  vtkTranslucencyStatistics* statistics = this->GetStatistics();
  const double counted = this->Counting->Take() / GetSamples();
  if (!this->Counting->Wanted || statistics->GetTiles() == 0 || !statistics->GetFallback().empty())
  {
    return; // nothing was drawn by the technique
  }
  // A technique may draw everything several times. What lists hold is more where samples of a pixel belong to several
  // fragments.
  const double drawn = counted * statistics->GetTiles() / std::max(1, statistics->GetGeometryPasses());
  const auto listed = static_cast<double>(statistics->GetFragments());
  if (listed > 0 && drawn > 0)
  {
    this->ListedPerCounted = listed / drawn;
  }
  vtkTechniqueChooser::Cost cost;
  cost.Milliseconds = std::max(0.0, statistics->GetGatherTime()) + std::max(0.0, statistics->GetResolveTime());
  cost.Bytes = static_cast<double>(statistics->GetBytes());
  cost.Fragments = listed > 0 ? listed : drawn * this->ListedPerCounted;
  cost.Tiles = statistics->GetTiles();
  cost.Steady = statistics->GetShaderBuilds() == 0;
  this->Chooser->Observe(cost);
}

//------------------------------------------------------------------------------
void vtkAutomaticTransparencyPass::RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass)
{
  this->NumberOfRenderedProps = 0;
  this->GetStatistics()->Reset();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
  if (!window || !this->TranslucentPass)
  {
    vtkErrorMacro(<< (window ? "TranslucentPass is null" : "an OpenGL render window is needed"));
    return;
  }
  const bool selecting = state->GetRenderer()->GetSelector() != nullptr;
  this->FindCandidates(state, window);
  if (!selecting || !this->Delegate)
  {
    this->Choose(state);
  }
  this->Counting->Pass = this->TranslucentPass;
  this->Counting->Wanted = !selecting && (this->BudgetMilliseconds > 0 || this->BudgetMebibytes > 0);
  this->Delegate->SetVolumetricPass(volumetricPass);
  this->Delegate->SetMeasureTimes(this->MeasureTimes || this->BudgetMilliseconds > 0);
  this->Delegate->Render(state);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
  this->GetStatistics()->Copy(this->Delegate->GetStatistics());
  this->Observe();
}
VTK_ABI_NAMESPACE_END
