// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyGeometry.h"

#include "vtkTranslucencyBlending.h"
#include "vtkTranslucencyDrawings.h"
#include "vtkTranslucencyFrameShaders.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyQuery.h"
#include "vtkTranslucencyResources.h"
#include "vtkTranslucencySamplers.h"
#include "vtkTranslucencyScopedTextures.h"
#include "vtkTranslucencyScopedTimer.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTranslucencyGeometry::vtkTranslucencyGeometry(vtkTranslucencyPass* pass, vtkTranslucencyResources& resources,
  const vtkRenderState* state, vtkOpenGLRenderWindow* window, vtkTranslucencyFrameShaders& shaders)
  : Pass(pass)
  , Resources(resources)
  , State(state)
  , Window(window)
  , Shaders(shaders)
{
}

//------------------------------------------------------------------------------
// A software rasterizer spends a fifth of a multi-sampled gather on the depth test: worth asking whether the depth
// buffer holds anything, in this tile, that could hide a fragment.
bool vtkTranslucencyGeometry::NeedsDepthTest()
{
  if (this->Shaders.GetContext().Samples == 1 || !this->Resources.Capabilities.Software ||
    !this->Shaders.PrepareProgram("Common/FullScreen.glsl", "Common/DepthOnly.glsl", {}))
  {
    return true;
  }
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_GREATER); // passes where something lies before the far plane
  return vtkTranslucencyAnySamplesPass([this] { this->Resources.Programs.DrawVertices(GL_TRIANGLES, 3); });
}

//------------------------------------------------------------------------------
void vtkTranslucencyGeometry::PrepareDrawing()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  // Without, there is one fragment per pixel and primitive, if the primitive covers the pixel's centre.
  state->SetEnumState(GL_MULTISAMPLE, this->Shaders.GetContext().Samples > 1);
  state->SetEnumState(GL_DEPTH_TEST, this->NeedsDepthTest());
}

