// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HistogramFile.h"

#include "Basics/Embedded.h"
#include "Basics/JsonFile.h"

//------------------------------------------------------------------------------
HistogramFile ReadHistogramFile(const std::string& file)
{
  const nlohmann::json json = ReadJson(file, Embedded::HistogramSchema, "a histogram");
  HistogramFile histogram;
  histogram.Title = json.value("title", "");
  for (const auto& frame : json.at("frames"))
  {
    vtkStorageAccounting::Histogram pixels{ json.at("size").at(0), json.at("size").at(1), {} };
    std::int64_t depth = 0;
    for (const std::int64_t count : frame.at("pixels"))
    {
      ++depth;
      if (count > 0)
      {
        pixels.Pixels[depth] = count;
      }
    }
    histogram.Frames.push_back(pixels);
    histogram.Names.push_back(frame.at("name"));
  }
  return histogram;
}
