// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveTransparencyPass.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkAdaptiveTransparencyPass);

namespace
{
constexpr int LeastNodes = 1;
constexpr int MostNodes = 64;

const char* const Removals[] = { "NODE_REMOVAL_UNDERESTIMATE", "NODE_REMOVAL_OVERESTIMATE", "NODE_REMOVAL_MIXED" };
const char* const Shows[] = { "SHOW_PICTURE", "SHOW_ERROR", "SHOW_NODES" };
}

//------------------------------------------------------------------------------
vtkAdaptiveTransparencyPass::~vtkAdaptiveTransparencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NodeCount: " << this->NodeCount << "\n";
  os << indent << "NodeRemoval: " << Removals[this->NodeRemoval] << "\n";
  os << indent << "AlphaCorrection: " << this->AlphaCorrection << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Show: " << Shows[this->Show] << "\n";
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetNodeCount(int count)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkAdaptiveTransparencyPass::GetOptions(), "NodeCount", this->NodeCount, count);
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetNodeRemoval(int removal)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkAdaptiveTransparencyPass::GetOptions(), "NodeRemoval", this->NodeRemoval, removal);
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetAlphaCorrection(bool correction)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkAdaptiveTransparencyPass::GetOptions(), "AlphaCorrection", this->AlphaCorrection, correction);
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetTolerance(double tolerance)
{
  if (tolerance > 0 && this->Memory == Fixed)
  {
    vtkErrorMacro(<< "Tolerance is " << tolerance << ", expected 0 while Memory is Fixed");
    return;
  }
  vtkTranslucencyOption::SetProperty(
    this, vtkAdaptiveTransparencyPass::GetOptions(), "Tolerance", this->Tolerance, tolerance);
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetMemory(int memory)
{
  if (memory == Fixed && this->Tolerance > 0)
  {
    vtkErrorMacro(<< "Memory is Fixed (1), expected Variable (0) while Tolerance is " << this->Tolerance);
    return;
  }
  this->Superclass::SetMemory(memory);
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetShow(int show)
{
  vtkTranslucencyOption::SetProperty(this, vtkAdaptiveTransparencyPass::GetOptions(), "Show", this->Show, show);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkAdaptiveTransparencyPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  std::vector<vtkTranslucencyOption> options{
    { "NodeCount", "nodes", Kind::Integer, 16, LeastNodes, MostNodes, {},
      "nodes of the visibility function; 8 is hard to tell from exact, 16 safer for hair and smoke",
      [this] { return this->GetNodeCount(); }, [this](double value) { this->SetNodeCount(static_cast<int>(value)); } },
    { "NodeRemoval", "removal", Kind::Choice, Underestimate, 0, 2, { "underestimate", "overestimate", "mixed" },
      "how a full visibility function loses a node; underestimate looks best",
      [this] { return this->GetNodeRemoval(); },
      [this](double value) { this->SetNodeRemoval(static_cast<int>(value)); } },
    { "AlphaCorrection", "alpha_correction", Kind::Choice, 1, 0, 1, { "off", "on" },
      "on weighs what has lost its node so that a pixel's weights add up to what its fragments hide, which is about "
      "ten times nearer to exact; off is the paper",
      [this] { return this->GetAlphaCorrection() ? 1 : 0; },
      [this](double value) { this->SetAlphaCorrection(value != 0); } },
    { "Tolerance", "tolerance", Kind::Real, 0, 0, 1, {},
      "pixels whose estimated error is greater take more than 'nodes' nodes: the mean error of transmittance over a "
      "pixel's depths; 0 sets no limit; "
      "not in fixed memory",
      [this] { return this->GetTolerance(); }, [this](double value) { this->SetTolerance(value); } },
    { "Show", "show", Kind::Choice, Picture, 0, 2, { "picture", "error", "nodes" },
      "error draws the estimated error of each pixel, white where it reaches the tolerance (0.1 if that is 0); nodes "
      "the nodes it uses, white "
      "where it is 64 or all fragments were sorted",
      [this] { return this->GetShow(); }, [this](double value) { this->SetShow(static_cast<int>(value)); } },
    this->GetMemoryOption(), this->GetCriticalSectionOption()
  };
  for (const vtkTranslucencyOption& option : this->Superclass::GetOptions())
  {
    options.push_back(option);
  }
  return options;
}

//------------------------------------------------------------------------------
std::string vtkAdaptiveTransparencyPass::FindMissing(const vtkTranslucencyCapabilities& capabilities) const
{
  const std::string missing = this->Superclass::FindMissing(capabilities);
  return missing.empty() && this->Memory == Fixed ? this->FindMissingForCriticalSection(capabilities) : missing;
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Defines vtkAdaptiveTransparencyPass::GetDefines(int nodes) const
{
  vtkTranslucencyFrame::Defines defines = this->GetCorrection();
  defines.insert({ { "NODE_COUNT", std::to_string(nodes) }, { "NODE_REMOVAL", Removals[this->NodeRemoval] } });
  return defines;
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Defines vtkAdaptiveTransparencyPass::GetCorrection() const
{
  return { { "ALPHA_CORRECTION", this->AlphaCorrection ? "1" : "0" } };
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Uniforms vtkAdaptiveTransparencyPass::GetWhite() const
{
  if (this->Show != Error)
  {
    return {};
  }
  return { { "errorWhite", static_cast<float>(this->Tolerance > 0 ? this->Tolerance : DefaultWhite) } };
}

//------------------------------------------------------------------------------
bool vtkAdaptiveTransparencyPass::UsesInFixedMemory(const std::string& name) const
{
  return name == "MemoryLimit";
}

//------------------------------------------------------------------------------
bool vtkAdaptiveTransparencyPass::RenderFixed(vtkTranslucencyFrame& frame)
{
  // Adaptive/Record.glsl
  const int channels = frame.GetChannels();
  constexpr int wordsOfEstimate = 3;
  const int transmittances = channels == 3 ? 3 * this->NodeCount : (this->NodeCount + 1) / 2;
  const int words = this->NodeCount + transmittances + (this->Show == Error ? wordsOfEstimate : 0);
  vtkTranslucencyFrame::Defines defines = this->GetDefines(this->NodeCount);
  defines["ESTIMATE_ERROR"] = this->Show == Error ? "1" : "0";
  vtkTranslucencyFrame::Gathering gathering{ "Adaptive/Gather.glsl", defines };
  gathering.Critical = true;
  vtkTranslucencyFrame::Stage visibility;
  visibility.StoresOnly = true;
  vtkTranslucencyFrame::Stage shading;
  shading.Number = 1;
  constexpr int wordsOfCount = 1;
  constexpr int wordsOfSums = 5;
  const bool fetchable = channels == 1 && this->Show == Picture;
  if (!frame.UsePixels(this->Functions, words, this->Storage->GetMemoryLimit(),
        { fetchable ? wordsOfCount + words + wordsOfSums : 0, wordsOfCount }))
  {
    return false;
  }
  if (frame.FetchesRecords())
  {
    this->Colors.Release();
    defines.erase("NODE_REMOVAL");
    return frame.Draw(gathering, visibility) && frame.Draw(gathering, shading) &&
      frame.Composite("Adaptive/ResolveFetched.glsl", defines, {});
  }
  std::vector<int> sums{ 4 };
  std::vector<vtkTranslucencyFrame::Input> inputs{ { "gatheredColors", &this->Colors, 0 } };
  if (channels == 3)
  {
    sums = { 4, 4, 4 };
    inputs.push_back({ "gatheredWeights", &this->Colors, 1 });
    inputs.push_back({ "gatheredLight", &this->Colors, 2 });
  }
  else if (this->AlphaCorrection)
  {
    sums = { 4, 1 };
    inputs.push_back({ "gatheredWeights", &this->Colors, 1 });
  }
  gathering.Outputs = static_cast<int>(sums.size());
  shading.Targets = &this->Colors;
  shading.Blend = vtkTranslucencyFrame::Blending::AddAndAttenuate;
  shading.Clear = { { 0, 0, 0, 1 } };
  if (!frame.UseTargets(this->Colors, sums) || !frame.Draw(gathering, visibility))
  {
    return false;
  }
  if (this->Show != Picture)
  {
    defines["SHOW"] = Shows[this->Show];
    return frame.Composite("Adaptive/ShowFixed.glsl", defines, {}, this->GetWhite());
  }
  return frame.Draw(gathering, shading) &&
    frame.Composite("Common/CompositeColors.glsl", this->GetCorrection(), inputs);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkAdaptiveTransparencyPass::GetTechniqueBytes()
{
  return this->Superclass::GetTechniqueBytes() + this->Functions.GetBytes() + this->Colors.GetBytes();
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Superclass::ReleaseTechniqueResources(contextAlive);
  this->Functions.Release(contextAlive);
  this->Colors.Release(contextAlive);
}

//------------------------------------------------------------------------------
bool vtkAdaptiveTransparencyPass::ResolveLists(vtkTranslucencyFrame& frame)
{
  // A list of no more fragments than nodes needs no compression: it is exact, and sorting it takes fewer steps.
  vtkTranslucencyFrame::Squares rest;
  if (this->Show == Picture && !this->ResolveShortLists(frame, this->NodeCount, Technique, rest))
  {
    return false;
  }
  if (this->Tolerance > 0)
  {
    return this->ResolveToTolerance(frame, rest) && this->ResolveExactly(frame);
  }
  vtkTranslucencyFrame::Defines defines = this->GetDefines(this->NodeCount);
  defines.insert({ { "EQUAL_DEPTHS", "0" }, { "EQUAL_DEPTHS_LEVEL", LevelText(TechniqueMore) },
    { "UNFINISHED_LEVEL", LevelText(Long) }, { "TOLERANCE", "0" }, { "SHOW", Shows[this->Show] } });
  if (!frame.Resolve("Adaptive/Resolve.glsl", defines, rest, this->GetWhite()))
  {
    return false;
  }
  if (frame.IsLeftTo(TechniqueMore))
  {
    defines["EQUAL_DEPTHS"] = "1";
    const auto left = vtkTranslucencyFrame::Squares::LeftTo(TechniqueMore);
    if (!frame.Resolve("Adaptive/Resolve.glsl", defines, left, this->GetWhite()))
    {
      return false;
    }
  }
  return this->ResolveExactly(frame);
}

//------------------------------------------------------------------------------
// Each step has twice the nodes of the one before, and draws what that has left. Between fragments of equal depth there
// is no area to lose: pixels that have such are sorted, whatever the estimate.
bool vtkAdaptiveTransparencyPass::ResolveToTolerance(
  vtkTranslucencyFrame& frame, const vtkTranslucencyFrame::Squares& squares)
{
  vtkTranslucencyFrame::Uniforms uniforms = this->GetWhite();
  uniforms["errorTolerance"] = static_cast<float>(this->Tolerance);
  vtkTranslucencyFrame::Squares left = squares;
  int nodes = this->NodeCount;
  for (int finer = TechniqueMore;; ++finer)
  {
    const bool last = nodes == MostNodes;
    vtkTranslucencyFrame::Defines defines = this->GetDefines(nodes);
    defines.insert(
      { { "EQUAL_DEPTHS", "0" }, { "EQUAL_DEPTHS_LEVEL", LevelText(Long) }, { "UNFINISHED_LEVEL", LevelText(Long) },
        { "TOLERANCE", "1" }, { "FINER_LEVEL", LevelText(last ? Long : finer) }, { "SHOW", Shows[this->Show] } });
    if (!frame.Resolve("Adaptive/Resolve.glsl", defines, left, uniforms))
    {
      return false;
    }
    if (last || !frame.IsLeftTo(finer))
    {
      return true;
    }
    left = vtkTranslucencyFrame::Squares::LeftTo(finer);
    nodes = std::min(2 * nodes, MostNodes);
  }
}

//------------------------------------------------------------------------------
bool vtkAdaptiveTransparencyPass::ResolveExactly(vtkTranslucencyFrame& frame)
{
  if (this->Show == Picture)
  {
    return this->ResolveLeftLists(frame);
  }
  return !frame.IsLeftTo(Long) ||
    frame.Resolve("Adaptive/ShowSorted.glsl", { { "SHOW", Shows[this->Show] } },
      vtkTranslucencyFrame::Squares::LeftTo(Long), this->GetWhite());
}
VTK_ABI_NAMESPACE_END
