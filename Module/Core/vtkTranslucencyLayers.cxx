// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyLayers.h"

#include "vtkTranslucencyQuery.h"
#include "vtkTranslucencyShaderWatch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Lets fragments of one number through, and puts the stencil test back as it was.
class ScopedStencil
{
public:
  ScopedStencil(vtkOpenGLState* state, int layer)
    : State(state)
    , Enabled(state->GetEnumState(GL_STENCIL_TEST))
  {
    for (std::size_t i = 0; i < Sides.size(); ++i)
    {
      Side& side = this->Found[i];
      const bool back = Sides[i] == GL_BACK;
      glGetIntegerv(back ? GL_STENCIL_BACK_FUNC : GL_STENCIL_FUNC, &side.Function);
      glGetIntegerv(back ? GL_STENCIL_BACK_REF : GL_STENCIL_REF, &side.Reference);
      glGetIntegerv(back ? GL_STENCIL_BACK_VALUE_MASK : GL_STENCIL_VALUE_MASK, &side.Mask);
      glGetIntegerv(back ? GL_STENCIL_BACK_WRITEMASK : GL_STENCIL_WRITEMASK, &side.WriteMask);
      glGetIntegerv(back ? GL_STENCIL_BACK_FAIL : GL_STENCIL_FAIL, &side.Fail);
      glGetIntegerv(back ? GL_STENCIL_BACK_PASS_DEPTH_FAIL : GL_STENCIL_PASS_DEPTH_FAIL, &side.DepthFail);
      glGetIntegerv(back ? GL_STENCIL_BACK_PASS_DEPTH_PASS : GL_STENCIL_PASS_DEPTH_PASS, &side.Pass);
    }
    constexpr GLuint all = 0xff;
    state->vtkglEnable(GL_STENCIL_TEST);
    glStencilMask(all);
    glStencilFunc(GL_EQUAL, layer, all);
    glStencilOp(GL_INCR, GL_INCR, GL_INCR);
  }
  ~ScopedStencil()
  {
    for (std::size_t i = 0; i < Sides.size(); ++i)
    {
      const Side& side = this->Found[i];
      glStencilFuncSeparate(
        Sides[i], static_cast<GLenum>(side.Function), side.Reference, static_cast<GLuint>(side.Mask));
      glStencilMaskSeparate(Sides[i], static_cast<GLuint>(side.WriteMask));
      glStencilOpSeparate(
        Sides[i], static_cast<GLenum>(side.Fail), static_cast<GLenum>(side.DepthFail), static_cast<GLenum>(side.Pass));
    }
    this->State->SetEnumState(GL_STENCIL_TEST, this->Enabled);
  }
  ScopedStencil(const ScopedStencil&) = delete;
  ScopedStencil& operator=(const ScopedStencil&) = delete;

private:
  static constexpr std::array<GLenum, 2> Sides{ { GL_FRONT, GL_BACK } };
  struct Side
  {
    GLint Function = 0;
    GLint Reference = 0;
    GLint Mask = 0;
    GLint WriteMask = 0;
    GLint Fail = 0;
    GLint DepthFail = 0;
    GLint Pass = 0;
  };

  vtkOpenGLState* State;
  bool Enabled;
  std::array<Side, 2> Found;
};
}

//------------------------------------------------------------------------------
bool vtkTranslucencyLayers::Reserve(int width, int height, int samples)
{
  if (width == this->Width && height == this->Height && samples == this->Samples)
  {
    return true;
  }
  this->Release(true);
  while (glGetError() != GL_NO_ERROR)
  {
    // an older error is not this allocation's
  }
  this->Width = width;
  this->Height = height;
  this->Samples = samples;
  const GLenum target = this->GetTarget();
  GLint bound = 0;
  glGetIntegerv(samples > 1 ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D, &bound);
  struct Image
  {
    unsigned int* Texture;
    GLenum Internal;
    GLenum Format;
    GLenum Type;
  };
  for (const Image& image : { Image{ &this->Colors, GL_RGBA32F, GL_RGBA, GL_FLOAT },
         Image{ &this->Depths, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV } })
  {
    glGenTextures(1, image.Texture);
    glBindTexture(target, *image.Texture);
    if (samples > 1)
    {
      glTexImage2DMultisample(target, samples, image.Internal, width, height, GL_TRUE);
    }
    else
    {
      glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
      glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      glTexImage2D(target, 0, static_cast<GLint>(image.Internal), width, height, 0, image.Format, image.Type, nullptr);
    }
  }
  glBindTexture(target, static_cast<GLuint>(bound));
  if (glGetError() != GL_NO_ERROR)
  {
    this->Release(true);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyLayers::Draw(
  vtkOpenGLRenderWindow* window, vtkTranslucencyShaderWatch* watch, int layer, const std::function<void()>& draw)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  if (this->Framebuffer == 0)
  {
    glGenFramebuffers(1, &this->Framebuffer);
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Colors, 0);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, this->Depths, 0);
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  // Said before each drawing: an actor whose keys no pass has set leaves depths unwritten, and blends.
  const auto prepare = [state](vtkShaderProgram*)
  {
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglEnable(GL_DEPTH_TEST); // without, no depth is written
    state->vtkglDisable(GL_BLEND);
  };
  prepare(nullptr);
  bool any = false;
  {
    const vtkOpenGLState::ScopedglDepthFunc function(state);
    state->vtkglDepthFunc(GL_ALWAYS);
    const ScopedStencil stencil(state, layer);
    constexpr std::array<float, 4> none{ { 0, 0, 0, 0 } };
    glClearBufferfv(GL_COLOR, 0, none.data());
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1, 0);
    const vtkTranslucencyShaderWatch::Scope scope(watch, state, prepare);
    any = vtkTranslucencyAnySamplesPass(draw);
  }
  state->PopFramebufferBindings();
  return any;
}

//------------------------------------------------------------------------------
unsigned int vtkTranslucencyLayers::GetTarget() const
{
  return this->Samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyLayers::GetBytes() const
{
  constexpr vtkTypeInt64 bytesOfSample = 16 + 8;
  return bytesOfSample * this->Width * this->Height * this->Samples;
}

//------------------------------------------------------------------------------
void vtkTranslucencyLayers::Release(bool contextAlive)
{
  if (contextAlive && this->Framebuffer != 0)
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  for (unsigned int* texture : { &this->Colors, &this->Depths })
  {
    if (contextAlive && *texture != 0)
    {
      glDeleteTextures(1, texture);
    }
    *texture = 0;
  }
  this->Framebuffer = 0;
  this->Width = 0;
  this->Height = 0;
  this->Samples = 0;
}
VTK_ABI_NAMESPACE_END
