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
const char* const Precisions[] = { "TERM_PRECISION_SINGLE", "TERM_PRECISION_HALF" };
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
  vtkTranslucencyOption::SetProperty(this, vtkAbsorbancePass::GetOptions(), "Precision", this->Precision, precision);
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
  std::vector<vtkTranslucencyOption> options{ number, this->GetMemoryOption(),
    { "Bounds", "bounds", Kind::Choice, Fragments, 0, 1, { "fragments", "props" },
      "the range of depths that is told apart: each pixel's own, for which fixed memory draws the geometry once more, "
      "or that of all props",
      [this] { return this->GetBounds(); }, [this](double value) { this->SetBounds(static_cast<int>(value)); } },
    { "Precision", "precision", Kind::Choice, Single, 0, 1, { "single", "half" },
      "the floats in which memory fixed holds the sums: of 32 bits, or of 16, which take half the memory and are "
      "coarser",
      [this] { return this->GetPrecision(); }, [this](double value) { this->SetPrecision(static_cast<int>(value)); } },
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
bool vtkAbsorbancePass::UsesStorage(const vtkTranslucencyCapabilities& capabilities) const
{
  return this->Memory == Variable && capabilities.MissingForStorage.empty();
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
  const std::string missing = window ? this->GetCapabilities(window).MissingForStorage : "";
  std::string warning;
  if (this->Memory == Variable && !missing.empty())
  {
    warning = "the driver lacks " + missing + ", which Memory Variable (0) needs; drawing as with Fixed (1)";
  }
  else if (this->Memory == Variable && this->Precision != Single)
  {
    warning = "Precision is Half (1), but Memory is Variable (0), which has the sums in registers: expected Memory "
              "Fixed (1), or Precision Single (0)";
  }
  if (!warning.empty() && warning != this->Warning)
  {
    vtkWarningMacro(<< warning);
  }
  this->Warning = warning;
  this->Superclass::RenderTranslucent(state, volumetricPass);
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
bool vtkAbsorbancePass::RenderFixed(vtkTranslucencyFrame& frame)
{
  const std::vector<int> formats = this->GetTermFormats();
  const int vectors = static_cast<int>(formats.size());
  vtkTranslucencyFrame::Gathering gathering{ this->Technique.Folder + "/Gather.glsl", this->GetDefines(this->Precision),
    std::clamp(vectors, 2, MostOutputs) };
  gathering.Values["GATHER_OUTPUTS"] = std::to_string(gathering.Outputs);

  // One text reads all targets, each in the stage that needs it. In the others its sampler sees Colors, which is not
  // drawn to then: a sampler that sees nothing may meet one of another type at its unit.
  const auto inputs = [&](bool bounds, bool terms)
  {
    std::vector<vtkTranslucencyFrame::Input> read;
    if (this->Bounds == Fragments)
    {
      read.push_back({ "depthBounds", bounds ? &this->DepthBounds : &this->Colors, 0 });
    }
    for (int i = 0; i < vectors; ++i)
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
  vtkTranslucencyFrame::Stage colors;
  colors.Number = 2;
  colors.Targets = &this->Colors;
  colors.Blend = Blending::AddAndAttenuate;
  colors.Clear = { { 0, 0, 0, 1 } };
  colors.Inputs = inputs(true, true);
  colors.Values = values;

  bool drawn = frame.UseTargets(this->Colors, { 4, 1 }) &&
    (this->Bounds == Props || (frame.UseTargets(this->DepthBounds, { 2 }) && frame.Draw(gathering, bounds)));
  for (int first = 0; first < vectors; first += MostOutputs)
  {
    vtkTranslucencyTargets& targets = this->Terms[first / MostOutputs];
    vtkTranslucencyFrame::Stage terms;
    terms.Number = first == 0 ? 1 : 3;
    terms.Targets = &targets;
    terms.Inputs = inputs(true, false);
    terms.Values = values;
    const auto begin = formats.begin() + first;
    drawn = drawn &&
      frame.UseTargets(targets, { begin, std::min(begin + MostOutputs, formats.end()) }, this->Precision == Half) &&
      frame.Draw(gathering, terms);
  }

  std::vector<vtkTranslucencyFrame::Input> sums{ { "gatheredColors", &this->Colors, 0 } };
  if (this->AlphaCorrection)
  {
    sums.push_back({ "gatheredWeights", &this->Colors, 1 });
  }
  return drawn && frame.Draw(gathering, colors) &&
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
    this->Terms[1].GetBytes() + this->Colors.GetBytes();
}

//------------------------------------------------------------------------------
void vtkAbsorbancePass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Superclass::ReleaseTechniqueResources(contextAlive);
  for (vtkTranslucencyTargets* targets : { &this->DepthBounds, &this->Terms[0], &this->Terms[1], &this->Colors })
  {
    targets->Release(contextAlive);
  }
}
VTK_ABI_NAMESPACE_END
