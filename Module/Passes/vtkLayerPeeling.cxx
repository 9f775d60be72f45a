// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLayerPeeling.h"

#include "vtkTranslucencyFrame.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Blending = vtkTranslucencyFrame::Blending;

// Shaders/Peel/Methods.glsl
constexpr std::array<float, 4> NoBounds{ { -1e30f, -1e30f, 0, 0 } };
constexpr std::array<float, 4> AllWithin{ { 1e30f, 1e30f, 0, 0 } };
constexpr int PeelStage = 0;
constexpr int TailStage = 1;

// The buffers of both targets.
constexpr int BoundsTarget = 0;
constexpr int Front = 1;
constexpr int Back = 2;

// A premultiplied colour in floats as one in bytes that is not.
vtkSmartPointer<vtkImageData> NewImage(const std::array<int, 4>& rectangle, const std::vector<float>& colors)
{
  constexpr float Most = 255;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(rectangle[2], rectangle[3], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const float alpha = colors[i / 4 * 4 + 3];
    const float divisor = i % 4 == 3 || alpha <= 0 ? 1 : alpha;
    bytes[i] = static_cast<unsigned char>(std::lround(Most * std::clamp(colors[i] / divisor, 0.0f, 1.0f)));
  }
  return image;
}
}

//------------------------------------------------------------------------------
vtkTranslucencyShader::Defines vtkLayerPeeling::GetMethod() const
{
  return { { "PEEL_METHOD", this->Dual ? "PEEL_DUAL" : "PEEL_FRONT_TO_BACK" } };
}

//------------------------------------------------------------------------------
vtkTranslucencyGathering vtkLayerPeeling::GetGathering() const
{
  vtkTranslucencyGathering gathering{ "Peel/Gather.glsl", this->GetMethod() };
  gathering.Outputs = this->Dual ? 3 : 2;
  gathering.Rejects = true;
  return gathering;
}

//------------------------------------------------------------------------------
bool vtkLayerPeeling::Render(
  vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings, bool dual, bool keepLayers)
{
  this->Dual = dual;
  const std::vector<int> formats = dual ? std::vector<int>{ 2, 4, 4 } : std::vector<int>{ 1, 4 };
  bool left = false;
  if (!frame.UseTargets(this->Peeled, formats) || !frame.UseTargets(this->Merged, formats) ||
    !this->Peel(frame, settings, keepLayers && !dual, left))
  {
    return false;
  }
  const bool tail = left && settings.AveragesTail;
  if (tail && !this->AddTail(frame))
  {
    return false;
  }
  std::vector<vtkTranslucencyFrame::Input> inputs{ { "frontLayers", &this->Merged, Front } };
  if (dual)
  {
    inputs.push_back({ "backLayers", &this->Merged, Back });
  }
  if (tail)
  {
    inputs.push_back({ "tailOpacities", &this->Peeled, BoundsTarget });
    inputs.push_back({ "tailColors", &this->Peeled, Front });
  }
  vtkTranslucencyFrame::Defines defines = this->GetMethod();
  defines["PEEL_TAIL"] = tail ? "1" : "0";
  return frame.Composite("Peel/Resolve.glsl", defines, inputs);
}

//------------------------------------------------------------------------------
bool vtkLayerPeeling::Peel(vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings, bool keepLayers, bool& left)
{
  vtkTranslucencyFrame::Stage peel;
  peel.Number = PeelStage;
  peel.Targets = &this->Peeled;
  peel.Blend = Blending::Over;
  peel.Differing[BoundsTarget] = { Blending::Maximum, NoBounds };
  peel.Inputs = { { "peelBounds", &this->Merged, BoundsTarget } };

  vtkTranslucencyFrame::Stage merge;
  merge.Targets = &this->Merged;
  merge.Blend = Blending::Under;
  merge.Clear = { { 0, 0, 0, 1 } };
  merge.Differing[BoundsTarget] = { Blending::Minimum, AllWithin };
  merge.Inputs = { { "nextBounds", &this->Peeled, BoundsTarget }, { "frontLayer", &this->Peeled, Front } };
  if (this->Dual)
  {
    merge.Differing[Back] = { Blending::Over, {} };
    merge.Inputs.push_back({ "backLayer", &this->Peeled, Back });
  }

  // The first drawing finds bounds only. The others take a layer off, or two.
  const int layers = settings.Layers == 0 ? vtkPeelingSettings::MostLayers : settings.Layers;
  const int most = 1 + (this->Dual ? (layers + 1) / 2 : layers);
  left = frame.Clear(merge);
  merge.Cleared = 0;
  bool good = left;
  for (int drawing = 0; left && good && drawing < most; ++drawing)
  {
    good = frame.Draw(this->GetGathering(), peel, &left);
    if (good && left)
    {
      good = frame.DrawScreen("Peel/Merge.glsl", this->GetMethod(), merge) &&
        (drawing == 0 || !keepLayers || this->KeepLayer(frame));
    }
  }
  return good && (settings.Layers > 0 || !left || frame.Fail(vtkPeelingSettings::GetTooMany()));
}

//------------------------------------------------------------------------------
bool vtkLayerPeeling::KeepLayer(vtkTranslucencyFrame& frame)
{
  const std::vector<float> colors = frame.Read(this->Peeled, Front);
  if (!colors.empty())
  {
    this->Images.push_back(NewImage(frame.GetTile(), colors));
  }
  return !colors.empty();
}

//------------------------------------------------------------------------------
bool vtkLayerPeeling::AddTail(vtkTranslucencyFrame& frame)
{
  vtkTranslucencyFrame::Stage sums;
  sums.Number = TailStage;
  sums.Targets = &this->Peeled;
  sums.Blend = Blending::AddAndAttenuate;
  sums.Clear = { { 0, 0, 0, 1 } };
  sums.Differing[BoundsTarget] = { Blending::Add, {} };
  sums.Inputs = { { "peelBounds", &this->Merged, BoundsTarget } };
  return frame.Draw(this->GetGathering(), sums);
}

//------------------------------------------------------------------------------
void vtkLayerPeeling::Release(bool contextAlive)
{
  this->Peeled.Release(contextAlive);
  this->Merged.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
