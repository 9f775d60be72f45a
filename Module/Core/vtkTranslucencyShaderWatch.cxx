// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyShaderWatch.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTranslucencyShaderWatch);

namespace
{
// vtkOpenGLState has a getter for its shader cache only. A subclass may name the member that holds it.
class OpenedState : public vtkOpenGLState
{
public:
  static void SetShaderCache(vtkOpenGLState* state, vtkOpenGLShaderCache* cache)
  {
    state->*(&OpenedState::ShaderCache) = cache;
  }
};
}

//------------------------------------------------------------------------------
vtkTranslucencyShaderWatch::Scope::Scope(vtkTranslucencyShaderWatch* watch, vtkOpenGLState* state, const Report& report)
  : Watch(watch)
  , State(state)
{
  watch->Watched = state->GetShaderCache();
  watch->LastShaderBound = watch->Watched->GetLastShaderBound();
  watch->Tell = report;
  OpenedState::SetShaderCache(state, watch);
}

//------------------------------------------------------------------------------
vtkTranslucencyShaderWatch::Scope::~Scope()
{
  if (!this->Watch->LastShaderBound)
  {
    this->Watch->Watched->ReleaseCurrentShader();
  }
  OpenedState::SetShaderCache(this->State, this->Watch->Watched);
  this->Watch->Watched = nullptr;
  this->Watch->LastShaderBound = nullptr;
  this->Watch->Tell = nullptr;
}

//------------------------------------------------------------------------------
template <typename... Arguments>
vtkShaderProgram* vtkTranslucencyShaderWatch::Ready(vtkTransformFeedback* capture, Arguments... arguments)
{
  if (!this->LastShaderBound) // released by ReleaseCurrentShader, which is not virtual
  {
    this->Watched->ReleaseCurrentShader();
  }
  vtkShaderProgram* program = this->Watched->ReadyShaderProgram(arguments..., capture);
  this->LastShaderBound = this->Watched->GetLastShaderBound();
  if (program && !capture)
  {
    this->Tell(program);
  }
  return program;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyShaderWatch::ReadyShaderProgram(
  const char* vertex, const char* fragment, const char* geometry, vtkTransformFeedback* capture)
{
  return this->Ready(capture, vertex, fragment, geometry);
}

#if VTK_TRANSLUCENCY_TESSELLATION
//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyShaderWatch::ReadyShaderProgram(const char* vertex, const char* fragment,
  const char* geometry, const char* control, const char* evaluation, vtkTransformFeedback* capture)
{
  return this->Ready(capture, vertex, fragment, geometry, control, evaluation);
}
#endif

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyShaderWatch::ReadyShaderProgram(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkTransformFeedback* capture)
{
  return this->Ready(capture, shaders);
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyShaderWatch::ReadyShaderProgram(
  vtkShaderProgram* program, vtkTransformFeedback* capture)
{
  return this->Ready(capture, program);
}

//------------------------------------------------------------------------------
void vtkTranslucencyShaderWatch::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Watched)
  {
    this->Watched->ReleaseGraphicsResources(window);
    this->LastShaderBound = this->Watched->GetLastShaderBound();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyShaderWatch::ClearLastShaderBound()
{
  this->LastShaderBound = nullptr;
  if (this->Watched)
  {
    this->Watched->ClearLastShaderBound();
  }
}
VTK_ABI_NAMESPACE_END
