// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyFrame.h"

#include "Common/Bindings.glsl"
#include "vtkFragmentStorage.h"
#include "vtkTranslucencyDrawings.h"
#include "vtkTranslucencyFingerprint.h"
#include "vtkTranslucencyFrameShaders.h"
#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyGeometry.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyPixels.h"
#include "vtkTranslucencyQuery.h"
#include "vtkTranslucencyRecords.h"
#include "vtkTranslucencyResolver.h"
#include "vtkTranslucencyResources.h"
#include "vtkTranslucencyScene.h"
#include "vtkTranslucencyScopedTargets.h"
#include "vtkTranslucencyScopedTextures.h"
#include "vtkTranslucencyScopedTimer.h"
#include "vtkTranslucencyTargets.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTranslucencyFrame::vtkTranslucencyFrame(vtkTranslucencyPass* pass, vtkTranslucencyResources& resources,
  const vtkRenderState* state, vtkOpenGLRenderWindow* window, const vtkTranslucencyGLState& found, bool usesStorage)
  : Pass(pass)
  , Resources(resources)
  , Picture(found.GetViewport())
  , Tiles(resources.Tiles)
  , State(state)
  , Window(window)
  , Shaders(new vtkTranslucencyFrameShaders(resources, window, pass->GetCriticalSection()))
  , Geometry(new vtkTranslucencyGeometry(pass, resources, state, window, *this->Shaders))
  , Resolver(new vtkTranslucencyResolver(resources, window, *this->Geometry, *this->Shaders))
  , Records(new vtkTranslucencyRecords(resources.Capabilities, resources.Tiles, *this->Shaders))
{
  this->Tiles.BeginFrame(vtkTranslucencyTiles::Intersect(found.GetViewport(), found.GetScissor()));
  resources.Mappers->BeginFrame(window, this->GetViewport());
  resources.Resolved.BeginFrame();
  resources.GatherTime = -1;
  resources.ResolveTime = -1;
  this->Shaders->ChooseSamples(pass, usesStorage);
  this->Shaders->ChooseTransmission(pass, state);
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::~vtkTranslucencyFrame() = default;

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::UseTile()
{
  vtkTranslucencyResources& kept = this->Resources;
  const Rectangle& tile = this->GetTile();
  std::array<float, 4> numbers;
  std::copy(tile.begin(), tile.end(), numbers.begin());
  kept.Mappers->SetFrameValues(
    { { "frameTileNumbers", numbers }, { "frameClipping", vtkTranslucencyScene::GetClipping(this->GetRenderer()) },
      { "frameRays", vtkTranslucencyScene::GetRays(this->GetRenderer(), this->Picture) } });
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(tile[0], tile[1], tile[2], tile[3]);
}

//------------------------------------------------------------------------------
// After a drawing of the geometry: whether all of it was drawn by the technique.
bool vtkTranslucencyFrame::IsDrawn()
{
  const std::string obstacle = this->Geometry->GetObstacle();
  return obstacle.empty() || this->Fail(obstacle);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::DrawCells(const char* file, vtkTypeInt64 most)
{
  const vtkTranslucencyScopedTimer timer(this->Pass->GetMeasureTimes(), this->Resources.ResolveTime);
  vtkShaderProgram* program = this->PrepareProgram("Storage/EachCell.glsl", file, {});
  if (!program)
  {
    return false;
  }
  this->UseTile();
  this->Resolver->DrawCells(program, *this->Storage, most);
  return true;
}

//------------------------------------------------------------------------------
// Makes what the storage holds ready to be read.
bool vtkTranslucencyFrame::Retrieve()
{
  const char* file = this->Storage->GetRetrieval();
  if (!file)
  {
    return true;
  }
  this->Storage->BeginRetrieval();
  return this->DrawCells(file, this->Storage->GetMostRetrievals());
}

//------------------------------------------------------------------------------
// After the geometry was drawn: what is to be known before the resolves. Those of what was only summed up ask later.
bool vtkTranslucencyFrame::FinishGathering()
{
  using Outcome = vtkFragmentStorage::Outcome;
  vtkTranslucencyResources& kept = this->Resources;
  // Both go through whole lists only.
  const bool divides = !kept.Mappers->GetVolumes().GetProps().empty();
  const bool absorbs = this->Shaders->GetContext().Absorbs;
  const char* summary = this->Storage->GetSummary();
  this->SummedUp = summary && !this->Storage->GetRetrieval() && !divides && !absorbs;
  if (this->SummedUp)
  {
    kept.Resolved.BeginSum();
    return this->DrawCells(summary, 1);
  }
  Outcome outcome = this->Storage->End();
  if (outcome == Outcome::Complete && !this->Retrieve())
  {
    return false;
  }
  if (outcome == Outcome::Complete && (divides || absorbs) && !this->SortLists({}))
  {
    return false;
  }
  if (outcome == Outcome::Complete && divides)
  {
    this->Geometry->DrawVolumes();
    outcome = this->Storage->End();
  }
  if (outcome == Outcome::Complete && absorbs && !this->Absorb())
  {
    return false;
  }
  this->Finish(outcome);
  return true;
}

//------------------------------------------------------------------------------
// Gives the fragments of lists that are in order what bodies absorb in front of them.
bool vtkTranslucencyFrame::Absorb()
{
  vtkTranslucencyMapperHook* mappers = this->Resources.Mappers;
  vtkTranslucencyOpaqueDepth& opaque = mappers->GetOpaqueDepth();
  const bool copied = opaque.Use() || this->Fail("the depth buffer can't be copied");
  Uniforms values = mappers->GetMedia().GetUniforms(this->GetRenderer(), this->Picture);
  values["translucencyOpaqueDepth"] = opaque.GetUnit();
  const bool absorbed = copied && this->Resolve("Absorption/Absorb.glsl", {}, {}, values);
  opaque.Deactivate();
  return absorbed;
}

//------------------------------------------------------------------------------
// What becomes of the tile when it is known how the storage has got on.
void vtkTranslucencyFrame::Finish(vtkFragmentStorage::Outcome outcome)
{
  using Outcome = vtkFragmentStorage::Outcome;
  this->Complete = outcome == Outcome::Complete;
  if (this->Complete)
  {
    this->Tiles.Finish(this->Storage->GetFragments(), this->Storage->GetUnits());
  }
  else if (outcome == Outcome::Grown)
  {
    // the same tile again
  }
  else if (this->Tiles.IsSmallest())
  {
    this->HasRoom = this->Fail(
      "the driver has no memory for the " + std::to_string(this->Storage->GetFragments()) + " fragments of one pixel");
  }
  else
  {
    this->Tiles.Cut(outcome == Outcome::TooLarge ? this->Storage->GetPartsNeeded() : 2);
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::IsComplete()
{
  if (this->SummedUp)
  {
    this->SummedUp = false;
    this->Finish(this->Storage->End(this->Resources.Resolved.GetSum()));
  }
  return this->Complete;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Gather(vtkFragmentStorage* storage)
{
  using Outcome = vtkFragmentStorage::Outcome;
  vtkTranslucencyResources& kept = this->Resources;
  if (this->Storage != storage)
  {
    const vtkTranslucencyScene scene(this->State, kept.Unreached, kept.Bounds);
    storage->BeginFrame(scene.GetBoxes(this->Picture), kept.Capabilities);
  }
  this->Storage = storage;
  this->SummedUp = false;
  this->Shaders->GetContext().Storage = storage;
  storage->SetChannelsAndSamples(this->GetChannels(), this->GetSamples());
  this->SetSample(WholePixel);
  const std::string obstacle = storage->GetObstacle(this->GetViewport(), kept.Capabilities);
  if (!obstacle.empty())
  {
    return this->Fail(obstacle);
  }
  if (!this->Shaders->PrepareStoring())
  {
    return this->Fail(this->Shaders->GetError());
  }
  if (!kept.Resolved.Use(this->GetViewport()))
  {
    return this->Fail("the driver has no memory for the resolve");
  }
  if (storage->Fits(this->Tiles.GetLastUnits(), this->GetViewport(), kept.Capabilities))
  {
    this->Tiles.UseWholeViewport();
  }
  do
  {
    if (!this->HasRoom)
    {
      this->HasRoom = true; // for the next tile
      return false;
    }
    const Outcome outcome = storage->Begin(this->GetTile(), kept.Capabilities);
    if (outcome != Outcome::Complete)
    {
      this->Finish(outcome);
      continue;
    }
    this->UseTile();
    kept.Mappers->SetError("");
    this->Geometry->Draw(Stage(), false);
    vtkTranslucencyBuffer::FinishStores();
    if (!this->FinishGathering() || !this->IsDrawn())
    {
      return false;
    }
  } while (!this->SummedUp && !this->Complete);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::UsePixels(
  vtkTranslucencyPixels& pixels, int words, double memoryLimit, const Fetched& fetched, bool zeroed)
{
  const bool mayFetch = this->Pass->GetCriticalSection() == vtkTranslucencyPass::Automatic;
  const std::string obstacle = this->Records->Reserve(pixels, words, memoryLimit, fetched, mayFetch, zeroed);
  if (!obstacle.empty())
  {
    return this->Fail(obstacle);
  }
  this->UseTile();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::FetchesRecords() const
{
  return this->Records->AreFetched();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::UseTargets(vtkTranslucencyTargets& targets, const std::vector<int>& formats, bool halves)
{
  this->Tiles.UseWholeViewport();
  std::vector<vtkTranslucencyTargets::Format> floats;
  for (int format : formats)
  {
    floats.push_back(halves ? vtkTranslucencyTargets::Halves(format) : vtkTranslucencyTargets::Floats(format));
  }
  const Rectangle& viewport = this->GetViewport();
  if (!targets.Reserve(
        viewport[0] + viewport[2], viewport[1] + viewport[3], this->Shaders->GetContext().TargetSamples, floats))
  {
    return this->Fail("the driver has no memory for floating-point colours");
  }
  this->UseTile();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::UseTable(vtkTranslucencyTargets& table, int columns, const std::vector<unsigned int>& words)
{
  const int rows = static_cast<int>(words.size()) / columns;
  if (!table.Reserve(columns, rows, 1, { vtkTranslucencyTargets::Format::Word1 }))
  {
    return this->Fail("the driver has no memory for a table of " + std::to_string(words.size()) + " words");
  }
  table.Write(words);
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkTranslucencyFrame::GetProps() const
{
  return vtkTranslucencyScene(this->State, this->Resources.Unreached, this->Resources.Bounds).GetProps();
}

//------------------------------------------------------------------------------
vtkRenderer* vtkTranslucencyFrame::GetRenderer() const
{
  return this->State->GetRenderer();
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkTranslucencyFrame::GetDepthRange() const
{
  return vtkTranslucencyScene(this->State, this->Resources.Unreached, this->Resources.Bounds).GetDepthRange();
}

//------------------------------------------------------------------------------
// After a stage that may have changed records of pixels. Where there are none nothing is to be waited for: what goes to
// targets is seen by whoever reads them.
void vtkTranslucencyFrame::FinishRecords()
{
  if (this->Records->AreStored())
  {
    vtkTranslucencyBuffer::FinishStores();
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Draw(const Gathering& gathering, const Stage& stage, bool* any)
{
  vtkTranslucencyResources& kept = this->Resources;
  if (!this->Shaders->PrepareGathering(gathering))
  {
    return this->Fail(this->Shaders->GetError());
  }
  const Stage drawn = kept.Mappers->FetchesRecords() ? this->Records->GetStage(stage) : stage;
  const vtkTranslucencyScopedTargets targets(this->Window, drawn);
  if (!targets.GetObstacle().empty())
  {
    return this->Fail(targets.GetObstacle());
  }
  if (!drawn.Targets)
  {
    this->UseTile();
  }
  {
    const vtkTranslucencyScopedTextures inputs(this->Window, drawn.Inputs);
    Uniforms& values = kept.Mappers->GetDrawing().Values;
    values = drawn.Values;
    values["gatherStage"] = drawn.Number;
    values.insert(inputs.GetUnits().begin(), inputs.GetUnits().end());
    kept.Mappers->SetError("");
    this->Geometry->Draw(drawn, (gathering.Outputs > 0 && !drawn.StoresOnly) || kept.Mappers->FetchesRecords(), any);
  }
  this->FinishRecords();
  return this->IsDrawn();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::DrawScreen(const std::string& file, const Defines& defines, const Stage& stage, bool* any)
{
  vtkTranslucencyResources& kept = this->Resources;
  vtkShaderProgram* program = this->PrepareProgram("Common/FullScreen.glsl", file, defines);
  if (!program)
  {
    return false;
  }
  const vtkTranslucencyScopedTimer timer(this->Pass->GetMeasureTimes(), kept.ResolveTime);
  this->UseTile();
  const vtkTranslucencyScopedTargets targets(this->Window, stage);
  if (!targets.GetObstacle().empty())
  {
    return this->Fail(targets.GetObstacle());
  }
  const vtkTranslucencyScopedTextures bound(this->Window, stage.Inputs);
  vtkTranslucencyShader::SetUniforms(program, stage.Values);
  vtkTranslucencyShader::SetUniforms(program, bound.GetUnits());
  vtkTranslucencyShader::SetUniforms(program, kept.Mappers->GetFrameValues());
  this->Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  if (any)
  {
    *any = false;
  }
  const int samples = stage.Inputs.empty() ? 1 : this->Shaders->GetContext().TargetSamples;
  vtkTranslucencyDrawings::Each(this->Window->GetState(), stage, kept.Capabilities, samples,
    [&](const Stage& drawn, int sample)
    {
      vtkTranslucencyShader::SetUniforms(program, { { "targetSample", sample } });
      this->Geometry->PrepareColors(drawn);
      vtkTranslucencyDrawAndAsk(any, [&kept] { kept.Programs.DrawVertices(GL_TRIANGLES, 3); });
    });
  this->FinishRecords();
  kept.Statistics->SetScreenPasses(kept.Statistics->GetScreenPasses() + 1);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Clear(const Stage& stage)
{
  const vtkTranslucencyScopedTargets targets(this->Window, stage);
  return targets.GetObstacle().empty() || this->Fail(targets.GetObstacle());
}

//------------------------------------------------------------------------------
std::vector<float> vtkTranslucencyFrame::Read(const vtkTranslucencyTargets& targets, int index)
{
  const std::vector<float> values = targets.Read(index, this->GetTile(), this->Window);
  if (values.empty())
  {
    this->Fail("the driver can't read floating-point colours back");
  }
  return values;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Composite(
  const std::string& file, const Defines& defines, const std::vector<Input>& inputs, const Uniforms& uniforms)
{
  Stage over;
  over.Blend = this->GetOver();
  over.Inputs = inputs;
  over.Values = uniforms;
  for (const Input& record : this->Records->GetInputs())
  {
    over.Inputs.push_back(record);
  }
  if (!this->DrawScreen(file, defines, over))
  {
    return false;
  }
  this->Tiles.Finish();
  return true;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyFrame::PrepareProgram(
  const std::string& vertexFile, const std::string& file, const Defines& defines)
{
  vtkShaderProgram* program = this->Shaders->PrepareProgram(vertexFile, file, defines);
  if (!program)
  {
    this->Fail(this->Shaders->GetError());
  }
  return program;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Resolve(
  const std::string& file, const Defines& defines, const Squares& squares, const Uniforms& uniforms)
{
  vtkShaderProgram* program = this->Resolver->Prepare(file, defines, squares.Level);
  if (!program)
  {
    return this->Fail(this->Shaders->GetError());
  }
  const vtkTranslucencyScopedTimer timer(this->Pass->GetMeasureTimes(), this->Resources.ResolveTime);
  this->UseTile();
  const std::string obstacle = this->Resolver->Draw(program, squares, uniforms, this->Storage, this->GetOver());
  return obstacle.empty() || this->Fail(obstacle);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::PrepareSorting()
{
  return this->Storage->ReserveLinks() || this->Fail("the driver has no memory for sorting fragments");
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::SortLists(const Squares& squares)
{
  bool drawn = this->PrepareSorting() && this->Resolve("Common/SortRuns.glsl", {}, squares);
  const vtkTypeInt64 deepest = drawn ? this->GetDeepestPixel() : 0;
  for (int length = 32; length < deepest && drawn; length *= 2)
  {
    drawn = this->Resolve("Common/MergeRuns.glsl", {}, squares, { { "runLength", length } });
  }
  return drawn;
}

//------------------------------------------------------------------------------
std::vector<vtkTypeUInt64> vtkTranslucencyFrame::GetFingerprint() const
{
  // Gives new props room for a pass's key, which modifies them once.
  this->Resources.Mappers->Draw(this->State, [] {});
  vtkTranslucencyFingerprint fingerprint;
  for (int number : this->GetViewport())
  {
    fingerprint.Add(number);
  }
  fingerprint.Add(this->Shaders->GetContext().TargetSamples);
  fingerprint.AddView(this->State);
  return fingerprint.GetNumbers();
}

//------------------------------------------------------------------------------
int vtkTranslucencyFrame::GetSamples() const
{
  return this->Shaders->GetContext().Samples;
}

//------------------------------------------------------------------------------
int vtkTranslucencyFrame::GetChannels() const
{
  return this->Shaders->GetContext().Channels;
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Blending vtkTranslucencyFrame::GetOver() const
{
  return this->GetChannels() == 3 ? Blending::Filter : Blending::Over;
}

//------------------------------------------------------------------------------
const vtkTranslucencyFrame::Rectangle& vtkTranslucencyFrame::GetTile() const
{
  return this->Tiles.GetTile();
}

//------------------------------------------------------------------------------
const vtkTranslucencyFrame::Rectangle& vtkTranslucencyFrame::GetViewport() const
{
  return this->Tiles.GetViewport();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::NextTile()
{
  return this->Tiles.Next();
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::SetSample(int sample, int among)
{
  this->Resolver->SetSample(sample, among);
}

//------------------------------------------------------------------------------
int vtkTranslucencyFrame::GetSample() const
{
  return this->Resolver->GetSample();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::ReserveSampleColors()
{
  return this->GetSamples() == 1 || this->Resolver->ReserveSampleColors(this->GetSamples(), this->GetChannels()) ||
    this->Fail("the driver has no memory for the colours of the samples");
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::CompositeSamples()
{
  this->SetSample(WholePixel);
  return this->Resolve("Common/CompositeSamples.glsl", {}, Squares::LeftTo(LEVEL_SAMPLES));
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::IsLeftTo(int level)
{
  return this->IsComplete() && this->Resources.Resolved.IsLeftTo(level);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::IsLeftTo(const Squares& squares)
{
  return this->IsComplete() &&
    (this->Storage->GetMostExpected() > squares.Fewer || this->Resources.Resolved.IsLeftTo(squares.Level));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyFrame::GetDeepestPixel()
{
  return this->Resources.Resolved.GetDeepestPixel();
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::Blend()
{
  this->UseTile();
  vtkTranslucencyGLState::UsePlainBlending(this->Window->GetState());
  this->Pass->GetTranslucentPass()->Render(this->State);
  if (!this->Tiles.IsFinished()) // else the next frame would leave it out
  {
    this->Tiles.Finish();
  }
}
VTK_ABI_NAMESPACE_END