//------------------------------------------------------------------------------
void vtkTranslucencyGeometry::PrepareColors(const vtkTranslucencyStage& stage)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->SetEnumState(GL_MULTISAMPLE, this->Shaders.GetContext().TargetSamples > 1);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->SetEnumState(GL_BLEND, stage.Blend != vtkTranslucencyStage::Blending::Replace);
  vtkTranslucencyBlending::Set(state, stage);
  vtkTranslucencyBlending::Mask(state, stage);
  if (stage.HidesBehind)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyGeometry::Prepare(const vtkTranslucencyStage& stage, bool colors)
{
  this->PrepareDrawing();
  if (colors)
  {
    this->PrepareColors(stage);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyGeometry::Draw(const vtkTranslucencyStage& stage, bool colors, bool* any)
{
  vtkTranslucencyResources& kept = this->Resources;
  vtkTranslucencyMapperHook::Drawing& drawing = kept.Mappers->GetDrawing();
  const vtkTranslucencyScopedTimer timer(this->Pass->GetMeasureTimes(), kept.GatherTime);
  this->Settled = this->Settled || vtkTranslucencySamplers::Settle(kept, this->Window, this->Shaders);
  if (!this->Settled)
  {
    kept.Mappers->SetError(this->Shaders.GetError());
    return;
  }
  drawing.WritesDepth = stage.HidesBehind;
  vtkTranslucencyOpaqueDepth& opaque = kept.Mappers->GetOpaqueDepth();
  if (opaque.IsCaptured()) // by the first drawing of the frame
  {
    opaque.Activate();
  }
  if (colors && !stage.Targets) // what goes over the opaque picture can't be drawn again
  {
    kept.Unreached.Warn(this->Pass,
      kept.Unreached.LookAhead(this->State, this->Window,
        [&](const vtkRenderState* some) { kept.Mappers->Draw(some, this->Pass->GetTranslucentPass()); }));
  }
  if (any)
  {
    *any = false;
  }
  // What reads targets, or layers of props that are drawn by themselves, reads a sample of them.
  const int pixelSamples = this->Shaders.GetContext().TargetSamples;
  const bool reads = pixelSamples > 1 && (!stage.Inputs.empty() || kept.Unreached.HasAny(this->State));
  const int samples = reads ? pixelSamples : 1;
  vtkTranslucencyDrawings::Each(this->Window->GetState(), stage, kept.Capabilities, samples,
    [&](const vtkTranslucencyStage& drawn, int sample)
    {
      drawing.Values["targetSample"] = sample;
      this->DrawOnce(drawn, colors, any);
    });
  if (opaque.IsCaptured())
  {
    opaque.Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyGeometry::DrawOnce(const vtkTranslucencyStage& stage, bool colors, bool* any)
{
  using Faces = vtkTranslucencyStage::Faces;
  vtkTranslucencyResources& kept = this->Resources;
  vtkTranslucencyMapperHook::Drawing& drawing = kept.Mappers->GetDrawing();
  this->Prepare(stage, colors);
  drawing.KeepBlending = [this, &stage, colors]
  {
    if (colors)
    {
      vtkTranslucencyBlending::Keep(this->Window->GetState(), stage);
    }
  };
  kept.RenderedProps = 0;
  drawing.Values["gatherLayer"] = 0;
  if (stage.Parts.empty())
  {
    this->DrawProps(this->State, stage, colors, any);
  }
  for (const vtkTranslucencyStage::Part& part : stage.Parts)
  {
    std::vector<vtkProp*> props{ part.Prop };
    vtkRenderState one(this->State->GetRenderer());
    vtkTranslucencySetProps(one, props, this->State);
    drawing.Values["gatherPart"] = part.Number;
    drawing.Faces = part.Drawn;
    this->DrawProps(&one, stage, colors, any);
    if (part.Drawn != Faces::All) // what follows need not care for culling
    {
      this->Window->GetState()->vtkglDisable(GL_CULL_FACE);
    }
    drawing.Faces = Faces::All;
  }
  drawing.KeepBlending = [] {};
  kept.Statistics->SetGeometryPasses(kept.Statistics->GetGeometryPasses() + 1);
}

//------------------------------------------------------------------------------
// Draws the props that the text reaches together, the others one by one behind them.
void vtkTranslucencyGeometry::DrawProps(
  const vtkRenderState* state, const vtkTranslucencyStage& stage, bool colors, bool* any)
{
  vtkTranslucencyResources& kept = this->Resources;
  std::vector<vtkProp*> reached;
  std::vector<vtkProp*> unreached;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    (kept.Unreached.Has(prop) ? unreached : reached).push_back(prop);
  }
  if (!reached.empty())
  {
    vtkRenderState together(state->GetRenderer());
    vtkTranslucencySetProps(together, reached, state);
    vtkRenderPass* props = this->Pass->GetTranslucentPass();
    const auto draw = [&] { kept.Mappers->Draw(&together, props); };
    vtkTranslucencyDrawAndAsk(any, [&] { kept.Unreached.Watch(this->Window, draw); });
    kept.RenderedProps += props->GetNumberOfRenderedProps();
  }
  for (vtkProp* prop : unreached)
  {
    // Which of its layers are back faces nobody knows: all are drawn with the front faces.
    if (kept.Mappers->GetDrawing().Faces != vtkTranslucencyStage::Faces::Back)
    {
      this->DrawUnreached(prop, stage, colors, any);
      ++kept.RenderedProps;
    }
  }
}

//------------------------------------------------------------------------------
// Draws a prop by its own shaders, layer by layer, and gives each layer to the technique as if it had come from the
// prop.
void vtkTranslucencyGeometry::DrawUnreached(vtkProp* prop, const vtkTranslucencyStage& stage, bool colors, bool* any)
{
  vtkTranslucencyResources& kept = this->Resources;
  const vtkTranslucencyTiles::Rectangle& viewport = kept.Tiles.GetViewport();
  vtkTranslucencyLayers& layers = kept.Layers;
  if (!layers.Reserve(viewport[0] + viewport[2], viewport[1] + viewport[3], this->Shaders.GetContext().TargetSamples))
  {
    kept.Mappers->SetError("the driver has no memory for the layers of " + std::string(prop->GetClassName()));
    return;
  }
  std::vector<vtkProp*> props{ prop };
  vtkRenderState one(this->State->GetRenderer());
  vtkTranslucencySetProps(one, props, this->State);
  const auto drawProp = [&] { this->Pass->GetTranslucentPass()->Render(&one); };
  int layer = 0;
  vtkTranslucencyBlending::Unmask(this->Window->GetState(), stage);
  while (layers.Draw(this->Window, kept.Unreached.GetWatch(), layer, drawProp))
  {
    if (layer == vtkTranslucencyLayers::Most)
    {
      kept.Mappers->SetError(prop->GetClassName() + std::string(", which is drawn by itself, has more than ") +
        std::to_string(layer) + " layers in a pixel, expected no more");
      return;
    }
    this->Prepare(stage, colors);
    if (!this->HandOver(prop, layer, any))
    {
      return;
    }
    ++layer;
    vtkTranslucencyBlending::Unmask(this->Window->GetState(), stage);
  }
  kept.Mappers->GetDrawing().Values["gatherLayer"] = 0;
  this->Prepare(stage, colors); // for what is drawn next
}

//------------------------------------------------------------------------------
// Gives a layer of a prop to the technique's text.
bool vtkTranslucencyGeometry::HandOver(vtkProp* prop, int layer, bool* any)
{
  vtkTranslucencyResources& kept = this->Resources;
  kept.Mappers->GetDrawing().Values["gatherLayer"] = layer;
  vtkShaderProgram* program = this->Shaders.PrepareHandOver();
  if (!program)
  {
    kept.Mappers->SetError(this->Shaders.GetError());
    return false;
  }
  vtkTranslucencyScopedTextures textures(this->Window);
  textures.Bind("layerColors", kept.Layers.GetTarget(), kept.Layers.GetColors());
  textures.Bind("layerDepths", kept.Layers.GetTarget(), kept.Layers.GetDepths());
  if (!kept.Mappers->SetParameters(program, prop))
  {
    return false;
  }
  vtkTranslucencyShader::SetUniforms(program, textures.GetUnits());
  // Layers do not tell which of their fragments are back faces.
  vtkTranslucencyShader::SetUniforms(program, { { "gatherMedium", 0 } });
  vtkTranslucencyDrawAndAsk(any, [&kept] { kept.Programs.DrawVertices(GL_TRIANGLES, 3); });
  return true;
}

//------------------------------------------------------------------------------
void vtkTranslucencyGeometry::DrawVolumes()
{
  vtkTranslucencyResources& kept = this->Resources;
  const vtkTranslucencyScopedTimer timer(this->Pass->GetMeasureTimes(), kept.GatherTime);
  this->PrepareDrawing();
  vtkTranslucencyVolumes& volumes = kept.Mappers->GetVolumes();
  const int rounds = kept.Capabilities.KeepsDrawOrder ? 1 : this->Shaders.GetContext().Samples;
  for (vtkProp* prop : volumes.GetProps())
  {
    std::vector<vtkProp*> props{ prop };
    vtkRenderState one(this->State->GetRenderer());
    vtkTranslucencySetProps(one, props, this->State);
    kept.Mappers->Draw(&one, [&] { volumes.Gather(&one, rounds); });
  }
  vtkTranslucencyBuffer::FinishStores();
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyGeometry::GetObstacle() const
{
  return this->Resources.Unreached.IsMissed() ? "props are drawn by shaders that the technique does not reach"
                                              : this->Resources.Mappers->GetError();
}
VTK_ABI_NAMESPACE_END
