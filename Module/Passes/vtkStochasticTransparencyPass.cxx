// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStochasticTransparencyPass.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <numeric>
#include <random>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkStochasticTransparencyPass);

namespace
{
constexpr int LeastDepthSamples = 4;
constexpr int MostDepthSamples = 64;
constexpr int MostSamplesOfRound = 32;
constexpr int BufferSamples = 4;
constexpr int MostFrames = 65536; // single precision has room for the sums of more
constexpr int RowPatterns = 64;   // a multiple of 4 and a power of two

// The table of Stochastic/Mask.glsl: row n holds patterns of n set bits, the first n of random permutations of the
// samples.
std::vector<unsigned int> MakePatterns(int samples)
{
  std::vector<unsigned int> patterns((samples + 1) * RowPatterns, 0);
  std::mt19937 random(1); // std::shuffle is not the same in every library
  std::vector<int> order(samples);
  for (int column = 0; column < RowPatterns; ++column)
  {
    std::iota(order.begin(), order.end(), 0);
    for (int count = 1; count <= samples; ++count)
    {
      const int left = samples - count + 1;
      std::swap(order[count - 1], order[count - 1 + static_cast<int>(random() % left)]);
      patterns[count * RowPatterns + column] = patterns[(count - 1) * RowPatterns + column] | 1u << order[count - 1];
    }
  }
  return patterns;
}
}

//------------------------------------------------------------------------------
vtkStochasticTransparencyPass::~vtkStochasticTransparencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkStochasticTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DepthSamples: " << this->DepthSamples << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "AlphaCorrection: " << (this->AlphaCorrection ? "on" : "off") << "\n";
  os << indent << "Accumulate: " << this->Accumulate << "\n";
  os << indent << "AccumulatedFrames: " << this->AccumulatedFrames << "\n";
}

//------------------------------------------------------------------------------
void vtkStochasticTransparencyPass::SetDepthSamples(int samples)
{
  const int step = samples > MostSamplesOfRound ? 2 * BufferSamples : BufferSamples;
  if (samples < LeastDepthSamples || samples > MostDepthSamples || samples % step != 0)
  {
    vtkErrorMacro(<< "DepthSamples is " << samples << ", expected a multiple of " << BufferSamples << " in "
                  << LeastDepthSamples << " to " << MostSamplesOfRound << ", or of " << 2 * BufferSamples << " up to "
                  << MostDepthSamples);
    return;
  }
  vtkTranslucencyOption::SetProperty(
    this, vtkStochasticTransparencyPass::GetOptions(), "DepthSamples", this->DepthSamples, samples);
}

//------------------------------------------------------------------------------
void vtkStochasticTransparencyPass::SetSeed(int seed)
{
  vtkTranslucencyOption::SetProperty(this, vtkStochasticTransparencyPass::GetOptions(), "Seed", this->Seed, seed);
}

//------------------------------------------------------------------------------
void vtkStochasticTransparencyPass::SetAlphaCorrection(bool correction)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkStochasticTransparencyPass::GetOptions(), "AlphaCorrection", this->AlphaCorrection, correction);
}

//------------------------------------------------------------------------------
void vtkStochasticTransparencyPass::SetAccumulate(int frames)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkStochasticTransparencyPass::GetOptions(), "Accumulate", this->Accumulate, frames);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkStochasticTransparencyPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "DepthSamples", "depth_samples", Kind::Integer, 8, LeastDepthSamples, MostDepthSamples, {},
             "depth samples of a pixel, a multiple of 4, above 32 of 8: more mean less noise, and more time and memory",
             [this] { return this->GetDepthSamples(); },
             [this](double value) { this->SetDepthSamples(static_cast<int>(value)); } },
    { "Seed", "seed", Kind::Integer, 0, 0, VTK_INT_MAX, {}, "which random numbers are taken",
      [this] { return this->GetSeed(); }, [this](double value) { this->SetSeed(static_cast<int>(value)); } },
    { "AlphaCorrection", "alpha_correction", Kind::Choice, 1, 0, 1, { "off", "on" },
      "whether colours are scaled to the pixel's exact opacity: much less noise; off, each frame is right on average",
      [this] { return this->GetAlphaCorrection(); }, [this](double value) { this->SetAlphaCorrection(value != 0); } },
    { "Accumulate", "accumulate", Kind::Integer, 1, 1, MostFrames, {},
      "frames over which a still view is refined; 1 means that each frame stands for itself",
      [this] { return this->GetAccumulate(); },
      [this](double value) { this->SetAccumulate(static_cast<int>(value)); } } };
}

//------------------------------------------------------------------------------
int vtkStochasticTransparencyPass::GetRounds() const
{
  return this->DepthSamples > MostSamplesOfRound ? 2 : 1;
}

