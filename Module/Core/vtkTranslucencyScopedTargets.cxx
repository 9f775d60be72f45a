// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyScopedTargets.h"

#include "vtkTranslucencyBlending.h"
#include "vtkTranslucencyTargets.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTranslucencyScopedTargets::vtkTranslucencyScopedTargets(
  vtkOpenGLRenderWindow* window, const vtkTranslucencyStage& stage)
  : Drawn(stage)
{
  if (!stage.Targets)
  {
    return;
  }
  this->Obstacle = stage.Targets->Bind(window, stage.HidesBehind);
  if (this->Obstacle.empty() && stage.Cleared > 0)
  {
    window->GetState()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    stage.Targets->Clear(stage.Clear, stage.Cleared);
    for (const auto& differing : stage.Differing)
    {
      stage.Targets->Clear(differing.first, differing.second.Clear);
    }
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyScopedTargets::~vtkTranslucencyScopedTargets()
{
  if (!this->Drawn.Targets || !this->Obstacle.empty())
  {
    return;
  }
  if (!this->Drawn.Differing.empty())
  {
    vtkTranslucencyBlending::UseOneFunction();
  }
  this->Drawn.Targets->Unbind();
}
VTK_ABI_NAMESPACE_END
