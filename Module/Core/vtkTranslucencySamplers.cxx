// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencySamplers.h"

#include "vtkTranslucencyFrameShaders.h"
#include "vtkTranslucencyResources.h"
#include "vtkTranslucencyScopedTextures.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkTranslucencySamplers::Settle(
  vtkTranslucencyResources& resources, vtkOpenGLRenderWindow* window, vtkTranslucencyFrameShaders& shaders)
{
  if (!vtkTranslucencyCapabilities::IsRasterizer(resources.Capabilities.Renderer))
  {
    return true;
  }
  vtkShaderProgram* program = shaders.PrepareProgram("Common/FullScreen.glsl", "Common/SettleSamplers.glsl", {});
  if (!program)
  {
    return false;
  }
  vtkTranslucencyScopedTextures textures(window);
  for (const char* sampler : { "settledFirst", "settledSecond" })
  {
    textures.Bind(sampler, GL_TEXTURE_2D, 0); // of which all is as it is at first
  }
  vtkTranslucencyShader::SetUniforms(program, textures.GetUnits());
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, 0, 0, 0);
  resources.Programs.DrawVertices(GL_TRIANGLES, 3);
  return true;
}
VTK_ABI_NAMESPACE_END