//------------------------------------------------------------------------------
bool vtkStochasticTransparencyPass::RenderStages(vtkTranslucencyFrame& frame)
{
  if (!this->StartFrame(frame))
  {
    return false;
  }
  if (this->AccumulatedFrames < this->Accumulate)
  {
    for (int round = 0; round < this->GetRounds(); ++round)
    {
      if (!this->DrawRound(frame, round))
      {
        this->AccumulatedFrames = 0;
        this->Accumulated.clear();
        return false;
      }
    }
    ++this->AccumulatedFrames;
  }
  const vtkTranslucencyFrame::Defines correction{ { "ALPHA_CORRECTION", this->AlphaCorrection ? "1" : "0" } };
  std::vector<vtkTranslucencyFrame::Input> sums{ { "stochasticColors", &this->Sums, 0 } };
  if (this->AlphaCorrection)
  {
    sums.push_back({ "stochasticWeights", &this->Sums, 1 });
  }
  return frame.Composite("Stochastic/Resolve.glsl", correction, sums,
    { { "stochasticShare", 1.0f / static_cast<float>(this->AccumulatedFrames * this->GetRounds()) } });
}

//------------------------------------------------------------------------------
// Goes on with the frames so far if they show the same as this one.
bool vtkStochasticTransparencyPass::StartFrame(vtkTranslucencyFrame& frame)
{
  std::vector<int> sums{ 4 };
  if (this->AlphaCorrection)
  {
    sums.push_back(1);
  }
  const std::vector<int> depths(this->GetSamplesOfRound() / BufferSamples, BufferSamples);
  const std::size_t patterns = static_cast<std::size_t>((this->GetSamplesOfRound() + 1) * RowPatterns);
  if (this->Patterns.size() != patterns)
  {
    this->Patterns = MakePatterns(this->GetSamplesOfRound());
  }
  if (!frame.UseTargets(this->Sums, sums) || !frame.UseTargets(this->Depths, depths) ||
    !frame.UseTable(this->PatternTable, RowPatterns, this->Patterns))
  {
    return false;
  }
  std::vector<vtkTypeUInt64> shown;
  if (this->Accumulate > 1)
  {
    shown = frame.GetFingerprint();
    shown.push_back(this->GetMTime());
  }
  if (shown.empty() || shown != this->Accumulated)
  {
    this->AccumulatedFrames = 0;
    this->Accumulated = shown;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkStochasticTransparencyPass::DrawRound(vtkTranslucencyFrame& frame, int round)
{
  const vtkTranslucencyFrame::Gathering gathering{ "Stochastic/Gather.glsl",
    { { "DEPTH_SAMPLES", std::to_string(this->GetSamplesOfRound()) }, { "PATTERNS", std::to_string(RowPatterns) } },
    std::max(2, this->GetSamplesOfRound() / BufferSamples) };
  const bool first = this->AccumulatedFrames == 0 && round == 0;

  vtkTranslucencyFrame::Stage depths;
  depths.Number = 0;
  depths.Targets = &this->Depths;
  depths.Blend = vtkTranslucencyFrame::Blending::Minimum;
  depths.Clear = { { 1, 1, 1, 1 } };
  // Frames take seeds that follow each other, and rounds what lies between.
  const unsigned int seed =
    2u * (static_cast<unsigned int>(this->Seed) + static_cast<unsigned int>(this->AccumulatedFrames)) +
    static_cast<unsigned int>(round);
  depths.Values = { { "stochasticSeed", static_cast<int>(seed) } };

  vtkTranslucencyFrame::Stage sums;
  sums.Number = 1;
  sums.Targets = &this->Sums;
  sums.Blend = vtkTranslucencyFrame::Blending::AddAndAttenuate;
  sums.Clear = { { 0, 0, 0, 1 } };
  sums.Cleared = first ? VTK_INT_MAX : 0;
  sums.Values = { { "stochasticAttenuation", first ? 1.0f : 0.0f } };
  for (int i = 0; i < this->GetSamplesOfRound() / BufferSamples; ++i)
  {
    const std::string sampler = "stochasticDepths[" + std::to_string(i) + "]";
    sums.Inputs.push_back({ sampler, &this->Depths, i });
    depths.Inputs.push_back(
      { sampler, &this->Sums, 0 }); // not read, but a sampler has to be bound to something of its type
  }
  for (vtkTranslucencyFrame::Stage* stage : { &depths, &sums })
  {
    stage->Inputs.push_back({ "stochasticPatterns", &this->PatternTable, 0 });
  }
  return frame.Draw(gathering, depths) && frame.Draw(gathering, sums);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkStochasticTransparencyPass::GetTechniqueBytes()
{
  return this->Depths.GetBytes() + this->Sums.GetBytes() + this->PatternTable.GetBytes();
}

//------------------------------------------------------------------------------
void vtkStochasticTransparencyPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Depths.Release(contextAlive);
  this->Sums.Release(contextAlive);
  this->PatternTable.Release(contextAlive);
  this->AccumulatedFrames = 0;
  this->Accumulated.clear();
}
VTK_ABI_NAMESPACE_END
