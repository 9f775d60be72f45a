// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyPrograms.h"

#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyPrograms::Ready(vtkOpenGLRenderWindow* window, const std::string& key,
  const std::function<bool(Source& source)>& assemble, const std::function<bool()>& validate)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  const auto found = this->Programs.find(key);
  if (found != this->Programs.end())
  {
    return cache->ReadyShaderProgram(found->second);
  }
  Source source;
  if (!assemble(source))
  {
    return nullptr;
  }
  const auto make = [&] { return cache->ReadyShaderProgram(source.Vertex.c_str(), source.Fragment.c_str(), ""); };
  // With a message VTK prints all of the text. Compiling each shader beforehand, to know better, doubled the time.
  const int shown = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  vtkShaderProgram* program = make();
  vtkObject::SetGlobalWarningDisplay(shown);
  if (!program && validate())
  {
    program = make();
  }
  if (program)
  {
    this->Programs[key] = program;
  }
  return program;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPrograms::GetKey(
  const std::string& name, const vtkTranslucencyShader::Defines& defines, const vtkTranslucencyShader::Defines& offered)
{
  std::string key = name;
  for (const auto* list : { &defines, &offered })
  {
    for (const auto& define : *list)
    {
      key += " " + define.first + "=" + define.second;
    }
  }
  return key;
}

//------------------------------------------------------------------------------
void vtkTranslucencyPrograms::DrawVertices(unsigned int primitive, int count)
{
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  glDrawArrays(primitive, 0, count);
}

//------------------------------------------------------------------------------
void vtkTranslucencyPrograms::Release(bool contextAlive)
{
  this->Programs.clear();
  if (this->VertexArray != 0 && contextAlive)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->VertexArray = 0;
}
VTK_ABI_NAMESPACE_END
