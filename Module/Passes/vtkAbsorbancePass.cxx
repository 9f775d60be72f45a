// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAbsorbancePass.h"

#include "vtkTranslucencyCapabilities.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
const char* const BoundsDefines[] = { "ABSORBANCE_BOUNDS_FRAGMENTS", "ABSORBANCE_BOUNDS_PROPS" };
const char* const Precisions[] = { "TERM_PRECISION_SINGLE", "TERM_PRECISION_HALF", "TERM_PRECISION_SHARED_EXPONENT" };
const char* const DepthWarps[] = { "DEPTH_WARP_LINEAR", "DEPTH_WARP_LOGARITHMIC" };
constexpr int TermsOfVector = 4;
constexpr int MostOutputs = 8;         // of a drawing
constexpr int TextureUnitsOfProps = 7; // for VTK's own textures, at least
}

//------------------------------------------------------------------------------
vtkAbsorbancePass::vtkAbsorbancePass(const Sums& sums)
  : Number(static_cast<int>(sums.Number.Default))
  , Technique(sums)
{
}

//------------------------------------------------------------------------------
vtkAbsorbancePass::~vtkAbsorbancePass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << this->Technique.Number.Name << ": " << this->Technique.Number.Format(this->Number) << "\n";
  os << indent << "Bounds: " << BoundsDefines[this->Bounds] << "\n";
  os << indent << "Precision: " << Precisions[this->Precision] << "\n";
  os << indent << "DepthWarp: " << DepthWarps[this->DepthWarp] << "\n";
  os << indent << "AlphaCorrection: " << this->AlphaCorrection << "\n";
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::SetSums(int number)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkAbsorbancePass::GetOptions(), this->Technique.Number.Name.c_str(), this->Number, number);
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::SetBounds(int bounds)
{
  vtkTranslucencyOption::SetProperty(this, vtkAbsorbancePass::GetOptions(), "Bounds", this->Bounds, bounds);
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::SetPrecision(int precision)
{
  if (vtkTranslucencyOption::Check(this, vtkAbsorbancePass::GetOptions(), "Precision", precision) &&
    this->Precision != precision)
  {
    this->ReleaseGraphicsResources(nullptr); // what the other one holds
    this->Precision = precision;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::SetDepthWarp(int warp)
{
  vtkTranslucencyOption::SetProperty(this, vtkAbsorbancePass::GetOptions(), "DepthWarp", this->DepthWarp, warp);
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::SetAlphaCorrection(bool correction)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkAbsorbancePass::GetOptions(), "AlphaCorrection", this->AlphaCorrection, correction);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkAbsorbancePass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  vtkTranslucencyOption number = this->Technique.Number;
  number.Get = [this] { return this->Number; };
  number.Set = [this](double value) { this->SetSums(static_cast<int>(value)); };
  std::vector<std::string> precisions{ "single", "half" };
  std::string precisionHelp =
    "the floats in which memory fixed holds the sums: of 32 bits, or of 16, which take half the memory and are coarser";
  if (!this->Technique.Negative)
  {
    precisions.emplace_back("shared-exponent");
    precisionHelp += "; or words of a buffer, of 9-9-9-5 bits for transmission colours, which then are told apart";
  }
  std::vector<vtkTranslucencyOption> options{ number, this->GetMemoryOption(),
    { "Bounds", "bounds", Kind::Choice, Fragments, 0, 1, { "fragments", "props" },
      "the range of depths that is told apart: each pixel's own, for which fixed memory draws the geometry once more, "
      "or that of all props",
      [this] { return this->GetBounds(); }, [this](double value) { this->SetBounds(static_cast<int>(value)); } },
    { "Precision", "precision", Kind::Choice, Single, 0, static_cast<double>(precisions.size() - 1), precisions,
      precisionHelp, [this] { return this->GetPrecision(); },
      [this](double value) { this->SetPrecision(static_cast<int>(value)); } },
    { "DepthWarp", "depth_warp", Kind::Choice, Linear, 0, 1, { "linear", "logarithmic" },
      "how depths are spread over that range: evenly, or near ones farther apart, in perspectives",
      [this] { return this->GetDepthWarp(); }, [this](double value) { this->SetDepthWarp(static_cast<int>(value)); } },
    { "AlphaCorrection", "alpha_correction", Kind::Choice, 1, 0, 1, { "off", "on" },
      "on scales colours so that the weights of a pixel's fragments add up to what they hide",
      [this] { return this->GetAlphaCorrection() ? 1 : 0; },
      [this](double value) { this->SetAlphaCorrection(value != 0); } } };
  for (const vtkTranslucencyOption& option : this->Superclass::GetOptions())
  {
    options.push_back(option);
  }
  return options;
}

//------------------------------------------------------------------------------
bool vtkAbsorbancePass::UsesInFixedMemory(const std::string& name) const
{
  return name == "MemoryLimit" && this->Precision == SharedExponent;
}

//------------------------------------------------------------------------------
bool vtkAbsorbancePass::UsesStorage(const vtkTranslucencyCapabilities& capabilities) const
{
  return this->Memory == Variable
    ? capabilities.MissingForStorage.empty()
    : this->Precision == SharedExponent && this->FindMissingForWords(capabilities).empty();
}

//------------------------------------------------------------------------------
std::string vtkAbsorbancePass::FindMissingForWords(const vtkTranslucencyCapabilities& capabilities) const
{
  return capabilities.MissingForStorage.empty() ? capabilities.MissingForRetries : capabilities.MissingForStorage;
}

//------------------------------------------------------------------------------
std::string vtkAbsorbancePass::FindMissing(const vtkTranslucencyCapabilities& capabilities) const
{
  const std::string missing = this->Superclass::FindMissing(capabilities);
  const int units = this->GetTermVectors() + 1 + TextureUnitsOfProps;
  const bool tooFew = !this->UsesStorage(capabilities) && units > capabilities.TextureUnits;
  return missing.empty() && tooFew ? std::to_string(units) + " texture units for " + this->Technique.Number.Name + " " +
      this->Technique.Number.Format(this->Number) + ", of which there are " + std::to_string(capabilities.TextureUnits)
                                   : missing;
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
  if (window)
  {
    const vtkTranslucencyCapabilities& capabilities = this->GetCapabilities(window);
    const std::string warning = this->FindConflict(capabilities);
    if (!warning.empty() && warning != this->Warning)
    {
      vtkWarningMacro(<< warning);
    }
    this->Warning = warning;
    this->HasWords = this->Memory == Fixed && this->UsesStorage(capabilities);
  }
  this->Superclass::RenderTranslucent(state, volumetricPass);
}

//------------------------------------------------------------------------------
std::string vtkAbsorbancePass::FindConflict(const vtkTranslucencyCapabilities& capabilities) const
{
  if (this->Memory == Variable && !capabilities.MissingForStorage.empty())
  {
    return "the driver lacks " + capabilities.MissingForStorage +
      ", which Memory Variable (0) needs; drawing as with Fixed (1)";
  }
  if (this->Memory == Variable && this->Precision != Single)
  {
    return "Precision is " + std::to_string(this->Precision) +
      ", but Memory is Variable (0), which has the sums in registers: expected Memory Fixed (1), or Precision Single "
      "(0)";
  }
  const std::string missing = this->FindMissingForWords(capabilities);
  return this->Precision == SharedExponent && !missing.empty()
    ? "the driver lacks " + missing + ", which Precision SharedExponent (2) needs; drawing as with Single (0)"
    : "";
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Defines vtkAbsorbancePass::GetDefines(int precision) const
{
  vtkTranslucencyFrame::Defines defines{ { this->Technique.Define, std::to_string(this->Number) } };
  defines["TERM_PRECISION"] = Precisions[precision];
  defines["DEPTH_WARP"] = DepthWarps[this->DepthWarp];
  defines["ABSORBANCE_BOUNDS"] = BoundsDefines[this->Bounds];
  return defines;
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Defines vtkAbsorbancePass::GetCorrection() const
{
  return { { "ALPHA_CORRECTION", this->AlphaCorrection ? "1" : "0" } };
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Uniforms vtkAbsorbancePass::GetValues(const vtkTranslucencyFrame& frame) const
{
  if (this->Bounds == Fragments)
  {
    return {};
  }
  const std::array<double, 2> range = frame.GetDepthRange();
  return { { "rangeNear", static_cast<float>(range[0]) }, { "rangeFar", static_cast<float>(range[1]) } };
}

//------------------------------------------------------------------------------
int vtkAbsorbancePass::GetTermVectors() const
{
  return (this->GetTermCount() + TermsOfVector - 1) / TermsOfVector;
}

//------------------------------------------------------------------------------
// Floats of each target; three take the room of four.
std::vector<int> vtkAbsorbancePass::GetTermFormats() const
{
  const int rest = (this->GetTermCount() - 1) % TermsOfVector + 1;
  std::vector<int> formats((this->GetTermCount() - 1) / TermsOfVector, TermsOfVector);
  formats.push_back(rest == 3 ? TermsOfVector : rest);
  return formats;
}

//------------------------------------------------------------------------------
// Fills the words, or the targets, for which the stage has all that is the same for each of their drawings.
bool vtkAbsorbancePass::DrawTerms(
  vtkTranslucencyFrame& frame, const vtkTranslucencyFrame::Gathering& gathering, vtkTranslucencyFrame::Stage& stage)
{
  stage.Number = 1;
  if (this->HasWords)
  {
    stage.StoresOnly = true;
    return frame.Draw(gathering, stage);
  }
  const std::vector<int> formats = this->GetTermFormats();
  bool drawn = true;
  for (std::size_t first = 0; first < formats.size(); first += MostOutputs)
  {
    vtkTranslucencyTargets& targets = this->Terms[first / MostOutputs];
    stage.Targets = &targets;
    const auto begin = formats.begin() + first;
    const std::vector<int> drawnFormats(begin, std::min(begin + MostOutputs, formats.end()));
    drawn = drawn && frame.UseTargets(targets, drawnFormats, this->Precision == Half) && frame.Draw(gathering, stage);
    stage.Number = 3;
  }
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkAbsorbancePass::RenderFixed(vtkTranslucencyFrame& frame)
{
  const int vectors = this->GetTermVectors();
  const int precision = this->Precision == SharedExponent && !this->HasWords ? Single : this->Precision;
  const std::vector<int> formats = frame.GetChannels() == 3 ? std::vector<int>{ 4, 4, 4 } : std::vector<int>{ 4, 1 };
  vtkTranslucencyFrame::Gathering gathering{ this->Technique.Folder + "/Gather.glsl", this->GetDefines(precision),
    this->HasWords ? static_cast<int>(formats.size()) : std::clamp(vectors, 2, MostOutputs) };
  gathering.Values["GATHER_OUTPUTS"] = std::to_string(gathering.Outputs);
  gathering.Atomic = this->HasWords;
  if (this->HasWords &&
    !frame.UsePixels(this->Words, TermsOfVector * vectors, this->Storage->GetMemoryLimit(), { 0, 0 }, true))
  {
    return false;
  }

  // One text reads all targets, each in the stage that needs it. In the others its sampler sees Colors, which is not
  // drawn to then: a sampler that sees nothing may meet one of another type at its unit.
  const auto inputs = [&](bool bounds, bool terms)
  {
    std::vector<vtkTranslucencyFrame::Input> read;
    if (this->Bounds == Fragments)
    {
      read.push_back({ "depthBounds", bounds ? &this->DepthBounds : &this->Colors, 0 });
    }
    for (int i = 0; i < vectors && !this->HasWords; ++i)
    {
      read.push_back({ "terms" + std::to_string(i), terms ? &this->Terms[i / MostOutputs] : &this->Colors,
        terms ? i % MostOutputs : 0 });
    }
    return read;
  };
  using Blending = vtkTranslucencyFrame::Blending;
  const vtkTranslucencyFrame::Uniforms values = this->GetValues(frame);
  vtkTranslucencyFrame::Stage bounds;
  bounds.Targets = &this->DepthBounds;
  bounds.Blend = Blending::Maximum;
  bounds.Clear = { { -2, -2, -2, -2 } };
  bounds.Inputs = inputs(false, false);
  vtkTranslucencyFrame::Stage terms;
  terms.Inputs = inputs(true, false);
  terms.Values = values;
  vtkTranslucencyFrame::Stage colors;
  colors.Number = 2;
  colors.Targets = &this->Colors;
  colors.Blend = Blending::AddAndAttenuate;
  colors.Clear = { { 0, 0, 0, 1 } };
  colors.Inputs = inputs(true, true);
  colors.Values = values;

  std::vector<vtkTranslucencyFrame::Input> sums{ { "gatheredColors", &this->Colors, 0 } };
  if (formats.size() == 3)
  {
    sums.push_back({ "gatheredWeights", &this->Colors, 1 });
    sums.push_back({ "gatheredLight", &this->Colors, 2 });
  }
  else if (this->AlphaCorrection)
  {
    sums.push_back({ "gatheredWeights", &this->Colors, 1 });
  }
  return frame.UseTargets(this->Colors, formats) &&
    (this->Bounds == Props || (frame.UseTargets(this->DepthBounds, { 2 }) && frame.Draw(gathering, bounds))) &&
    this->DrawTerms(frame, gathering, terms) && frame.Draw(gathering, colors) &&
    frame.Composite("Common/CompositeColors.glsl", this->GetCorrection(), sums);
}

//------------------------------------------------------------------------------
bool vtkAbsorbancePass::ResolveLists(vtkTranslucencyFrame& frame)
{
  vtkTranslucencyFrame::Defines defines = this->GetDefines(Single);
  defines.merge(this->GetCorrection());
  const vtkTranslucencyFrame::Uniforms values = this->GetValues(frame);
  const std::string& folder = this->Technique.Folder;
  vtkTranslucencyFrame::Squares squares;
  for (int size : { 8, 16, 32 })
  {
    vtkTranslucencyFrame::Defines block = defines;
    block.insert({ { "BLOCK_SIZE", std::to_string(size) }, { "EQUAL_DEPTHS", "0" },
      { "LONGER_LEVEL", LevelText(squares.Level + 1) } });
    squares.Most = size;
    if (!frame.Resolve(folder + "/ResolveShort.glsl", block, squares, values))
    {
      return false;
    }
    ++squares.Level;
    squares.Fewer = size;
  }
  squares.Most = VTK_INT_MAX;
  defines["UNFINISHED_LEVEL"] = LevelText(Long);
  return (!frame.IsLeftTo(squares) || frame.Resolve(folder + "/Resolve.glsl", defines, squares, values)) &&
    this->ResolveLeftLists(frame);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkAbsorbancePass::GetTechniqueBytes()
{
  return this->Superclass::GetTechniqueBytes() + this->DepthBounds.GetBytes() + this->Terms[0].GetBytes() +
    this->Terms[1].GetBytes() + this->Words.GetBytes() + this->Colors.GetBytes();
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Superclass::ReleaseTechniqueResources(contextAlive);
  this->Words.Release(contextAlive);
  for (vtkTranslucencyTargets* targets : { &this->DepthBounds, &this->Terms[0], &this->Terms[1], &this->Colors })
  {
    targets->Release(contextAlive);
  }
}
VTK_ABI_NAMESPACE_END
