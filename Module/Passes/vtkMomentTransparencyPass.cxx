// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMomentTransparencyPass.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkMomentTransparencyPass);

//------------------------------------------------------------------------------
vtkMomentTransparencyPass::vtkMomentTransparencyPass()
  : vtkAbsorbancePass(
      { { "Moments", "moments", vtkTranslucencyOption::Kind::Choice, Power6, 0, Trigonometric4,
          { "power-4", "power-6", "power-8", "trigonometric-2", "trigonometric-3", "trigonometric-4" },
          "which moments of absorbance are summed; more tell more layers apart and take memory and time", {}, {} },
        "Moment", "MOMENT_BASIS" })
{
}

//------------------------------------------------------------------------------
void vtkMomentTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Overestimation: " << this->Overestimation << "\n";
}

//------------------------------------------------------------------------------
void vtkMomentTransparencyPass::SetOverestimation(double overestimation)
{
  vtkTranslucencyOption::SetProperty(
    this, { this->GetOverestimationOption() }, "Overestimation", this->Overestimation, overestimation);
}

//------------------------------------------------------------------------------
vtkTranslucencyOption vtkMomentTransparencyPass::GetOverestimationOption()
{
  return { "Overestimation", "overestimation", vtkTranslucencyOption::Kind::Real, 0.25, 0, 1, {},
    "what is taken for the truth between the least (0) and the most (1) that can hide a fragment",
    [this] { return this->GetOverestimation(); }, [this](double value) { this->SetOverestimation(value); } };
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkMomentTransparencyPass::GetOptions()
{
  std::vector<vtkTranslucencyOption> options = this->Superclass::GetOptions();
  options.insert(options.begin() + 1, this->GetOverestimationOption());
  return options;
}

//------------------------------------------------------------------------------
int vtkMomentTransparencyPass::GetTermCount() const
{
  return this->Number < Trigonometric2 ? 5 + 2 * this->Number : 5 + 2 * (this->Number - Trigonometric2);
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Uniforms vtkMomentTransparencyPass::GetValues(const vtkTranslucencyFrame& frame) const
{
  vtkTranslucencyFrame::Uniforms values = this->Superclass::GetValues(frame);
  values["overestimation"] = static_cast<float>(this->Overestimation);
  return values;
}
VTK_ABI_NAMESPACE_END
