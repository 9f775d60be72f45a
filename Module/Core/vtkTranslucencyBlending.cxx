// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyBlending.h"

#include "vtkTranslucencyTargets.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLState.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
struct BlendFunction
{
  GLenum Equation;
  std::array<GLenum, 4> Factors; // source and destination, colour and alpha
};

BlendFunction GetFunction(vtkTranslucencyStage::Blending blending)
{
  using Blending = vtkTranslucencyStage::Blending;
  switch (blending)
  {
    case Blending::AddAndAttenuate:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Attenuate:
      return { GL_FUNC_ADD, { { GL_ZERO, GL_ONE_MINUS_SRC_COLOR, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Minimum:
      return { GL_MIN, { { GL_ONE, GL_ONE, GL_ONE, GL_ONE } } };
    case Blending::Maximum:
      return { GL_MAX, { { GL_ONE, GL_ONE, GL_ONE, GL_ONE } } };
    case Blending::Over:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Filter:
      return { GL_FUNC_ADD, { { GL_ONE, GL_SRC1_COLOR, GL_ONE, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Under:
      return { GL_FUNC_ADD, { { GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Replace:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ZERO, GL_ONE, GL_ZERO } } };
    default:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ONE, GL_ONE, GL_ONE } } };
  }
}

// How one of a stage's buffers is blended.
vtkTranslucencyStage::Blending GetBlending(const vtkTranslucencyStage& stage, int buffer)
{
  const auto differing = stage.Differing.find(buffer);
  return differing == stage.Differing.end() ? stage.Blend : differing->second.Blend;
}

BlendFunction GetFunction(const vtkTranslucencyStage& stage, int buffer)
{
  return GetFunction(GetBlending(stage, buffer));
}
}

//------------------------------------------------------------------------------
void vtkTranslucencyBlending::Set(vtkOpenGLState* state, const vtkTranslucencyStage& stage)
{
  // VTK, if it is built so, compares its function with that of the first buffer.
  const BlendFunction first = GetFunction(stage, 0);
  state->vtkglBlendEquation(first.Equation);
  state->vtkglBlendFuncSeparate(first.Factors[0], first.Factors[1], first.Factors[2], first.Factors[3]);
  for (int buffer = 1; !stage.Differing.empty() && buffer < stage.Targets->GetCount(); ++buffer)
  {
    const BlendFunction own = GetFunction(stage, buffer);
    glBlendEquationi(static_cast<GLuint>(buffer), own.Equation);
    glBlendFuncSeparatei(static_cast<GLuint>(buffer), own.Factors[0], own.Factors[1], own.Factors[2], own.Factors[3]);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyBlending::Keep(vtkOpenGLState* state, const vtkTranslucencyStage& stage)
{
  const BlendFunction first = GetFunction(stage, 0);
  std::array<int, 4> found;
  state->GetBlendFuncState(found.data());
  if (!std::equal(
        found.begin(), found.end(), std::begin(first.Factors), [](int a, auto b) { return a == static_cast<int>(b); }))
  {
    Set(state, stage);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyStage> vtkTranslucencyBlending::Split(const vtkTranslucencyStage& stage)
{
  std::vector<vtkTranslucencyStage> parts;
  for (int buffer = 0; buffer < stage.Targets->GetCount(); ++buffer)
  {
    const vtkTranslucencyStage::Blending blend = GetBlending(stage, buffer);
    auto alike = std::find_if(
      parts.begin(), parts.end(), [blend](const vtkTranslucencyStage& part) { return part.Blend == blend; });
    if (alike == parts.end())
    {
      alike = parts.insert(alike, stage);
      alike->Blend = blend;
      alike->Differing.clear();
      for (int other = 0; other < stage.Targets->GetCount(); ++other)
      {
        alike->Masked.insert(other);
      }
    }
    alike->Masked.erase(buffer);
  }
  return parts;
}

//------------------------------------------------------------------------------
void vtkTranslucencyBlending::Mask(vtkOpenGLState* state, const vtkTranslucencyStage& stage)
{
  if (stage.Masked.empty())
  {
    return;
  }
  const auto drawn = [&stage](int buffer) { return stage.Masked.count(buffer) == 0 ? GL_TRUE : GL_FALSE; };
  state->vtkglColorMask(drawn(0), drawn(0), drawn(0), drawn(0));
  for (int buffer = 1; buffer < stage.Targets->GetCount(); ++buffer)
  {
    glColorMaski(static_cast<GLuint>(buffer), drawn(buffer), drawn(buffer), drawn(buffer), drawn(buffer));
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyBlending::Unmask(vtkOpenGLState* state, const vtkTranslucencyStage& stage)
{
  if (!stage.Masked.empty())
  {
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  for (int buffer : stage.Masked)
  {
    glColorMaski(static_cast<GLuint>(buffer), GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyBlending::UseOneFunction()
{
  const auto get = [](GLenum name)
  {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return static_cast<GLenum>(value);
  };
  glBlendEquationSeparate(get(GL_BLEND_EQUATION_RGB), get(GL_BLEND_EQUATION_ALPHA));
  glBlendFuncSeparate(get(GL_BLEND_SRC_RGB), get(GL_BLEND_DST_RGB), get(GL_BLEND_SRC_ALPHA), get(GL_BLEND_DST_ALPHA));
}
VTK_ABI_NAMESPACE_END
