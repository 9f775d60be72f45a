// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyBuffer.h"

#include "vtkTranslucencyVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkTranslucencyBuffer::Reserve(vtkTypeInt64 bytes)
{
  return this->Allocate(bytes, GL_DYNAMIC_COPY);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyBuffer::ReserveForReading(vtkTypeInt64 bytes)
{
  return this->Allocate(bytes, GL_STREAM_READ);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyBuffer::Allocate(vtkTypeInt64 bytes, unsigned int usage)
{
  if (bytes <= this->Bytes)
  {
    return true;
  }
  if (this->Handle == 0)
  {
    glGenBuffers(1, &this->Handle);
    this->TexelWords = 0; // the texture, if there is one, is not this buffer
  }
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Handle);
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, usage);
  GLint64 held = 0; // asked rather than glGetError, which would also take errors that are not this allocation's
  glGetBufferParameteri64v(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &held);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  if (held != bytes)
  {
    while (glGetError() == GL_OUT_OF_MEMORY)
    {
      // the caller is told
    }
    this->Release();
    return false;
  }
  this->Bytes = bytes;
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyBuffer::Upload(const void* data, vtkTypeInt64 bytes)
{
  if (!this->Reserve(bytes))
  {
    return false;
  }
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Handle);
  glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  return true;
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::Clear(vtkTypeInt64 bytes, vtkTypeInt64 offset)
{
  const GLuint zero = 0;
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Handle);
  glClearBufferSubData(GL_COPY_WRITE_BUFFER, GL_R32UI, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
    GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::Copy(const vtkTranslucencyBuffer& from, vtkTypeInt64 bytes)
{
  glBindBuffer(GL_COPY_READ_BUFFER, from.Handle);
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Handle);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(bytes));
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::Download(void* data, vtkTypeInt64 bytes) const
{
  glBindBuffer(GL_COPY_READ_BUFFER, this->Handle);
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::BindStorage(unsigned int index) const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, this->Handle);
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::BindUniform(unsigned int index) const
{
  glBindBufferBase(GL_UNIFORM_BUFFER, index, this->Handle);
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::BindTexels(int words)
{
  if (this->Texture == 0)
  {
    glGenTextures(1, &this->Texture);
  }
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  if (this->TexelWords != words)
  {
    glTexBuffer(GL_TEXTURE_BUFFER, words == 4 ? GL_RGBA32UI : words == 3 ? GL_RGB32UI : GL_R32UI, this->Handle);
    this->TexelWords = words;
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::FinishStores()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkTranslucencyBuffer::Release(bool contextAlive)
{
  if (this->Texture != 0 && contextAlive)
  {
    glDeleteTextures(1, &this->Texture);
  }
  this->Texture = 0;
  this->TexelWords = 0;
  if (this->Handle != 0 && contextAlive)
  {
    glDeleteBuffers(1, &this->Handle);
  }
  this->Handle = 0;
  this->Bytes = 0;
}
VTK_ABI_NAMESPACE_END
