// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Times of several techniques, taken in turn (A B C A B C ...), so that what disturbs the machine disturbs all alike.
 */
#ifndef Benchmark_h
#define Benchmark_h

#include "Stage.h"

#include <optional>
#include <string>
#include <vector>

struct Timing
{
  double First = 0;           ///< milliseconds of the very first frame, in which shaders are built
  std::vector<double> Frames; ///< milliseconds of each frame, in the order in which they were drawn
  double LowerQuartile = 0;
  double Median = 0;
  double UpperQuartile = 0;
  double Slowest = 0;
  std::optional<double> RatioToBlend; ///< of the medians
  std::optional<StageTimes> Stages;   ///< medians
  FrameStatistics Statistics;         ///< of the last frame
  std::optional<StorageCounts> Storage;
};

struct BenchmarkSettings
{
  int Frames = 20;
  int Warmup = 3;
  double Orbit = 0; ///< degrees that the camera goes round the scene while Frames are timed
};

/// Times the techniques of these numbers. Before Warmup each draws its first frame. Half as many frames more, in turn
/// as well, are drawn with timers of their stages: these cost time themselves, and so are no part of Frames.
std::vector<Timing> Measure(Stage& stage, const std::vector<TechniqueChoice>& techniques,
  const std::vector<int>& numbers, const BenchmarkSettings& settings);

#endif
