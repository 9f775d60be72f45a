// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyResolver.h"

#include "Common/Bindings.glsl"
#include "vtkFragmentStorage.h"
#include "vtkTranslucencyFrameShaders.h"
#include "vtkTranslucencyGeometry.h"
#include "vtkTranslucencyQuery.h"
#include "vtkTranslucencyResources.h"
#include "vtkTranslucencySamplers.h"
#include "vtkTranslucencyScopedTextures.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Points are as large as programs say; what is drawn next may have points whose programs say no size.
class ScopedPointSizes
{
public:
  ScopedPointSizes()
    : Found(glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE)
  {
    glEnable(GL_PROGRAM_POINT_SIZE);
  }
  ~ScopedPointSizes()
  {
    if (!this->Found)
    {
      glDisable(GL_PROGRAM_POINT_SIZE);
    }
  }
  ScopedPointSizes(const ScopedPointSizes&) = delete;
  ScopedPointSizes& operator=(const ScopedPointSizes&) = delete;

private:
  bool Found;
};
}

//------------------------------------------------------------------------------
vtkTranslucencyResolver::vtkTranslucencyResolver(vtkTranslucencyResources& resources, vtkOpenGLRenderWindow* window,
  vtkTranslucencyGeometry& geometry, vtkTranslucencyFrameShaders& shaders)
  : Resources(resources)
  , Window(window)
  , Geometry(geometry)
  , Shaders(shaders)
{
}

//------------------------------------------------------------------------------
void vtkTranslucencyResolver::SetSample(int sample, int among)
{
  this->Sample = sample;
  this->Among = among;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyResolver::ReserveSampleColors(int samples, int channels)
{
  vtkTranslucencyBuffer& colors = this->Resources.SampleColors;
  const vtkTranslucencyTiles::Rectangle& tile = this->Resources.Tiles.GetTile();
  const vtkTypeInt64 colorBytes = channels == 3 ? 16 : 8;
  const vtkTypeInt64 before = colors.GetBytes();
  if (!colors.Reserve(colorBytes * samples * tile[2] * tile[3]))
  {
    return false;
  }
  if (colors.GetBytes() != before)
  {
    colors.Clear(colors.GetBytes()); // from then on whoever reads them does
  }
  colors.BindStorage(STORAGE_BINDING_SAMPLES);
  return true;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyResolver::Prepare(
  const std::string& file, const vtkTranslucencyFrame::Defines& defines, int level)
{
  const bool settled = level > 0 || this->Sample != vtkTranslucencyFrame::WholePixel ||
    vtkTranslucencySamplers::Settle(this->Resources, this->Window, this->Shaders);
  return settled ? this->Shaders.PrepareProgram("Common/ResolveSquares.glsl", file, defines) : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyResolver::Draw(vtkShaderProgram* program, const vtkTranslucencyFrame::Squares& squares,
  const vtkTranslucencyFrame::Uniforms& uniforms, vtkFragmentStorage* storage, vtkTranslucencyFrame::Blending over)
{
  vtkTranslucencyResources& kept = this->Resources;
  const vtkTranslucencyTiles::Rectangle& tile = kept.Tiles.GetTile();
  if (!kept.Resolved.Use(kept.Tiles.GetViewport()))
  {
    return "the driver has no memory for the resolve";
  }
  if (squares.Level == 0 && this->Sample == vtkTranslucencyFrame::WholePixel)
  {
    kept.Resolved.BeginTile(tile);
  }
  vtkTranslucencyFrame::Uniforms values{ { "resolveLevel", squares.Level }, { "resolveFewer", squares.Fewer },
    { "resolveMost", squares.Most }, { "resolveSample", this->Sample }, { "resolveAmong", this->Among } };
  vtkTranslucencyShader::SetUniforms(program, kept.Mappers->GetFrameValues());
  vtkTranslucencyShader::SetUniforms(program, values);
  vtkTranslucencyShader::SetUniforms(program, uniforms);
  vtkTranslucencyScopedTextures textures(this->Window);
  textures.BindTexels({ { "statisticsTexels", &kept.Resolved.GetBlock(), 1 } }, program);
  if (storage)
  {
    textures.BindTexels(storage->GetTexels(), program);
  }
  vtkTranslucencyShader::SetUniforms(program, textures.GetUnits());

  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const int across = vtkTranslucencyResolveStatistics::GetSquares(tile[2]);
  const int down = vtkTranslucencyResolveStatistics::GetSquares(tile[3]);
  state->vtkglViewport(tile[0], tile[1], across * RESOLVE_SQUARE, down * RESOLVE_SQUARE);
  const ScopedPointSizes sizes;
  state->vtkglDisable(GL_DEPTH_TEST);
  vtkTranslucencyStage blended;
  blended.Blend = over;
  this->Geometry.PrepareColors(blended);
  kept.Programs.DrawVertices(GL_POINTS, across * down);
  if (storage)
  {
    storage->FinishLinks();
  }
  kept.Resolved.Change();
  vtkTranslucencyBuffer::FinishStores();
  kept.Statistics->SetScreenPasses(kept.Statistics->GetScreenPasses() + 1);
  return "";
}

//------------------------------------------------------------------------------
void vtkTranslucencyResolver::DrawCells(vtkShaderProgram* program, vtkFragmentStorage& storage, vtkTypeInt64 most)
{
  vtkTranslucencyResources& kept = this->Resources;
  const vtkTranslucencyTiles::Rectangle& tile = kept.Tiles.GetTile();
  vtkTranslucencyScopedTextures textures(this->Window);
  textures.BindTexels(storage.GetTexels(), program);
  vtkTranslucencyShader::SetUniforms(program, kept.Mappers->GetFrameValues());
  vtkTranslucencyShader::SetUniforms(program, textures.GetUnits());
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const std::array<int, 2> cells = storage.GetCells();
  state->vtkglViewport(tile[0], tile[1], cells[0], cells[1]);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_MULTISAMPLE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  const ScopedPointSizes sizes;
  const auto draw = [&] { kept.Programs.DrawVertices(GL_POINTS, cells[0] * cells[1]); };
  bool any = true;
  for (vtkTypeInt64 left = most; any && left > 0; --left)
  {
    if (most > 1)
    {
      any = vtkTranslucencyAnySamplesPass(draw);
    }
    else
    {
      draw();
    }
    vtkTranslucencyBuffer::FinishStores();
    kept.Statistics->SetScreenPasses(kept.Statistics->GetScreenPasses() + 1);
  }
  kept.Resolved.Change();
}
VTK_ABI_NAMESPACE_END
