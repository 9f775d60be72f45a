// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL before and after a pass has drawn.
 */
#ifndef WatchedPass_h
#define WatchedPass_h

#include "GLState.h"

#include <vtkObjectFactory.h>
#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>
#include <vtkTranslucencyPass.h>

#include <string>
#include <vector>

/// Renders another pass and looks at OpenGL before and after.
class WatchedPass : public vtkRenderPass
{
public:
  static WatchedPass* New() { VTK_STANDARD_NEW_BODY(WatchedPass); }
  vtkTypeMacro(WatchedPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    this->ErrorsBefore = TakeGLErrors();
    this->Before = QueryGLState();
    this->Pass->Render(state);
    this->ErrorsAfter = TakeGLErrors();
    this->After = QueryGLState();
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override { this->Pass->ReleaseGraphicsResources(window); }

  vtkSmartPointer<vtkTranslucencyPass> Pass;
  GLState Before;
  GLState After;
  std::vector<std::string> ErrorsBefore;
  std::vector<std::string> ErrorsAfter;
};

#endif
