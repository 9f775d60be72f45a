// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The command line.
 */
#ifndef Arguments_h
#define Arguments_h

#include "Scenes/Inputs.h"
#include "Techniques/Benchmark.h"

#include "vtkStorageAccounting.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

enum class Action
{
  List,
  Render,
  Compare,
  Bench,
  Run,
  Schema,
  Storage,
  Trace,
  Probe,
};

struct Arguments
{
  Action Do = Action::List;
  bool Json = false; ///< list: as JSON

  // what is drawn
  std::vector<Input> Inputs;
  std::optional<std::string> SceneFile;
  std::optional<std::string> Title;
  std::optional<std::array<int, 2>> Size;
  int Samples = 1;
  std::optional<Background> Behind;
  std::optional<double> Azimuth;
  std::optional<double> Elevation;
  std::optional<double> Zoom;

  // how
  std::vector<std::string> Techniques;         ///< one for render and run; empty: all
  std::map<std::string, std::string> Settings; ///< render, run: keyword and value
  std::string Reference = "exact";
  BenchmarkSettings Frames;

  std::vector<std::string> Program; ///< run: with its arguments
  bool Always = false;              ///< run: whether or not it asks for depth peeling

  // storage
  std::string Measured; ///< a histogram or a trace, if it is not a scene
  vtkStorageAccounting::Settings Storage;

  // probe
  std::array<int, 2> Pixel{ { 0, 0 } }; ///< from the lower left corner
  int Depths = 200;                     ///< besides those of the fragments

  std::string Schema = "scene"; ///< schema: of which files

  std::string Output; ///< a picture, a trace, a folder, .json or .csv; empty for none

  bool NeedsDisplay = true;
};

/// Reads the command line. Empty after --help, --version, manual and completion, which have then been answered; throws
/// Failure.
std::optional<Arguments> ParseArguments(int argc, char** argv);

#endif
