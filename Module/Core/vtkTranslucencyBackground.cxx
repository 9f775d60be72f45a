// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyBackground.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyMaterial.h"
#include "vtkTranslucencyMedia.h"
#include "vtkTranslucencyOpaqueDepth.h"
#include "vtkTranslucencyScopedTextures.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Vector = vtkTranslucencyShader::Vector;

GLint QueryColor(GLuint framebuffer, GLenum what)
{
  GLint value = 0;
  const GLenum attachment = framebuffer ? GL_COLOR_ATTACHMENT0 : GL_BACK_LEFT;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
  return value;
}

// Samples are resolved to a picture of their own format only.
GLenum FindFormat(GLuint framebuffer)
{
  const GLint bits = QueryColor(framebuffer, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE);
  if (QueryColor(framebuffer, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return bits > 16 ? GL_RGBA32F : GL_RGBA16F;
  }
  const bool srgb = QueryColor(framebuffer, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_SRGB;
  return srgb ? GL_SRGB8_ALPHA8 : bits > 8 ? GL_RGBA16 : GL_RGBA8;
}

// What pixels are in eye coordinates, for Gather.glsl.
vtkTranslucencyShader::Uniforms GetView(vtkTranslucencyFrame& frame)
{
  vtkRenderer* renderer = frame.GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* projection = camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  const std::array<int, 4>& picture = frame.GetPicture();
  const Vector scale{ { static_cast<float>(picture[2] * projection->GetElement(0, 0) / 2),
    static_cast<float>(picture[3] * projection->GetElement(1, 1) / 2), camera->GetParallelProjection() ? 1.0f : 0.0f,
    0 } };
  const double* range = camera->GetClippingRange();
  const Vector distances{ { static_cast<float>(range[0]), static_cast<float>(range[1]), 0, 0 } };
  return { { "backgroundScale", scale }, { "backgroundRange", distances } };
}
}

//------------------------------------------------------------------------------
vtkTranslucencyShader::Uniforms vtkTranslucencyBackground::GetUniforms(vtkProp* prop)
{
  Vector bend{ { 1, 0, 0, 0 } };
  if (vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(prop))
  {
    const double numbers[] = { material->GetIndexOfRefraction(), material->GetThickness(), material->GetDiffusion(),
      material->GetDispersion() };
    std::copy_n(numbers, 4, bend.begin());
  }
  return { { "gatherBend", bend }, { "gatherEntry", vtkTranslucencyMedia::IsMirrored(prop) ? -1.0f : 1.0f } };
}

//------------------------------------------------------------------------------
bool vtkTranslucencyBackground::Change(vtkTranslucencyFrame& frame, vtkTranslucencyOpaqueDepth& opaque)
{
  if (this->Changed)
  {
    return true;
  }
  vtkTranslucencyFrame::Stage bends;
  bool blurs = false;
  for (vtkProp* prop : frame.GetProps())
  {
    vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(prop);
    if (material && material->ChangesBackground())
    {
      bends.Parts.push_back({ prop, 0 });
      blurs = blurs || material->GetDiffusion() > 0;
    }
  }
  if (bends.Parts.empty())
  {
    return true;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(frame.GetRenderer()->GetRenderWindow());
  bends.Targets = &this->Bends;
  bends.Differing[1] = { vtkTranslucencyFrame::Blending::Minimum, { { 1, 1, 1, 1 } } };
  bends.Values = GetView(frame);
  vtkTranslucencyFrame::Gathering gathering{ "Background/Gather.glsl", {}, 2 };
  gathering.Normals = true;
  if (!frame.UseTargets(this->Bends, { 4, 4 }) || !frame.Draw(gathering, bends))
  {
    return false;
  }
  const std::array<int, 4>& viewport = frame.GetViewport();
  if (!this->Copy(window, viewport, blurs))
  {
    return frame.Fail("the opaque picture can't be copied");
  }
  const bool copied = opaque.Use();
  vtkTranslucencyScopedTextures textures(window);
  textures.Bind("backgroundPicture", GL_TEXTURE_2D, this->Picture);
  vtkTranslucencyFrame::Stage change;
  change.Blend = vtkTranslucencyFrame::Blending::Replace;
  change.Inputs = { { "backgroundBend", &this->Bends, 0 }, { "backgroundDepth", &this->Bends, 1 } };
  change.Values = textures.GetUnits();
  Vector rectangle;
  std::copy(viewport.begin(), viewport.end(), rectangle.begin());
  change.Values["backgroundViewport"] = rectangle;
  change.Values["translucencyOpaqueDepth"] = opaque.GetUnit();
  const bool changed =
    copied ? frame.DrawScreen("Background/Change.glsl", {}, change) : frame.Fail("the depth buffer can't be copied");
  opaque.Deactivate();
  this->Changed = changed;
  return changed;
}

//------------------------------------------------------------------------------
// Copies what is bound within a viewport, with smaller levels if asked for.
bool vtkTranslucencyBackground::Copy(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport, bool levels)
{
  vtkOpenGLState* state = window->GetState();
  const GLuint drawn = vtkTranslucencyGLState::GetDrawFramebuffer();
  const GLenum format = FindFormat(drawn);
  while (glGetError() != GL_NO_ERROR)
  {
    // an older error is not this copy's
  }
  vtkTranslucencyScopedTextures textures(window);
  if (format != this->Format || viewport[2] != this->Size[0] || viewport[3] != this->Size[1])
  {
    this->ReleasePicture(true);
    glGenTextures(1, &this->Picture);
    glGenFramebuffers(1, &this->Framebuffer);
    this->Format = format;
    this->Size = { { viewport[2], viewport[3] } };
    textures.Bind("", GL_TEXTURE_2D, this->Picture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), viewport[2], viewport[3], 0, GL_RGBA, GL_FLOAT, nullptr);
  }
  else
  {
    textures.Bind("", GL_TEXTURE_2D, this->Picture);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, levels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  state->vtkglReadBuffer(drawn ? GL_COLOR_ATTACHMENT0 : GL_BACK_LEFT);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Picture, 0);
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(viewport[0], viewport[1], viewport[0] + viewport[2], viewport[1] + viewport[3], 0, 0, viewport[2],
    viewport[3], GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glEnable(GL_SCISSOR_TEST);
  state->PopFramebufferBindings();
  if (levels)
  {
    glGenerateMipmap(GL_TEXTURE_2D);
  }
  return glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyBackground::GetBytes() const
{
  const vtkTypeInt64 bytes = this->Format == GL_RGBA32F       ? 16
    : this->Format == GL_RGBA16F || this->Format == GL_RGBA16 ? 8
                                                              : 4;
  return this->Bends.GetBytes() + bytes * this->Size[0] * this->Size[1] * 4 / 3; // with all levels
}

//------------------------------------------------------------------------------
void vtkTranslucencyBackground::Release(bool contextAlive)
{
  this->Bends.Release(contextAlive);
  this->ReleasePicture(contextAlive);
}

//------------------------------------------------------------------------------
void vtkTranslucencyBackground::ReleasePicture(bool contextAlive)
{
  if (contextAlive && this->Picture != 0)
  {
    glDeleteTextures(1, &this->Picture);
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  this->Picture = 0;
  this->Framebuffer = 0;
  this->Format = 0;
  this->Size = { { 0, 0 } };
}
VTK_ABI_NAMESPACE_END
