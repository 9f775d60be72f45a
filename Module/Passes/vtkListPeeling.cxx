// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkListPeeling.h"

#include "vtkTranslucencyFrame.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Blending = vtkTranslucencyFrame::Blending;

// Shaders/Peel/LayerLists.glsl
constexpr float NoDepth = 1e30f;
constexpr int Outputs = 8;
constexpr int Buckets = 2;
constexpr int FirstLayer = Buckets;
constexpr int ListTailStage = 1;

// The targets of a state.
constexpr int FrontLayers = 0;
constexpr int BackLayers = 1;
constexpr int FirstList = 2;
constexpr int SecondList = 3;
constexpr int StateTargets = 4;
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyStage::Input> vtkListPeeling::GetLists() const
{
  const vtkTranslucencyTargets* state = &this->States[this->Current];
  return { { "firstList", state, FirstList }, { "secondList", state, SecondList } };
}

//------------------------------------------------------------------------------
bool vtkListPeeling::Render(vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings)
{
  // Where some layers only are peeled, those are the nearest.
  vtkTranslucencyGathering gathering{ "Peel/GatherLists.glsl",
    { { "PEEL_SIDES", settings.Layers == 0 ? "2" : "1" }, { "PEEL_LAYERS", std::to_string(settings.Layers) } },
    Outputs };
  gathering.Rejects = true;
  for (vtkTranslucencyTargets& state : this->States)
  {
    if (!frame.UseTargets(state, std::vector<int>(StateTargets, 4)))
    {
      return false;
    }
  }
  const bool tail = settings.Layers > 0 && settings.AveragesTail;
  if (!frame.UseTargets(this->Drawn, std::vector<int>(Outputs, 4)) || !this->Peel(frame, gathering) ||
    (tail && !this->AddTail(frame, gathering)))
  {
    return false;
  }
  std::vector<vtkTranslucencyFrame::Input> inputs{ { "frontLayers", &this->States[this->Current], FrontLayers },
    { "backLayers", &this->States[this->Current], BackLayers } };
  if (tail)
  {
    inputs.push_back({ "tailOpacities", &this->Drawn, 0 });
    inputs.push_back({ "tailColors", &this->Drawn, FirstLayer });
  }
  return frame.Composite(
    "Peel/Resolve.glsl", { { "PEEL_METHOD", "PEEL_DUAL" }, { "PEEL_TAIL", tail ? "1" : "0" } }, inputs);
}

//------------------------------------------------------------------------------
bool vtkListPeeling::Peel(vtkTranslucencyFrame& frame, const vtkTranslucencyGathering& gathering)
{
  vtkTranslucencyFrame::Stage start;
  start.Targets = &this->States[this->Current];
  start.Clear = { { 0, 0, 0, 1 } };
  start.Differing[BackLayers] = { Blending::Replace, {} };
  start.Differing[FirstList] = { Blending::Replace, { { NoDepth, NoDepth, NoDepth, -NoDepth } } };
  const float last = gathering.Values.at("PEEL_SIDES") == "2" ? NoDepth : 0; // depth, or the number of layers
  start.Differing[SecondList] = { Blending::Replace, { { NoDepth, NoDepth, NoDepth, last } } };

  vtkTranslucencyFrame::Stage peel;
  peel.Targets = &this->Drawn;
  peel.Blend = Blending::Over;
  for (int bucket = 0; bucket < Buckets; ++bucket)
  {
    peel.Differing[bucket] = { Blending::Maximum, { { -NoDepth, -NoDepth, -NoDepth, -NoDepth } } };
  }
  vtkTranslucencyFrame::Stage merge;
  merge.Blend = Blending::Replace;
  merge.Cleared = 0;
  vtkTranslucencyFrame::Stage look;

  bool good = frame.Clear(start);
  bool left = good;
  for (int drawing = 0; left && good; ++drawing)
  {
    peel.Values["peelDrawing"] = drawing;
    peel.Inputs = this->GetLists();
    merge.Inputs = this->GetLists();
    merge.Inputs.push_back({ "frontLayers", &this->States[this->Current], FrontLayers });
    merge.Inputs.push_back({ "backLayers", &this->States[this->Current], BackLayers });
    merge.Inputs.push_back({ "firstBuckets", &this->Drawn, 0 });
    merge.Inputs.push_back({ "secondBuckets", &this->Drawn, 1 });
    for (int layer = 0; layer < Outputs - Buckets; ++layer)
    {
      merge.Inputs.push_back({ "listed" + std::to_string(layer), &this->Drawn, FirstLayer + layer });
    }
    this->Current = 1 - this->Current;
    merge.Targets = &this->States[this->Current];
    look.Inputs = this->GetLists();
    good = (drawing < vtkPeelingSettings::MostLayers || frame.Fail(vtkPeelingSettings::GetTooMany())) &&
      frame.Draw(gathering, peel) && frame.DrawScreen("Peel/MergeLists.glsl", gathering.Values, merge) &&
      frame.DrawScreen("Peel/AnyLeft.glsl", gathering.Values, look, &left);
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkListPeeling::AddTail(vtkTranslucencyFrame& frame, const vtkTranslucencyGathering& gathering)
{
  vtkTranslucencyFrame::Stage sums;
  sums.Number = ListTailStage;
  sums.Targets = &this->Drawn;
  sums.Blend = Blending::AddAndAttenuate;
  sums.Clear = { { 0, 0, 0, 1 } };
  sums.Differing[0] = { Blending::Add, {} };
  sums.Inputs = this->GetLists();
  return frame.Draw(gathering, sums);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkListPeeling::GetBytes() const
{
  return this->Drawn.GetBytes() + this->States[0].GetBytes() + this->States[1].GetBytes();
}

//------------------------------------------------------------------------------
void vtkListPeeling::Release(bool contextAlive)
{
  this->Drawn.Release(contextAlive);
  for (vtkTranslucencyTargets& state : this->States)
  {
    state.Release(contextAlive);
  }
}
VTK_ABI_NAMESPACE_END
