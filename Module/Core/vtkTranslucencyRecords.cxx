// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyRecords.h"

#include "Common/Bindings.glsl"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFrameShaders.h"
#include "vtkTranslucencyTiles.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTranslucencyRecords::vtkTranslucencyRecords(
  const vtkTranslucencyCapabilities& capabilities, vtkTranslucencyTiles& tiles, vtkTranslucencyFrameShaders& shaders)
  : Capabilities(capabilities)
  , Tiles(tiles)
  , Shaders(shaders)
{
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyRecords::Reserve(vtkTranslucencyPixels& pixels, int words, double memoryLimit,
  const vtkTranslucencyPixels::Fetched& fetched, bool mayFetch, bool zeroed)
{
  using Size = vtkTranslucencyPixels::Size;
  this->Tiles.UseWholeViewport();
  vtkTranslucencyFrameShaders::Context& context = this->Shaders.GetContext();
  const auto limit = static_cast<vtkTypeInt64>(this->Capabilities.GetLimitBytes(memoryLimit));
  this->EmptyWords = fetched.Empty;
  this->Fetched =
    mayFetch && fetched.Words > 0 && this->Fetch(pixels, fetched.Words, limit) ? &pixels.GetTargets() : nullptr;
  this->Stored = !this->Fetched;
  context.RecordTargets = this->Fetched ? this->Fetched->GetCount() : 0;
  if (this->Fetched)
  {
    return "";
  }
  const bool locks = this->Shaders.GetCriticalSection() == "Spinlock";
  for (;;)
  {
    const vtkTranslucencyTiles::Rectangle& tile = this->Tiles.GetTile();
    const Size size = vtkTranslucencyPixels::GetSize(tile, context.Samples, words, locks);
    const vtkTypeInt64 parts = std::max((size.Sum() + limit - 1) / limit,
      (size.Records + this->Capabilities.MaximumBlockBytes - 1) / this->Capabilities.MaximumBlockBytes);
    const bool smallest = this->Tiles.IsSmallest();
    if (parts <= 1 || smallest)
    {
      if (size.Sum() > limit)
      {
        return "a memory limit of " + std::to_string(limit) + " bytes is too small, expected at least " +
          std::to_string(size.Sum()) + " bytes for a pixel and its neighbours";
      }
      if (pixels.Begin(size, zeroed))
      {
        return "";
      }
      if (smallest)
      {
        return "the driver has no memory for the records of one pixel";
      }
    }
    this->Tiles.Cut(static_cast<int>(std::clamp<vtkTypeInt64>(parts, 2, tile[2] * tile[3])));
  }
}

//------------------------------------------------------------------------------
// Whether they can lie in colours: makes room for them if so.
bool vtkTranslucencyRecords::Fetch(vtkTranslucencyPixels& pixels, int words, vtkTypeInt64 limit) const
{
  const vtkTranslucencyTiles::Rectangle& viewport = this->Tiles.GetViewport();
  const int width = viewport[0] + viewport[2];
  const int height = viewport[1] + viewport[3];
  return this->Capabilities.MissingForFetch.empty() && this->Shaders.GetContext().TargetSamples == 1 &&
    vtkTranslucencyPixels::CountTargets(words) <= this->Capabilities.MaximumTargets &&
    vtkTranslucencyPixels::GetTargetBytes(width, height, words) <= limit && pixels.BeginTargets(width, height, words);
}

//------------------------------------------------------------------------------
vtkTranslucencyStage vtkTranslucencyRecords::GetStage(const vtkTranslucencyStage& stage) const
{
  vtkTranslucencyStage fetched = stage;
  fetched.Targets = this->Fetched;
  fetched.Blend = vtkTranslucencyStage::Blending::Replace;
  fetched.Clear.fill(EMPTY_NUMBER);
  fetched.Cleared = stage.Number == 0 ? vtkTranslucencyPixels::CountTargets(this->EmptyWords) : 0;
  return fetched;
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyStage::Input> vtkTranslucencyRecords::GetInputs() const
{
  std::vector<vtkTranslucencyStage::Input> inputs;
  for (int i = 0; this->Fetched && i < this->Fetched->GetCount(); ++i)
  {
    inputs.push_back({ "recordTarget" + std::to_string(i), this->Fetched, i });
  }
  return inputs;
}
VTK_ABI_NAMESPACE_END
