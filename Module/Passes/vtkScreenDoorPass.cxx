// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScreenDoorPass.h"

#include "vtkScreenDoorMask.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkScreenDoorPass);

namespace
{
const char* const Masks[] = { "Ordered4x4", "Ordered8x8", "BlueNoise" };
constexpr int Sizes[] = { 4, 8, 64 };
const char* const Offsets[] = { "NO_OFFSET", "OBJECT_OFFSET", "PRIMITIVE_OFFSET" };
}

//------------------------------------------------------------------------------
vtkScreenDoorPass::~vtkScreenDoorPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkScreenDoorPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mask: " << Masks[this->Mask] << "\n";
  os << indent << "Offset: " << Offsets[this->Offset] << "\n";
}

//------------------------------------------------------------------------------
void vtkScreenDoorPass::SetMask(int mask)
{
  vtkTranslucencyOption::SetProperty(this, vtkScreenDoorPass::GetOptions(), "Mask", this->Mask, mask);
}

//------------------------------------------------------------------------------
void vtkScreenDoorPass::SetOffset(int offset)
{
  vtkTranslucencyOption::SetProperty(this, vtkScreenDoorPass::GetOptions(), "Offset", this->Offset, offset);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkScreenDoorPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "Mask", "mask", Kind::Choice, BlueNoise, 0, 2, { "ordered-4x4", "ordered-8x8", "blue-noise" },
             "thresholds: regular patterns of 16 or 64 pixels, or 4096 without a pattern",
             [this] { return this->GetMask(); }, [this](double value) { this->SetMask(static_cast<int>(value)); } },
    { "Offset", "offset", Kind::Choice, ObjectOffset, 0, 2, { "none", "object", "primitive" },
      "what has its holes in places of its own: nothing, each object's front and back faces, or each primitive",
      [this] { return this->GetOffset(); }, [this](double value) { this->SetOffset(static_cast<int>(value)); } } };
}

//------------------------------------------------------------------------------
bool vtkScreenDoorPass::RenderStages(vtkTranslucencyFrame& frame)
{
  const int size = Sizes[this->Mask];
  if (this->MadeMask != this->Mask)
  {
    this->MadeRanks =
      this->Mask == BlueNoise ? vtkScreenDoorMask::MakeBlueNoise(size) : vtkScreenDoorMask::MakeOrdered(size);
    this->MadeMask = this->Mask;
  }
  vtkTranslucencyFrame::Stage nearest;
  for (vtkProp* prop : frame.GetProps())
  {
    nearest.Parts.push_back({ prop, static_cast<int>(nearest.Parts.size()) });
  }
  nearest.Targets = &this->Nearest;
  nearest.Blend = vtkTranslucencyFrame::Blending::Replace;
  nearest.HidesBehind = true;
  nearest.Values = { { "maskSize", size } };
  nearest.Inputs = { { "maskRanks", &this->Ranks, 0 } };
  const std::vector<vtkTranslucencyFrame::Input> inputs{ { "screenDoorNearest", &this->Nearest, 0 } };
  return frame.UseTargets(this->Nearest, { 4 }) && frame.UseTable(this->Ranks, size, this->MadeRanks) &&
    frame.Draw({ "ScreenDoor/Gather.glsl", { { "MASK_OFFSET", Offsets[this->Offset] } }, 1 }, nearest) &&
    frame.Composite("ScreenDoor/Resolve.glsl", {}, inputs);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkScreenDoorPass::GetTechniqueBytes()
{
  return this->Nearest.GetBytes() + this->Ranks.GetBytes();
}

//------------------------------------------------------------------------------
void vtkScreenDoorPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Nearest.Release(contextAlive);
  this->Ranks.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
