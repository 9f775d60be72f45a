#include "vtkAdditiveTransparencyPass.h"

#include "vtkTranslucencyFrame.h"

#include "vtkObjectFactory.h"

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
  return frame.UseTargets(this->Sum, { 4 }) && frame.Draw({ "Additive/Gather.glsl", {}, 1 }, sum) &&
    frame.Composite("Additive/Resolve.glsl", {}, { { "additiveSum", &this->Sum, 0 } });
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
