// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyGLState.h"

#include "Common/Bindings.glsl"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// What was bound may be gone: VTK makes the buffers of a prop anew, and deletes those it has, when it draws it. OpenGL
// binds 0 then.
unsigned int BufferIfThere(int name)
{
  const auto buffer = static_cast<GLuint>(name);
  return glIsBuffer(buffer) ? buffer : 0;
}
}

//------------------------------------------------------------------------------
vtkTranslucencyGLState::vtkTranslucencyGLState(vtkOpenGLRenderWindow* window, bool storage)
  : Window(window)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport.data());
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, this->Scissor.data());
  state->GetBlendFuncState(this->BlendFunction.data());
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->BlendEquation[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->BlendEquation[1]);
  state->vtkglGetBooleanv(GL_COLOR_WRITEMASK, this->ColorMask.data());
  state->vtkglGetBooleanv(GL_DEPTH_WRITEMASK, &this->DepthMask);
  state->vtkglGetFloatv(GL_COLOR_CLEAR_VALUE, this->ClearColor.data());
  glGetFloatv(GL_POINT_SIZE, &this->PointSize);
  this->ProgramPointSize = glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE;
  glGetFloatv(GL_LINE_WIDTH, &this->LineWidth);
  glGetIntegerv(GL_DEPTH_FUNC, &this->DepthFunction);
  glGetIntegerv(GL_CULL_FACE_MODE, &this->CulledFaces);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &this->ActiveTexture);
  glGetIntegerv(GL_CURRENT_PROGRAM, &this->Program);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &this->VertexArray);
  for (unsigned int capability : { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_MULTISAMPLE })
  {
    this->Enabled.emplace_back(capability, state->GetEnumState(capability));
  }

  std::vector<std::pair<unsigned int, unsigned int>> targets{ { GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING },
    { GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING }, // of the vertex array
    { GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER },                 // these two are asked for by their own names
    { GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER } };
  if (storage)
  {
    targets.emplace_back(GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING);
    targets.emplace_back(GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING);
  }
  for (const auto& target : targets)
  {
    int buffer = 0;
    glGetIntegerv(target.second, &buffer);
    this->Buffers.emplace_back(target.first, buffer);
  }
  const auto saveIndexed =
    [this](unsigned int target, unsigned int binding, unsigned int start, unsigned int size, unsigned int count)
  {
    for (unsigned int index = 0; index < count; ++index)
    {
      BufferBinding saved{ target, index, 0, 0, 0 };
      GLint64 value = 0;
      glGetIntegeri_v(binding, index, &saved.Buffer);
      glGetInteger64i_v(start, index, &value);
      saved.Start = value;
      glGetInteger64i_v(size, index, &value);
      saved.Size = value;
      this->IndexedBuffers.push_back(saved);
    }
  };
  if (storage)
  {
    saveIndexed(GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
      GL_SHADER_STORAGE_BUFFER_SIZE, STORAGE_BINDINGS);
    saveIndexed(
      GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE, UNIFORM_BINDINGS);
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyGLState::~vtkTranslucencyGLState()
{
  for (const BufferBinding& saved : this->IndexedBuffers)
  {
    const unsigned int buffer = BufferIfThere(saved.Buffer);
    if (buffer != 0 && saved.Size > 0)
    {
      glBindBufferRange(
        saved.Target, saved.Index, buffer, static_cast<GLintptr>(saved.Start), static_cast<GLsizeiptr>(saved.Size));
    }
    else
    {
      glBindBufferBase(saved.Target, saved.Index, buffer);
    }
  }
  const auto vertexArray = static_cast<GLuint>(this->VertexArray);
  glBindVertexArray(glIsVertexArray(vertexArray) ? vertexArray : 0);
  for (const auto& saved : this->Buffers)
  {
    glBindBuffer(saved.first, BufferIfThere(saved.second));
  }

  vtkOpenGLState* state = this->Window->GetState();
  for (const auto& saved : this->Enabled)
  {
    state->SetEnumState(saved.first, saved.second);
  }
  (this->ProgramPointSize ? glEnable : glDisable)(GL_PROGRAM_POINT_SIZE); // the cache doesn't know it
  // The cache must forget its program before ours is put back behind its back.
  this->Window->GetShaderCache()->ReleaseCurrentShader();
  const auto program = static_cast<GLuint>(this->Program);
  glUseProgram(glIsProgram(program) ? program : 0);
  state->vtkglClearColor(this->ClearColor[0], this->ClearColor[1], this->ClearColor[2], this->ClearColor[3]);
  state->vtkglPointSize(this->PointSize);
  state->vtkglLineWidth(this->LineWidth);
  state->vtkglActiveTexture(static_cast<unsigned int>(this->ActiveTexture));
  state->vtkglDepthFunc(static_cast<unsigned int>(this->DepthFunction));
  state->vtkglCullFace(static_cast<unsigned int>(this->CulledFaces));
  state->vtkglDepthMask(this->DepthMask);
  state->vtkglColorMask(this->ColorMask[0], this->ColorMask[1], this->ColorMask[2], this->ColorMask[3]);
  state->vtkglBlendEquationSeparate(
    static_cast<unsigned int>(this->BlendEquation[0]), static_cast<unsigned int>(this->BlendEquation[1]));
  state->vtkglBlendFuncSeparate(static_cast<unsigned int>(this->BlendFunction[0]),
    static_cast<unsigned int>(this->BlendFunction[1]), static_cast<unsigned int>(this->BlendFunction[2]),
    static_cast<unsigned int>(this->BlendFunction[3]));
  state->vtkglScissor(this->Scissor[0], this->Scissor[1], this->Scissor[2], this->Scissor[3]);
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
std::array<int, 4> vtkTranslucencyGLState::GetScissor() const
{
  for (const auto& saved : this->Enabled)
  {
    if (saved.first == GL_SCISSOR_TEST && !saved.second)
    {
      return this->Viewport;
    }
  }
  return this->Scissor;
}

//------------------------------------------------------------------------------
unsigned int vtkTranslucencyGLState::GetDrawFramebuffer()
{
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return static_cast<unsigned int>(bound);
}

//------------------------------------------------------------------------------
void vtkTranslucencyGLState::UsePlainBlending(vtkOpenGLState* state)
{
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}
VTK_ABI_NAMESPACE_END
