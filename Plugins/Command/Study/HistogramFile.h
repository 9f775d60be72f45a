// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Histogram files: JSON, as histogram.schema.json says: how many pixels of a frame hold how many fragments.
 */
#ifndef HistogramFile_h
#define HistogramFile_h

#include "vtkStorageAccounting.h"

#include <string>
#include <vector>

struct HistogramFile
{
  std::string Title; ///< empty if the file does not say
  std::vector<std::string> Names;
  std::vector<vtkStorageAccounting::Histogram> Frames;
};

/// Throws Failure that names the place in the file, what stands there and what was expected.
HistogramFile ReadHistogramFile(const std::string& file);

#endif
