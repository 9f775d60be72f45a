// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStockPeelingPass.h"

#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkStockPeelingPass);

//------------------------------------------------------------------------------
void vtkStockPeelingPass::Render(const vtkRenderState* state)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples > 0)
  {
    if (!this->Refused)
    {
      vtkErrorMacro(<< "VTK's depth peeling can't draw in a window of " << samples
                    << " samples a pixel, expected 0 (vtkRenderWindow::SetMultiSamples); drawing by blending, in "
                       "drawing order, instead");
    }
    this->Refused = true;
    this->NumberOfRenderedProps = 0;
    for (vtkRenderPass* pass : { this->TranslucentPass, this->VolumetricPass })
    {
      if (pass)
      {
        pass->Render(state);
        this->NumberOfRenderedProps += pass->GetNumberOfRenderedProps();
      }
    }
    return;
  }
  this->Refused = false;
  const vtkTranslucencyGLState found(window, false);
  const std::string warning = this->Guard.Render(this, state, window, [&] { this->Superclass::Render(state); });
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
}
VTK_ABI_NAMESPACE_END
