#include "Benchmark.h"

#include "Progress.h"

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

void MeasureStages(Stage& stage, int number, int frames, Timing& timing)
{
  std::vector<double> gather;
  std::vector<double> resolve;
  for (int frame = 0; frame < frames; ++frame)
  {
    const auto times = stage.DrawMeasured(number);
    if (!times)
    {
      return;
    }
    gather.push_back(times->Gather);
    resolve.push_back(times->Resolve);
  }
  if (!gather.empty())
  {
    timing.Stages = StageTimes{ Quantile(gather, 0.5), Quantile(resolve, 0.5) };
  }
}
}

//------------------------------------------------------------------------------
std::vector<Timing> Measure(Stage& stage, const std::vector<TechniqueChoice>& techniques,
  const std::vector<int>& numbers, const BenchmarkSettings& settings)
{
  std::vector<Timing> timings(numbers.size());
  for (int number : numbers)
  {
    stage.Settle(number);
  }
  const int rounds = settings.Warmup + settings.Frames;
  Progress progress("frames", (rounds + 1) * static_cast<int>(numbers.size()));
  for (int round = 0; round < rounds; ++round)
  {
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
  const Timing* blend = nullptr;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    Timing& timing = timings[i];
    timing.LowerQuartile = Quantile(timing.Frames, 0.25);
    timing.Median = Quantile(timing.Frames, 0.5);
    timing.UpperQuartile = Quantile(timing.Frames, 0.75);
    timing.Statistics = stage.GetStatistics(numbers[i]);
    blend = techniques[i].Name == "blend" ? &timing : blend;
    progress.Step(techniques[i].Label + ", stages");
    MeasureStages(stage, numbers[i], settings.StageFrames, timing);
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
