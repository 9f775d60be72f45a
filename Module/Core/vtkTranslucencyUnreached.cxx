// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyUnreached.h"

#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
vtkMTimeType LastChange(vtkProp* prop)
{
  return std::max(prop->GetRedrawMTime(), prop->GetShaderProperty()->GetShaderMTime());
}

// Of an actor, its mapper says more than its own class.
std::string Describe(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  return prop->GetClassName() + (mapper ? " with " + std::string(mapper->GetClassName()) : "");
}
}

//------------------------------------------------------------------------------
bool vtkTranslucencyUnreached::FindText(vtkShaderProgram* program) const
{
  vtkShader* fragment = program->GetFragmentShader();
  return fragment &&
    std::any_of(this->Marks.begin(), this->Marks.end(),
      [fragment](const std::string& mark) { return fragment->GetSource().find(mark) != std::string::npos; });
}

//------------------------------------------------------------------------------
void vtkTranslucencyUnreached::Watch(vtkOpenGLRenderWindow* window, const std::function<void()>& draw)
{
  const unsigned int drawn = vtkTranslucencyGLState::GetDrawFramebuffer();
  const auto report = [this, drawn](vtkShaderProgram* program)
  {
    const auto known = this->HasText.find(program);
    const bool has = known != this->HasText.end()
      ? known->second
      : this->HasText.emplace(program, this->FindText(program)).first->second;
    if (!has && vtkTranslucencyGLState::GetDrawFramebuffer() == drawn) // mappers may prepare something elsewhere
    {
      this->Missed = true;
    }
  };
  const vtkTranslucencyShaderWatch::Scope scope(this->ShaderWatch, window->GetState(), report);
  draw();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyUnreached::TakeMissed()
{
  const bool missed = this->Missed;
  this->Missed = false;
  return missed;
}

//------------------------------------------------------------------------------
// Whether one is met where these props are drawn, without rasterizing.
bool vtkTranslucencyUnreached::Test(
  std::vector<vtkProp*> props, const vtkRenderState* like, vtkOpenGLRenderWindow* window, const Drawing& draw)
{
  vtkRenderState some(like->GetRenderer());
  vtkTranslucencySetProps(some, props, like);
  this->Missed = false;
  glEnable(GL_RASTERIZER_DISCARD);
  this->Watch(window, [&] { draw(&some); });
  glDisable(GL_RASTERIZER_DISCARD);
  return this->TakeMissed();
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyUnreached::Find(
  const vtkRenderState* state, vtkOpenGLRenderWindow* window, const Drawing& draw)
{
  for (auto known = this->Props.begin(); known != this->Props.end();)
  {
    known = known->second.Prop ? std::next(known) : this->Props.erase(known);
  }
  std::string found;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    if (!this->Has(prop) && this->Test({ prop }, state, window, draw))
    {
      this->Note(prop, false);
      const std::string description = Describe(prop);
      if (found.find(description) == std::string::npos)
      {
        found += (found.empty() ? "" : ", ") + description;
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
void vtkTranslucencyUnreached::LookAgain(
  const vtkRenderState* state, vtkOpenGLRenderWindow* window, const Drawing& draw)
{
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    const Known* known = this->FindKnown(prop);
    if (known && !known->Reached && known->Looked != LastChange(prop))
    {
      this->Note(prop, !this->Test({ prop }, state, window, draw));
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyUnreached::LookAhead(
  const vtkRenderState* state, vtkOpenGLRenderWindow* window, const Drawing& draw)
{
  this->LookAgain(state, window, draw);
  std::vector<vtkProp*> changed;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    const Known* known = this->FindKnown(prop);
    if (!known || known->Looked != LastChange(prop))
    {
      changed.push_back(prop);
    }
  }
  if (changed.empty())
  {
    return "";
  }
  const std::string found = this->Test(changed, state, window, draw) ? this->Find(state, window, draw) : "";
  for (vtkProp* prop : changed)
  {
    this->Note(prop, !this->Has(prop));
  }
  return found;
}

//------------------------------------------------------------------------------
void vtkTranslucencyUnreached::Warn(vtkObject* pass, const std::string& descriptions)
{
  if (!descriptions.empty() && this->Warned.insert(descriptions).second)
  {
    vtkWarningWithObjectMacro(pass,
      << descriptions
      << " draws by shaders that the pass can't reach, those of actors within it or of the user's own; it is drawn by "
      << "itself, once for each of its layers, which are then among all others");
  }
}

//------------------------------------------------------------------------------
const vtkTranslucencyUnreached::Known* vtkTranslucencyUnreached::FindKnown(vtkProp* prop) const
{
  const auto known = this->Props.find(prop);
  return known != this->Props.end() && known->second.Prop == prop ? &known->second : nullptr;
}

//------------------------------------------------------------------------------
void vtkTranslucencyUnreached::Note(vtkProp* prop, bool reached)
{
  this->Props[prop] = { prop, LastChange(prop), reached };
}

//------------------------------------------------------------------------------
bool vtkTranslucencyUnreached::HasAny(const vtkRenderState* state) const
{
  for (int i = 0; !this->Props.empty() && i < vtkTranslucencyPropCount(state); ++i)
  {
    if (this->Has(vtkTranslucencyProp(state, i)))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyUnreached::Has(vtkProp* prop) const
{
  const Known* known = this->FindKnown(prop);
  return known && !known->Reached;
}
VTK_ABI_NAMESPACE_END
