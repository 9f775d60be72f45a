// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyDropInPass.h"

#include "vtkTranslucencyDrawing.h"
#include "vtkTranslucencyPass.h"

#include "vtkObjectFactory.h"
#include "vtkRenderState.h"

vtkStandardNewMacro(vtkTranslucencyDropInPass);

//------------------------------------------------------------------------------
void vtkTranslucencyDropInPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique:\n";
  this->Technique->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkTranslucencyDropInPass::Render(const vtkRenderState* state)
{
  auto* own = vtkTranslucencyPass::SafeDownCast(this->Technique);
  auto* peeling = vtkDepthPeelingPass::SafeDownCast(this->Technique);
  auto* dual = vtkDualDepthPeelingPass::SafeDownCast(this->Technique);
  if (own)
  {
    own->SetTranslucentPass(this->TranslucentPass);
    own->SetVolumetricPass(this->VolumetricPass);
  }
  if (peeling)
  {
    peeling->SetTranslucentPass(this->TranslucentPass);
  }
  if (dual)
  {
    dual->SetVolumetricPass(this->VolumetricPass);
  }
  const vtkTranslucencyDrawing drawing;
  this->Technique->Render(state);
  this->NumberOfRenderedProps = this->Technique->GetNumberOfRenderedProps();
  if (this->VolumetricPass && !own && !dual) // techniques that know no volumes; the renderer leaves them to this pass
  {
    this->VolumetricPass->Render(state);
    this->NumberOfRenderedProps += this->VolumetricPass->GetNumberOfRenderedProps();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyDropInPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Technique->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
