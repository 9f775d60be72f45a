// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyOpaqueDepth.h"

#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkTranslucencyOpaqueDepth::BeginFrame(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport)
{
  this->Window = window;
  this->Viewport = viewport;
  this->Captured = false;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyOpaqueDepth::Capture()
{
  vtkOpenGLState* state = this->Window->GetState();
  const auto& from = this->Viewport;
  const int width = from[0] + from[2];
  const int height = from[1] + from[3];
  const unsigned int drawn = vtkTranslucencyGLState::GetDrawFramebuffer();
  this->Reserve(width, height, drawn);

  state->PushFramebufferBindings();
  this->Framebuffer->Bind(GL_FRAMEBUFFER);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  // Up to OpenGL 4.0 a framebuffer is incomplete that lacks a colour which it is to draw or read.
  state->vtkglDrawBuffer(GL_NONE);
  state->vtkglReadBuffer(GL_NONE);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  while (glGetError() != GL_NO_ERROR)
  {
    // an older error is not this copy's
  }
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(from[0], from[1], width, height, from[0], from[1], width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glEnable(GL_SCISSOR_TEST);
  const bool copied = glGetError() == GL_NO_ERROR;
  state->PopFramebufferBindings();
  this->Activate();
  this->Depth->SendParameters();
  this->Captured = true;
  return copied;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyOpaqueDepth::Use()
{
  if (!this->Captured)
  {
    return this->Capture();
  }
  this->Activate();
  return true;
}

//------------------------------------------------------------------------------
// Makes room for the copy: a depth buffer can be copied to one of its own format only.
void vtkTranslucencyOpaqueDepth::Reserve(int width, int height, unsigned int framebuffer)
{
  if (!this->Depth)
  {
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth->SetContext(this->Window);
    this->Depth->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Depth->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(this->Window);
  }
  const auto query = [](GLenum name, GLenum attachment)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  const GLenum depth = framebuffer ? GL_DEPTH_ATTACHMENT : GL_DEPTH;
  const GLint bits = query(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, depth);
  if (static_cast<int>(this->Depth->GetWidth()) == width && static_cast<int>(this->Depth->GetHeight()) == height &&
    bits == this->Bits)
  {
    return;
  }
  this->Bits = bits;
  const GLint type = query(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, depth);
  const bool stencil =
    query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, framebuffer ? GL_STENCIL_ATTACHMENT : GL_STENCIL) != GL_NONE;
  // VTK makes textures in the next free unit, and leaves them bound there.
  vtkTextureUnitManager* units = this->Window->GetTextureUnitManager();
  const int unit = units->Allocate();
  units->Free(unit);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + unit));
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  if (stencil)
  {
    this->Depth->AllocateDepthStencil(width, height);
  }
  else
  {
    this->Depth->AllocateDepth(width, height,
      type == GL_FLOAT ? vtkTextureObject::Float32
        : bits == 32   ? vtkTextureObject::Fixed32
        : bits == 24   ? vtkTextureObject::Fixed24
                       : vtkTextureObject::Fixed16);
  }
  this->Depth->Deactivate();
  state->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
}

//------------------------------------------------------------------------------
void vtkTranslucencyOpaqueDepth::Activate()
{
  this->Unit = this->Window->GetTextureUnitManager()->Allocate();
  this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + this->Unit));
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &this->UnitBefore);
  glBindTexture(GL_TEXTURE_2D, this->Depth->GetHandle());
}

//------------------------------------------------------------------------------
void vtkTranslucencyOpaqueDepth::Deactivate()
{
  this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + this->Unit));
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(this->UnitBefore));
  this->Window->GetTextureUnitManager()->Free(this->Unit);
}

//------------------------------------------------------------------------------
void vtkTranslucencyOpaqueDepth::Release()
{
  this->Depth = nullptr;
  this->Framebuffer = nullptr;
}
VTK_ABI_NAMESPACE_END
