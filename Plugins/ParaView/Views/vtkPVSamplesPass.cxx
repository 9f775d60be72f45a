// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVSamplesPass.h"

#include "vtkTranslucencyVTKVersion.h" // OpenGL's functions

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVSamplesPass);

//------------------------------------------------------------------------------
void vtkPVSamplesPass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->NumberOfRenderedProps = 0;
  if (!this->Delegate || !window)
  {
    return;
  }
  if (this->Samples <= 1 || renderer->GetSelector())
  {
    this->Delegate->Render(state);
    this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
    return;
  }

  vtkOpenGLState* gl = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable scissor(gl, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglEnableDisable multisample(gl, GL_MULTISAMPLE);
  const bool scissored = gl->GetEnumState(GL_SCISSOR_TEST);
  GLint area[4];
  gl->vtkglGetIntegerv(GL_VIEWPORT, area);
  const GLuint bound = vtkPVFramebuffer::GetBound();
  const GLuint own = this->Allocate(window, area[0] + area[2], area[1] + area[3]);
  constexpr GLbitfield both = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  gl->PushFramebufferBindings();
  gl->vtkglDisable(GL_SCISSOR_TEST);
  vtkPVFramebuffer::Copy(gl, bound, own, area, both);
  gl->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, own);
  gl->SetEnumState(GL_SCISSOR_TEST, scissored);
  gl->vtkglEnable(GL_MULTISAMPLE);

  this->Delegate->Render(state);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();

  gl->vtkglDisable(GL_SCISSOR_TEST);
  vtkPVFramebuffer::Copy(gl, own, bound, area, both);
  gl->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
unsigned int vtkPVSamplesPass::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const int samples = std::min(this->Samples, most);
  if (samples < this->Samples && !this->Warned)
  {
    this->Warned = true;
    vtkWarningMacro("the driver has at most " << samples << " samples per pixel: TranslucencySamples " << this->Samples
                                              << " is drawn with these");
  }
  this->Framebuffer.Allocate(window, width, height, samples, vtkPVFramebuffer::GetBoundColorFormat());
  return this->Framebuffer.GetName();
}

//------------------------------------------------------------------------------
void vtkPVSamplesPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer.Free();
  if (this->Delegate)
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }
}
