// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiLayerAlphaBlendingPass.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkMultiLayerAlphaBlendingPass);

namespace
{
constexpr int LeastLayers = 1;
constexpr int MostLayers = 32;

// MultiLayer/Layers.glsl
int WordsOfLayer(int channels, bool bytes)
{
  return 1 + (bytes ? 1 : 2) + (channels == 3 ? 1 : 0);
}

int WordsOfAverage(int channels)
{
  return 3 + 2 * channels;
}

const char* const Tails[] = { "TAIL_MERGE", "TAIL_DROP", "TAIL_AVERAGE" };
}

//------------------------------------------------------------------------------
vtkMultiLayerAlphaBlendingPass::vtkMultiLayerAlphaBlendingPass(int tail)
  : DefaultTail(tail)
  , Tail(tail)
{
}

//------------------------------------------------------------------------------
vtkMultiLayerAlphaBlendingPass::~vtkMultiLayerAlphaBlendingPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Tail: " << Tails[this->Tail] << "\n";
  os << indent << "ColorFormat: " << (this->ColorFormat == RGBA8 ? "RGBA8" : "HalfFloat") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::SetLayers(int layers)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkMultiLayerAlphaBlendingPass::GetOptions(), "Layers", this->Layers, layers);
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::SetTail(int tail)
{
  vtkTranslucencyOption::SetProperty(this, vtkMultiLayerAlphaBlendingPass::GetOptions(), "Tail", this->Tail, tail);
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::SetColorFormat(int format)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkMultiLayerAlphaBlendingPass::GetOptions(), "ColorFormat", this->ColorFormat, format);
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::SetMemoryLimit(double mebibytes)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkMultiLayerAlphaBlendingPass::GetOptions(), "MemoryLimit", this->MemoryLimit, mebibytes);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkMultiLayerAlphaBlendingPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "Layers", "layers", Kind::Integer, 4, LeastLayers, MostLayers, {}, "layers of a pixel",
             [this] { return this->GetLayers(); }, [this](double value) { this->SetLayers(static_cast<int>(value)); } },
    { "Tail", "tail", Kind::Choice, static_cast<double>(this->DefaultTail), 0, 2, { "merge", "drop", "average" },
      "what becomes of fragments behind the layers: merged into the last, left out, or averaged behind it",
      [this] { return this->GetTail(); }, [this](double value) { this->SetTail(static_cast<int>(value)); } },
    this->GetCriticalSectionOption(),
    { "ColorFormat", "color_format", Kind::Choice, 0, 0, 1, { "half-float", "rgba8" },
      "half floats keep colours above 1 and small opacities; rgba8 takes two thirds of the memory, and rounds at each "
      "merging",
      [this] { return this->GetColorFormat(); },
      [this](double value) { this->SetColorFormat(static_cast<int>(value)); } },
    vtkTranslucencyOption::NewMemoryLimit(
      "layers", [this] { return this->GetMemoryLimit(); }, [this](double value) { this->SetMemoryLimit(value); }) };
}

//------------------------------------------------------------------------------
bool vtkMultiLayerAlphaBlendingPass::UsesStorage(const vtkTranslucencyCapabilities&) const
{
  return true;
}

//------------------------------------------------------------------------------
std::string vtkMultiLayerAlphaBlendingPass::FindMissing(const vtkTranslucencyCapabilities& capabilities) const
{
  const std::string missing = this->Superclass::FindMissing(capabilities);
  return missing.empty() ? this->FindMissingForCriticalSection(capabilities) : missing;
}

//------------------------------------------------------------------------------
bool vtkMultiLayerAlphaBlendingPass::RenderStages(vtkTranslucencyFrame& frame)
{
  const vtkTranslucencyFrame::Defines layers{ { "LAYERS", std::to_string(this->Layers) }, { "TAIL", Tails[this->Tail] },
    { "COLOR_FORMAT", this->ColorFormat == RGBA8 ? "COLOR_FORMAT_RGBA8" : "COLOR_FORMAT_HALF_FLOAT" } };
  const int channels = frame.GetChannels();
  const int words = this->Layers * WordsOfLayer(channels, this->ColorFormat == RGBA8) +
    (this->Tail == Average ? WordsOfAverage(channels) : 0);
  const int empty = this->Layers + (this->Tail == Average ? 1 : 0); // MultiLayer/Layers.glsl
  vtkTranslucencyFrame::Gathering gathering{ "MultiLayer/Gather.glsl", layers };
  gathering.Critical = true;
  return frame.UsePixels(this->Pixels, words, this->MemoryLimit, { words, empty }) && frame.Draw(gathering, {}) &&
    frame.Composite("MultiLayer/Resolve.glsl", layers, {});
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMultiLayerAlphaBlendingPass::GetTechniqueBytes()
{
  return this->Pixels.GetBytes();
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Pixels.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
