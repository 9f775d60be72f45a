// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmark.h"

#include "Basics/Progress.h"

#include <algorithm>
#include <cmath>

namespace
{
// Part in 0..1 of the sorted values, between two of them where it falls there.
double Quantile(std::vector<double> values, double part)
{
  if (values.empty())
  {
    return 0;
  }
  std::sort(values.begin(), values.end());
  const double position = part * (values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(position));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (position - below) * (values[above] - values[below]);
}

void MeasureStages(Stage& stage, const std::vector<TechniqueChoice>& techniques, const std::vector<int>& numbers,
  int rounds, Progress& progress, std::vector<Timing>& timings)
{
  std::vector<std::vector<double>> gather(numbers.size());
  std::vector<std::vector<double>> resolve(numbers.size());
  for (int round = 0; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      progress.Step(techniques[i].Label + ", stages");
      if (const auto times = stage.DrawMeasured(numbers[i]))
      {
        gather[i].push_back(times->Gather);
        resolve[i].push_back(times->Resolve);
      }
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (!gather[i].empty())
    {
      timings[i].Stages = StageTimes{ Quantile(gather[i], 0.5), Quantile(resolve[i], 0.5) };
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<Timing> Measure(Stage& stage, const std::vector<TechniqueChoice>& techniques,
  const std::vector<int>& numbers, const BenchmarkSettings& settings)
{
  std::vector<Timing> timings(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    timings[i].First = stage.Draw(numbers[i]);
    stage.Settle(numbers[i]);
  }
  const int rounds = settings.Warmup + settings.Frames;
  const int stageRounds = settings.Frames / 2 + 1;
  Progress progress("frames", (rounds + stageRounds) * static_cast<int>(numbers.size()));
  for (int round = 0; round < rounds; ++round)
  {
    if (round >= settings.Warmup)
    {
      stage.Orbit(settings.Orbit / settings.Frames);
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      progress.Step(techniques[i].Label);
      const double milliseconds = stage.Draw(numbers[i]);
      if (round >= settings.Warmup)
      {
        timings[i].Frames.push_back(milliseconds);
      }
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    timings[i].Statistics = stage.GetStatistics(numbers[i]);
  }
  MeasureStages(stage, techniques, numbers, stageRounds, progress, timings);
  const Timing* blend = nullptr;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    Timing& timing = timings[i];
    timing.LowerQuartile = Quantile(timing.Frames, 0.25);
    timing.Median = Quantile(timing.Frames, 0.5);
    timing.UpperQuartile = Quantile(timing.Frames, 0.75);
    timing.Slowest = Quantile(timing.Frames, 1);
    blend = techniques[i].Name == "blend" ? &timing : blend;
    timing.Storage = stage.CountStorage(numbers[i]); // last: it draws by other shaders
  }
  for (Timing& timing : timings)
  {
    if (blend && blend->Median > 0)
    {
      timing.RatioToBlend = timing.Median / blend->Median;
    }
  }
  return timings;
}
