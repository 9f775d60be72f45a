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

namespace
{
GLint Get(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

GLint GetAttachment(GLenum attachment, GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

// Depths can be handed over between framebuffers of one format only: that of the one that is bound.
GLenum GetDepthFormat()
{
  const bool window = Get(GL_DRAW_FRAMEBUFFER_BINDING) == 0;
  const GLenum depth = window ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const GLenum stencil = window ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  const bool stencilled = GetAttachment(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE &&
    GetAttachment(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0;
  if (GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return stencilled ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  }
  const GLint bits = GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  if (stencilled)
  {
    return GL_DEPTH24_STENCIL8;
  }
  return bits == 16 ? GL_DEPTH_COMPONENT16 : bits == 24 ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT32;
}

void Copy(vtkOpenGLState* state, GLuint from, GLuint to, const GLint* area)
{
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  const GLint right = area[0] + area[2];
  const GLint top = area[1] + area[3];
  for (const GLbitfield part : { GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT })
  {
    glBlitFramebuffer(area[0], area[1], right, top, area[0], area[1], right, top, part, GL_NEAREST);
  }
}
}

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
  const GLuint bound = Get(GL_DRAW_FRAMEBUFFER_BINDING);
  gl->PushFramebufferBindings();

  this->Allocate(window, area[0] + area[2], area[1] + area[3]);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  Copy(gl, bound, this->Allocated[0], area);
  gl->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Allocated[0]);
  gl->SetEnumState(GL_SCISSOR_TEST, scissored);
  gl->vtkglEnable(GL_MULTISAMPLE);

  this->Delegate->Render(state);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();

  gl->vtkglDisable(GL_SCISSOR_TEST);
  Copy(gl, this->Allocated[0], bound, area);
  gl->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
// For the format of the framebuffer that is bound.
void vtkPVSamplesPass::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  const int samples = std::min(this->Samples, Get(GL_MAX_SAMPLES));
  if (samples < this->Samples && !this->Warned)
  {
    this->Warned = true;
    vtkWarningMacro("the driver has at most " << samples << " samples per pixel: TranslucencySamples " << this->Samples
                                              << " is drawn with these");
  }
  const std::array<int, 4> layout{ { width, height, samples, static_cast<int>(GetDepthFormat()) } };
  if (layout == this->Layout)
  {
    return;
  }
  this->Free();
  this->Layout = layout;
  glGenFramebuffers(1, &this->Allocated[0]);
  glGenRenderbuffers(2, &this->Allocated[1]);
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Allocated[0]);
  const GLenum depth = static_cast<GLenum>(layout[3]);
  const GLenum formats[] = { GL_RGBA8, depth };
  GLenum attachments[] = { GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT };
  if (depth == GL_DEPTH24_STENCIL8 || depth == GL_DEPTH32F_STENCIL8)
  {
    attachments[1] = GL_DEPTH_STENCIL_ATTACHMENT;
  }
  for (int i = 0; i < 2; ++i)
  {
    glBindRenderbuffer(GL_RENDERBUFFER, this->Allocated[i + 1]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, this->Allocated[i + 1]);
  }
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkPVSamplesPass::Free()
{
  if (this->Allocated[0])
  {
    glDeleteFramebuffers(1, &this->Allocated[0]);
    glDeleteRenderbuffers(2, &this->Allocated[1]);
    this->Allocated = { { 0, 0, 0 } };
    this->Layout = { { 0, 0, 0, 0 } };
  }
}

//------------------------------------------------------------------------------
void vtkPVSamplesPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Free();
  if (this->Delegate)
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }
}
