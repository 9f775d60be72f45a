// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVFramebuffer.h"

#include "vtkTranslucencyVTKVersion.h" // OpenGL's functions

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace
{
GLint GetAttachment(GLenum attachment, GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

GLenum GetBoundDepthFormat()
{
  const bool window = vtkPVFramebuffer::GetBound() == 0;
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
}

//------------------------------------------------------------------------------
unsigned int vtkPVFramebuffer::GetBound()
{
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return static_cast<GLuint>(bound);
}

//------------------------------------------------------------------------------
unsigned int vtkPVFramebuffer::GetBoundColorFormat()
{
  const GLenum color = GetBound() == 0 ? GL_BACK_LEFT : GL_COLOR_ATTACHMENT0;
  if (GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
  {
    return GL_RGBA8;
  }
  const bool fine = GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) > 16;
  if (GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return fine ? GL_RGBA32F : GL_RGBA16F;
  }
  return GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) > 8 ? GL_RGBA16 : GL_RGBA8;
}

//------------------------------------------------------------------------------
void vtkPVFramebuffer::Allocate(
  vtkOpenGLRenderWindow* window, int width, int height, int samples, unsigned int colorFormat)
{
  const GLenum depthFormat = GetBoundDepthFormat();
  const std::array<unsigned int, 5> layout{ { static_cast<unsigned int>(width), static_cast<unsigned int>(height),
    static_cast<unsigned int>(samples), colorFormat, depthFormat } };
  if (layout == this->Layout)
  {
    return;
  }
  this->Free();
  this->Layout = layout;
  glGenFramebuffers(1, &this->Allocated[0]);
  glGenRenderbuffers(2, &this->Allocated[1]);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Allocated[0]);
  const GLenum formats[] = { colorFormat, depthFormat };
  GLenum attachments[] = { GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT };
  if (depthFormat == GL_DEPTH24_STENCIL8 || depthFormat == GL_DEPTH32F_STENCIL8)
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
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkPVFramebuffer::Free()
{
  if (this->Allocated[0])
  {
    glDeleteFramebuffers(1, &this->Allocated[0]);
    glDeleteRenderbuffers(2, &this->Allocated[1]);
    *this = vtkPVFramebuffer();
  }
}

//------------------------------------------------------------------------------
void vtkPVFramebuffer::Copy(
  vtkOpenGLState* state, unsigned int from, unsigned int to, const int* area, unsigned int parts)
{
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  const GLint right = area[0] + area[2];
  const GLint top = area[1] + area[3];
  for (const GLbitfield part : { GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT })
  {
    if (parts & part)
    {
      glBlitFramebuffer(area[0], area[1], right, top, area[0], area[1], right, top, part, GL_NEAREST);
    }
  }
}
