// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdditiveTransparencyPass.h"

#include "vtkTranslucencyFrame.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkAdditiveTransparencyPass);

//------------------------------------------------------------------------------
vtkAdditiveTransparencyPass::~vtkAdditiveTransparencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
bool vtkAdditiveTransparencyPass::RenderStages(vtkTranslucencyFrame& frame)
{
  vtkTranslucencyFrame::Stage sum;
  sum.Targets = &this->Sum;
  const std::vector<vtkTranslucencyFrame::Input> inputs{ { "additiveSum", &this->Sum, 0 } };
  return frame.UseTargets(this->Sum, { 4 }) && frame.Draw({ "Additive/Gather.glsl", {}, 1 }, sum) &&
    frame.Composite("Additive/Resolve.glsl", {}, inputs);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkAdditiveTransparencyPass::GetTechniqueBytes()
{
  return this->Sum.GetBytes();
}

//------------------------------------------------------------------------------
void vtkAdditiveTransparencyPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Sum.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
