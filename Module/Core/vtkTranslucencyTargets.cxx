// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyTargets.h"

#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// What a format is to OpenGL.
struct Texels
{
  GLenum Internal;
  GLenum Pixels;
  GLenum Type;
  int Components;
  int Bytes = 4; // of a component
};

Texels GetTexels(vtkTranslucencyTargets::Format format)
{
  using Format = vtkTranslucencyTargets::Format;
  switch (format)
  {
    case Format::Float1:
      return { GL_R32F, GL_RED, GL_FLOAT, 1 };
    case Format::Float2:
      return { GL_RG32F, GL_RG, GL_FLOAT, 2 };
    case Format::Half1:
      return { GL_R16F, GL_RED, GL_FLOAT, 1, 2 };
    case Format::Half2:
      return { GL_RG16F, GL_RG, GL_FLOAT, 2, 2 };
    case Format::Half4:
      return { GL_RGBA16F, GL_RGBA, GL_FLOAT, 4, 2 };
    case Format::Word1:
      return { GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1 };
    case Format::Word2:
      return { GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 2 };
    case Format::Word4:
      return { GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4 };
    default:
      return { GL_RGBA32F, GL_RGBA, GL_FLOAT, 4 };
  }
}

GLint DepthAttachment(unsigned int framebuffer, GLenum what)
{
  GLint value = 0;
  // The window system's framebuffer, 0, has a depth buffer that can't be shared.
  if (framebuffer != 0)
  {
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, what, &value);
  }
  return value;
}

// A depth buffer can be copied to one of its own format only.
GLenum FindDepthFormat(GLenum type, GLuint depth, GLint level, bool several)
{
  GLint format = 0;
  GLint bound = 0;
  if (type == GL_TEXTURE)
  {
    const GLenum target = several ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    glGetIntegerv(several ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D, &bound);
    glBindTexture(target, depth);
    glGetTexLevelParameteriv(target, level, GL_TEXTURE_INTERNAL_FORMAT, &format);
    glBindTexture(target, static_cast<GLuint>(bound));
  }
  else
  {
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  }
  return static_cast<GLenum>(format);
}
}

//------------------------------------------------------------------------------
vtkTranslucencyTargets::Format vtkTranslucencyTargets::Floats(int count)
{
  return count == 1 ? Format::Float1 : count == 2 ? Format::Float2 : Format::Float4;
}

//------------------------------------------------------------------------------
vtkTranslucencyTargets::Format vtkTranslucencyTargets::Halves(int count)
{
  return count == 1 ? Format::Half1 : count == 2 ? Format::Half2 : Format::Half4;
}

