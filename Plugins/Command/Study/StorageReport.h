// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What designs of fragment storage take for frames, as text, as JSON and as the two charts of the T-buffer's paper.
 */
#ifndef StorageReport_h
#define StorageReport_h

#include "Trace.h"

#include "vtkStorageAccounting.h"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

struct StorageFrame
{
  std::string Name;
  vtkStorageAccounting::Histogram Pixels;
  std::vector<vtkStorageAccounting::Layout> Layouts; ///< of each design,
  std::vector<vtkStorageAccounting::Cost> Costs;     ///< and what it takes
};

struct StorageMean
{
  vtkStorageAccounting::Design Design;
  vtkStorageAccounting::Design Against;
  vtkStorageAccounting::Saving Saved;
};

struct StorageReport
{
  std::string Title;
  std::vector<std::string> Inputs;
  std::array<int, 2> Size{ { 0, 0 } };
  vtkStorageAccounting::Settings Settings;
  bool Simulated = false; ///< whether the simulator has come to the same numbers
  std::vector<StorageFrame> Frames;
  std::vector<StorageMean> Means; ///< of the T-buffer against each other design
};

/// Computes all; throws Failure if the settings don't fit the frames. context is what to call them in it.
StorageReport AccountStorage(const std::string& context, const std::vector<std::string>& names,
  const std::vector<vtkStorageAccounting::Histogram>& frames, const vtkStorageAccounting::Settings& settings);

/// The same for a trace, on which the simulator has to come to the same numbers: throws Failure if it does not.
StorageReport AccountStorage(const std::string& context, const std::vector<std::string>& names, const Trace& trace,
  const vtkStorageAccounting::Settings& settings);

/// One table a frame, and the means.
std::string ToText(const StorageReport& report);

/// Everything; README.md beside this file says what the keys mean.
nlohmann::ordered_json ToJson(const StorageReport& report);

/// Draws the bytes (Figure 6 of the paper) or the accesses (Figure 7) of all designs, frame by frame, as .png. Opens a
/// window; throws Failure; name is what to call the file in it.
enum class StorageChart
{
  Bytes,
  Accesses
};
void DrawChart(
  const StorageReport& report, StorageChart chart, const std::filesystem::path& file, const std::string& name);

#endif
