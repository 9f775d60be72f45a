// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWeightedTransparencyPass.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWeightedTransparencyPass);

namespace
{
const char* const WeightedMethods[] = { "WEIGHTED_SUM", "WEIGHTED_AVERAGE", "WEIGHTED_BLENDED" };
const char* const Equations[] = { "7", "8", "9", "10" };
constexpr double Farthest = 1e6;
}

//------------------------------------------------------------------------------
vtkWeightedTransparencyPass::~vtkWeightedTransparencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkWeightedTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << WeightedMethods[this->Method] << "\n";
  os << indent << "WeightFunction: equation " << Equations[this->WeightFunction] << "\n";
  os << indent << "DepthNear: " << this->DepthNear << "\n";
  os << indent << "DepthFar: " << this->DepthFar << "\n";
}

//------------------------------------------------------------------------------
void vtkWeightedTransparencyPass::SetMethod(int method)
{
  vtkTranslucencyOption::SetProperty(this, vtkWeightedTransparencyPass::GetOptions(), "Method", this->Method, method);
}

//------------------------------------------------------------------------------
void vtkWeightedTransparencyPass::SetWeightFunction(int function)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkWeightedTransparencyPass::GetOptions(), "WeightFunction", this->WeightFunction, function);
}

//------------------------------------------------------------------------------
void vtkWeightedTransparencyPass::SetDepthNear(double distance)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkWeightedTransparencyPass::GetOptions(), "DepthNear", this->DepthNear, distance);
}

//------------------------------------------------------------------------------
void vtkWeightedTransparencyPass::SetDepthFar(double distance)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkWeightedTransparencyPass::GetOptions(), "DepthFar", this->DepthFar, distance);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkWeightedTransparencyPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  constexpr double nearest = 1e-6;
  return {
    { "Method", "method", Kind::Choice, Blended, 0, 2, { "sum", "average", "blended" },
      "sum and average don't look at depth; blended gives near fragments more weight, and what shows through is exact",
      [this] { return this->GetMethod(); }, [this](double value) { this->SetMethod(static_cast<int>(value)); } },
    { "WeightFunction", "weight_function", Kind::Choice, Equation10, 0, 3,
      { "equation7", "equation8", "equation9", "equation10" },
      "how the weight falls with depth if the method is blended, as numbered by McGuire and Bavoil (2013)",
      [this] { return this->GetWeightFunction(); },
      [this](double value) { this->SetWeightFunction(static_cast<int>(value)); } },
    { "DepthNear", "depth_near", Kind::Real, 0.1, nearest, Farthest, {},
      "distance that equations 7 to 9 take the near plane for", [this] { return this->GetDepthNear(); },
      [this](double value) { this->SetDepthNear(value); } },
    { "DepthFar", "depth_far", Kind::Real, 500, nearest, Farthest, {},
      "distance that equations 7 to 9 take the far plane for", [this] { return this->GetDepthFar(); },
      [this](double value) { this->SetDepthFar(value); } }
  };
}

//------------------------------------------------------------------------------
bool vtkWeightedTransparencyPass::RenderStages(vtkTranslucencyFrame& frame)
{
  const vtkTranslucencyFrame::Defines method{ { "WEIGHTED_METHOD", WeightedMethods[this->Method] } };
  const bool colored = frame.GetChannels() == 3;
  std::vector<int> formats{ 4 };
  if (colored)
  {
    formats.resize(this->Method == Blended ? 3 : 2, 4);
  }
  else if (this->Method != Sum)
  {
    formats.push_back(1);
  }
  std::vector<vtkTranslucencyFrame::Input> inputs;
  for (std::size_t i = 0; i < formats.size(); ++i)
  {
    inputs.push_back({ "weightedTarget" + std::to_string(i), &this->Sums, static_cast<int>(i) });
  }
  vtkTranslucencyFrame::Gathering gathering{ "Weighted/Gather.glsl", method, static_cast<int>(formats.size()) };
  gathering.Values["WEIGHTED_TARGETS"] = std::to_string(formats.size());
  vtkTranslucencyFrame::Stage sums;
  sums.Targets = &this->Sums;
  if (this->Method == Blended)
  {
    gathering.Values["WEIGHT_FUNCTION"] = Equations[this->WeightFunction];
    if (colored)
    {
      sums.Blend = vtkTranslucencyFrame::Blending::AddAndAttenuate;
      sums.Clear = { { 0, 0, 0, 1 } };
    }
    else // the product by itself: where all channels are added a software rasterizer takes less time
    {
      sums.Differing[1] = { vtkTranslucencyFrame::Blending::Attenuate, { { 1, 1, 1, 1 } } };
    }
    sums.Values = { { "weightNear", static_cast<float>(this->DepthNear) },
      { "weightFar", static_cast<float>(this->DepthFar) } };
  }
  return frame.UseTargets(this->Sums, formats) && frame.Draw(gathering, sums) &&
    frame.Composite("Weighted/Resolve.glsl", method, inputs);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkWeightedTransparencyPass::GetTechniqueBytes()
{
  return this->Sums.GetBytes();
}

//------------------------------------------------------------------------------
void vtkWeightedTransparencyPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Sums.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