//------------------------------------------------------------------------------
vtkTranslucencyTargets::Format vtkTranslucencyTargets::Words(int count)
{
  return count == 1 ? Format::Word1 : count == 2 ? Format::Word2 : Format::Word4;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyTargets::Reserve(int width, int height, int samples, const std::vector<Format>& formats)
{
  if (width == this->Width && height == this->Height && samples == this->Samples && formats == this->Formats)
  {
    return true;
  }
  this->Release();
  while (glGetError() != GL_NO_ERROR)
  {
    // an older error is not this allocation's
  }
  this->Width = width;
  this->Height = height;
  this->Samples = samples;
  this->Formats = formats;
  this->Textures.resize(formats.size());
  const GLenum target = this->GetTarget();
  GLint bound = 0;
  glGetIntegerv(samples > 1 ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D, &bound);
  glGenTextures(static_cast<GLsizei>(formats.size()), this->Textures.data());
  for (std::size_t i = 0; i < formats.size(); ++i)
  {
    const Texels texels = GetTexels(formats[i]);
    glBindTexture(target, this->Textures[i]);
    if (samples > 1)
    {
      glTexImage2DMultisample(target, samples, texels.Internal, width, height, GL_TRUE);
    }
    else
    {
      glTexParameteri(
        target, GL_TEXTURE_MAX_LEVEL, 0); // before it gets memory, or drivers may take that of smaller levels, too
      glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      glTexImage2D(
        target, 0, static_cast<GLint>(texels.Internal), width, height, 0, texels.Pixels, texels.Type, nullptr);
    }
  }
  glBindTexture(target, static_cast<GLuint>(bound));
  if (glGetError() != GL_NO_ERROR)
  {
    this->Release();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTranslucencyTargets::ReserveDepth(unsigned int format)
{
  if (this->Depth != 0 && this->DepthFormat == format)
  {
    return;
  }
  if (this->Depth == 0)
  {
    glGenRenderbuffers(1, &this->Depth);
  }
  this->DepthFormat = format;
  GLint bound = 0;
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
  glBindRenderbuffer(GL_RENDERBUFFER, this->Depth);
  glRenderbufferStorageMultisample(
    GL_RENDERBUFFER, this->Samples > 1 ? this->Samples : 0, format, this->Width, this->Height);
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyTargets::Bind(vtkOpenGLRenderWindow* window, bool copyDepth)
{
  const unsigned int found = vtkTranslucencyGLState::GetDrawFramebuffer();
  const GLint type = DepthAttachment(found, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  const auto depth =
    static_cast<GLuint>(type == GL_NONE ? 0 : DepthAttachment(found, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  if (depth == 0)
  {
    return "the framebuffer has no depth buffer that can be shared, expected a framebuffer object with one";
  }
  const GLint level = type == GL_TEXTURE ? DepthAttachment(found, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL) : 0;

  this->Window = window;
  window->GetState()->PushFramebufferBindings();
  const bool fresh = this->Framebuffer == 0;
  if (fresh)
  {
    glGenFramebuffers(1, &this->Framebuffer);
  }
  window->GetState()->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  if (fresh)
  {
    std::vector<GLenum> buffers;
    for (std::size_t i = 0; i < this->Textures.size(); ++i)
    {
      buffers.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i));
      glFramebufferTexture(GL_DRAW_FRAMEBUFFER, buffers.back(), this->Textures[i], 0);
    }
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  }
  if (copyDepth)
  {
    this->ReserveDepth(FindDepthFormat(static_cast<GLenum>(type), depth, level, this->Samples > 1));
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, this->Depth);
  }
  else if (type == GL_TEXTURE)
  {
    glFramebufferTexture(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth, level);
  }
  else
  {
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  }
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->Unbind();
    return "the driver can't draw to colours of 32-bit numbers with the window's depth buffer";
  }
  if (copyDepth)
  {
    window->GetState()->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, found);
    glBlitFramebuffer(
      0, 0, this->Width, this->Height, 0, 0, this->Width, this->Height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  }
  return "";
}

//------------------------------------------------------------------------------
void vtkTranslucencyTargets::Clear(const std::array<float, 4>& value, int count)
{
  for (int i = 0; i < std::min(count, this->GetCount()); ++i)
  {
    this->Clear(i, value);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyTargets::Clear(int index, const std::array<float, 4>& value)
{
  if (GetTexels(this->Formats[index]).Type == GL_FLOAT)
  {
    glClearBufferfv(GL_COLOR, index, value.data());
    return;
  }
  GLuint words[4];
  std::memcpy(words, value.data(), sizeof(words));
  glClearBufferuiv(GL_COLOR, index, words);
}

//------------------------------------------------------------------------------
std::vector<float> vtkTranslucencyTargets::Read(
  int index, const std::array<int, 4>& rectangle, vtkOpenGLRenderWindow* window) const
{
  const auto attachment = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + index);
  const int right = rectangle[0] + rectangle[2];
  const int top = rectangle[1] + rectangle[3];
  while (glGetError() != GL_NO_ERROR)
  {
    // an older error is not this copy's
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer);
  state->vtkglReadBuffer(attachment);
  vtkTranslucencyTargets means;
  if (this->Samples > 1 && means.Reserve(this->Width, this->Height, 1, { this->Formats[index] }))
  {
    // Samples can't be read, but a copy makes them their mean.
    glGenFramebuffers(1, &means.Framebuffer);
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, means.Framebuffer);
    glFramebufferTexture(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, means.Textures[0], 0);
    glBlitFramebuffer(
      rectangle[0], rectangle[1], right, top, rectangle[0], rectangle[1], right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, means.Framebuffer);
  }
  std::vector<float> values(4 * static_cast<std::size_t>(rectangle[2]) * rectangle[3]);
  glReadPixels(rectangle[0], rectangle[1], rectangle[2], rectangle[3], GL_RGBA, GL_FLOAT, values.data());
  state->PopFramebufferBindings();
  means.Release();
  if (glGetError() != GL_NO_ERROR)
  {
    values.clear();
  }
  return values;
}

//------------------------------------------------------------------------------
void vtkTranslucencyTargets::Write(const std::vector<unsigned int>& words)
{
  GLint bound = 0;
  GLint unpacked = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &unpacked);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, this->Textures.front());
  const Texels texels = GetTexels(this->Formats.front());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, this->Width, this->Height, texels.Pixels, texels.Type, words.data());
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(unpacked));
}

//------------------------------------------------------------------------------
void vtkTranslucencyTargets::Unbind()
{
  // Whoever owns the depth buffer may delete or resize it before the next frame.
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 0);
  this->Window->GetState()->PopFramebufferBindings();
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
unsigned int vtkTranslucencyTargets::GetTarget() const
{
  return this->Samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyTargets::GetBytes() const
{
  constexpr vtkTypeInt64 bytesOfDepth = 4;
  vtkTypeInt64 bytes = this->Depth != 0 ? bytesOfDepth : 0;
  for (Format format : this->Formats)
  {
    const Texels texels = GetTexels(format);
    bytes += texels.Components * texels.Bytes;
  }
  return bytes * this->Width * this->Height * this->Samples;
}

//------------------------------------------------------------------------------
void vtkTranslucencyTargets::Release(bool contextAlive)
{
  if (contextAlive && !this->Textures.empty())
  {
    glDeleteTextures(static_cast<GLsizei>(this->Textures.size()), this->Textures.data());
  }
  if (contextAlive && this->Framebuffer != 0)
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  if (contextAlive && this->Depth != 0)
  {
    glDeleteRenderbuffers(1, &this->Depth);
  }
  this->Depth = 0;
  this->DepthFormat = 0;
  this->Framebuffer = 0;
  this->Textures.clear();
  this->Formats.clear();
  this->Width = 0;
  this->Height = 0;
  this->Samples = 0;
}
VTK_ABI_NAMESPACE_END
