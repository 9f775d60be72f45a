// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Page.h"

#include "Basics/Embedded.h"

#include <kainjow/mustache.hpp>

#include <OpenImageIO/strutil.h>

#include <algorithm>

namespace
{
using kainjow::mustache::data;

// What the numbers mean to somebody who looks at the pictures.
std::string Verdict(const Difference& difference)
{
  if (difference.Largest == 0)
  {
    return "the same picture";
  }
  if (difference.Largest <= 2)
  {
    return "the same to the eye";
  }
  if (difference.Rmse < 0.005)
  {
    return "hard to tell apart";
  }
  return difference.Rmse < 0.02 ? "visibly different on a closer look" : "visibly different";
}

std::string DataUri(const std::map<std::string, std::string>& pictures, const std::string& file)
{
  const auto found = pictures.find(file);
  return found == pictures.end() ? "" : "data:image/png;base64," + OIIO::Strutil::base64_encode(found->second);
}

void SetTimes(const ReportRow& row, double slowest, data& entry)
{
  const Timing& times = row.Times;
  entry.set("milliseconds", Fixed(times.Median, times.Median < 100 ? 1 : 0));
  entry.set("quartiles", Fixed(times.LowerQuartile, 1) + " to " + Fixed(times.UpperQuartile, 1));
  entry.set("bar", Fixed(slowest > 0 ? 100 * times.Median / slowest : 0, 1));
  entry.set("ratio", times.RatioToBlend ? Fixed(*times.RatioToBlend, 2) : "-");
  entry.set("gather", times.Stages ? Fixed(times.Stages->Gather, 1) : "-");
  entry.set("resolve", times.Stages ? Fixed(times.Stages->Resolve, 1) : "-");
  const FrameStatistics& statistics = times.Statistics;
  entry.set("fragments", statistics.Known ? Grouped(statistics.Fragments) : "-");
  entry.set("deepest", statistics.Known ? Grouped(statistics.DeepestPixel) : "-");
  entry.set("mebibytes", statistics.Known ? Fixed(statistics.Mebibytes, 1) : "-");
  entry.set("packed", times.Storage ? Fixed(times.Storage->PackedMebibytes, 1) : "-");
  entry.set("accesses", times.Storage ? Grouped(times.Storage->Total) : "-");
  if (!statistics.Chosen.empty())
  {
    entry.set("chosen", statistics.Chosen);
    entry.set("reason", statistics.Reason);
  }
  if (!statistics.Fallback.empty())
  {
    entry.set("fallback", statistics.Fallback);
  }
}

void SetDifference(const ReportRow& row, data& entry)
{
  const auto& difference = row.ToReference;
  entry.set("isReference", !difference);
  entry.set("verdict", difference ? Verdict(*difference) : "the reference");
  entry.set("rmse", difference ? Fixed(100 * difference->Rmse, 3) + " %" : "-");
  entry.set("psnr", !difference ? "-" : difference->Psnr ? Fixed(*difference->Psnr, 1) + " dB" : "same");
  entry.set("largest", difference ? std::to_string(difference->Largest) : "-");
}
}

//------------------------------------------------------------------------------
std::string ToPage(const Report& report, const std::map<std::string, std::string>& pictures)
{
  double slowest = 0;
  for (const ReportRow& row : report.Rows)
  {
    slowest = std::max(slowest, row.Times.Median);
  }
  data rows(data::type::list);
  std::string reference;
  for (const ReportRow& row : report.Rows)
  {
    data entry;
    entry.set("label", row.Technique.Label);
    entry.set("help", row.Help);
    SetTimes(row, slowest, entry);
    SetDifference(row, entry);
    entry.set("picture", DataUri(pictures, row.PictureFile));
    entry.set("differencePicture", DataUri(pictures, row.DifferenceFile));
    rows.push_back(entry);
    reference = row.ToReference ? reference : row.Help;
  }
  data page;
  page.set("title", report.Title);
  page.set("samples", std::to_string(report.Samples));
  page.set("size", std::to_string(report.Size[0]) + " x " + std::to_string(report.Size[1]));
  page.set("aspect", std::to_string(report.Size[0]) + " / " + std::to_string(report.Size[1]));
  page.set("actors", std::to_string(report.Actors));
  page.set("triangles", Grouped(report.Triangles));
  page.set("driver", report.Driver);
  page.set("frames", std::to_string(report.Settings.Frames));
  page.set("reference", report.Reference);
  page.set("referenceHelp", reference);
  page.set("rows", rows);
  // "</script>" in a file's name would end the data early.
  page.set("json", OIIO::Strutil::replace(ToJson(report).dump(2), "<", "\\u003c", true));

  kainjow::mustache::mustache layout(Embedded::PageTemplate);
  return layout.render(page);
}
