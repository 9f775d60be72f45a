// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <algorithm>
#include <functional>
#include <iomanip>
#include <sstream>

namespace
{
using OrderedJson = nlohmann::ordered_json;

// A column of the table: what stands above, and what in each row.
struct Column
{
  std::string Heading;
  std::function<std::string(const ReportRow&)> Cell;
};

const std::string None = "-";

std::string StageCell(const ReportRow& row, double StageTimes::*stage)
{
  return row.Times.Stages ? Fixed((*row.Times.Stages).*stage, 1) : None;
}

std::vector<Column> TimeColumns()
{
  return {
    { "ms", [](const ReportRow& row) { return Fixed(row.Times.Median, 1); } },
    { "quartiles",
      [](const ReportRow& row)
      { return Fixed(row.Times.LowerQuartile, 1) + ".." + Fixed(row.Times.UpperQuartile, 1); } },
    { "first", [](const ReportRow& row) { return Fixed(row.Times.First, 1); } },
    { "slowest", [](const ReportRow& row) { return Fixed(row.Times.Slowest, 1); } },
    { "x blend",
      [](const ReportRow& row) { return row.Times.RatioToBlend ? Fixed(*row.Times.RatioToBlend, 2) : None; } },
    { "gather", [](const ReportRow& row) { return StageCell(row, &StageTimes::Gather); } },
    { "resolve", [](const ReportRow& row) { return StageCell(row, &StageTimes::Resolve); } },
  };
}

std::vector<Column> CountColumns()
{
  const auto known = [](const ReportRow& row, const std::string& text)
  { return row.Times.Statistics.Known ? text : None; };
  return {
    { "fragments", [=](const ReportRow& row) { return known(row, Grouped(row.Times.Statistics.Fragments)); } },
    { "deepest", [=](const ReportRow& row) { return known(row, Grouped(row.Times.Statistics.DeepestPixel)); } },
    { "MiB", [=](const ReportRow& row) { return known(row, Fixed(row.Times.Statistics.Mebibytes, 1)); } },
    { "packed MiB",
      [](const ReportRow& row) { return row.Times.Storage ? Fixed(row.Times.Storage->PackedMebibytes, 1) : None; } },
    { "accesses", [](const ReportRow& row) { return row.Times.Storage ? Grouped(row.Times.Storage->Total) : None; } },
  };
}

std::vector<Column> DifferenceColumns()
{
  const auto cell = [](const std::function<std::string(const Difference&)>& format)
  { return [format](const ReportRow& row) { return row.ToReference ? format(*row.ToReference) : None; }; };
  return {
    { "RMSE %", cell([](const Difference& d) { return Fixed(100 * d.Rmse, 3); }) },
    { "PSNR dB", cell([](const Difference& d) { return d.Psnr ? Fixed(*d.Psnr, 1) : std::string("same"); }) },
    { "max/255", cell([](const Difference& d) { return std::to_string(d.Largest); }) },
  };
}

void Append(std::vector<Column>& columns, const std::vector<Column>& more)
{
  columns.insert(columns.end(), more.begin(), more.end());
}

void AddCounts(const FrameStatistics& statistics, OrderedJson& row)
{
  const bool known = statistics.Known;
  row["fragments"] = known ? OrderedJson(statistics.Fragments) : OrderedJson();
  row["deepest_pixel"] = known ? OrderedJson(statistics.DeepestPixel) : OrderedJson();
  row["mebibytes"] = known ? OrderedJson(statistics.Mebibytes) : OrderedJson();
  row["tiles"] = known ? OrderedJson(statistics.Tiles) : OrderedJson();
  row["geometry_passes"] = known ? OrderedJson(statistics.GeometryPasses) : OrderedJson();
  row["screen_passes"] = known ? OrderedJson(statistics.ScreenPasses) : OrderedJson();
  row["shader_builds"] = known ? OrderedJson(statistics.ShaderBuilds) : OrderedJson();
  row["transmittances"] = known ? OrderedJson(statistics.Transmittances) : OrderedJson();
  row["chosen"] = statistics.Chosen.empty() ? OrderedJson() : OrderedJson(statistics.Chosen);
  row["reason"] = statistics.Reason.empty() ? OrderedJson() : OrderedJson(statistics.Reason);
  row["fallback"] = statistics.Fallback.empty() ? OrderedJson() : OrderedJson(statistics.Fallback);
}

void AddStorage(const std::optional<StorageCounts>& counts, OrderedJson& row)
{
  row["section_length"] = counts ? OrderedJson(counts->SectionLength) : OrderedJson();
  row["packed_mebibytes"] = counts ? OrderedJson(counts->PackedMebibytes) : OrderedJson();
  row["accesses"] = OrderedJson();
  if (counts)
  {
    row["accesses"] = { { "stores", counts->Stores }, { "reads", counts->Reads }, { "table", counts->Table },
      { "second_depth", counts->SecondDepth }, { "frame_buffer", counts->FrameBuffer }, { "total", counts->Total } };
  }
}

OrderedJson RowToJson(const ReportRow& row, bool comparison)
{
  const Timing& times = row.Times;
  OrderedJson json = ToJson(row.Technique, row.Help);
  json["milliseconds"] = { { "median", times.Median }, { "lower_quartile", times.LowerQuartile },
    { "upper_quartile", times.UpperQuartile }, { "slowest", times.Slowest }, { "frames", times.Frames },
    { "first", times.First } };
  json["ratio_to_blend"] = times.RatioToBlend ? OrderedJson(*times.RatioToBlend) : OrderedJson();
  json["gather_milliseconds"] = times.Stages ? OrderedJson(times.Stages->Gather) : OrderedJson();
  json["resolve_milliseconds"] = times.Stages ? OrderedJson(times.Stages->Resolve) : OrderedJson();
  AddCounts(times.Statistics, json);
  AddStorage(times.Storage, json);
  if (comparison)
  {
    const auto& difference = row.ToReference;
    json["rmse"] = difference ? OrderedJson(difference->Rmse) : OrderedJson();
    json["psnr"] = difference && difference->Psnr ? OrderedJson(*difference->Psnr) : OrderedJson();
    json["largest_difference"] = difference ? OrderedJson(difference->Largest) : OrderedJson();
    json["picture"] = row.PictureFile;
    json["difference_picture"] = row.DifferenceFile.empty() ? OrderedJson() : OrderedJson(row.DifferenceFile);
  }
  return json;
}
}

//------------------------------------------------------------------------------
std::string Aligned(const std::vector<std::vector<std::string>>& rows)
{
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::ostringstream out;
  for (const auto& row : rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      out << (i == 0 ? std::left : std::right) << (i == 0 ? "" : "  ") << std::setw(static_cast<int>(widths[i]))
          << row[i];
    }
    out << "\n";
  }
  return out.str();
}

//------------------------------------------------------------------------------
OrderedJson ToJson(const TechniqueChoice& technique, const std::string& help)
{
  OrderedJson options = OrderedJson::object();
  for (const auto& setting : technique.Settings)
  {
    options[setting.first] = setting.second;
  }
  OrderedJson json;
  json["technique"] = technique.Label;
  json["name"] = technique.Name;
  json["options"] = options;
  json["help"] = help;
  return json;
}

//------------------------------------------------------------------------------
std::string Fixed(double number, int digits)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << number;
  return out.str();
}

//------------------------------------------------------------------------------
std::string Grouped(long long number)
{
  std::string digits = std::to_string(number);
  for (int position = static_cast<int>(digits.size()) - 3; position > (number < 0 ? 1 : 0); position -= 3)
  {
    digits.insert(position, ",");
  }
  return digits;
}

//------------------------------------------------------------------------------
std::string ToText(const Report& report)
{
  std::vector<Column> columns{ { "technique",
    [](const ReportRow& row)
    {
      const std::string& fallback = row.Times.Statistics.Fallback;
      return row.Technique.Label + (fallback.empty() ? "" : " (by " + fallback + ")");
    } } };
  Append(columns, TimeColumns());
  Append(columns, CountColumns());
  if (!report.Reference.empty())
  {
    Append(columns, DifferenceColumns());
  }

  std::ostringstream out;
  out << report.Title << ", " << report.Size[0] << "x" << report.Size[1]
      << (report.Samples > 1 ? " of " + std::to_string(report.Samples) + " samples" : "") << ", " << report.Actors
      << " actors, " << Grouped(report.Triangles) << " triangles, " << report.Driver << "\n"
      << "times: medians of " << report.Settings.Frames << " frames after " << report.Settings.Warmup
      << (report.Settings.Orbit != 0 ? ", on an orbit of " + Fixed(report.Settings.Orbit, 0) + " degrees" : "")
      << ", techniques in turn\n";
  if (!report.Reference.empty())
  {
    out << "differences: to " << report.Reference << "\n";
  }
  std::vector<std::vector<std::string>> rows(report.Rows.size() + 1);
  for (const Column& column : columns)
  {
    rows[0].push_back(column.Heading);
    std::transform(report.Rows.begin(), report.Rows.end(), rows.begin() + 1, rows.begin() + 1,
      [&column](const ReportRow& row, std::vector<std::string> cells)
      {
        cells.push_back(column.Cell(row));
        return cells;
      });
  }
  out << "\n" << Aligned(rows);
  for (const ReportRow& row : report.Rows)
  {
    const FrameStatistics& statistics = row.Times.Statistics;
    if (!statistics.Chosen.empty())
    {
      out << "\n" << row.Technique.Label << " has drawn by " << statistics.Chosen << ": " << statistics.Reason << "\n";
    }
  }
  return out.str();
}

//------------------------------------------------------------------------------
OrderedJson ToJson(const Report& report)
{
  const bool comparison = !report.Reference.empty();
  OrderedJson json;
  json["kind"] = comparison ? "comparison" : "benchmark";
  json["title"] = report.Title;
  json["inputs"] = report.Inputs;
  json["size"] = report.Size;
  json["samples"] = report.Samples;
  json["driver"] = report.Driver;
  json["actors"] = report.Actors;
  json["triangles"] = report.Triangles;
  json["frames"] = report.Settings.Frames;
  json["warmup"] = report.Settings.Warmup;
  json["orbit"] = report.Settings.Orbit;
  if (comparison)
  {
    json["reference"] = report.Reference;
  }
  json["techniques"] = OrderedJson::array();
  for (const ReportRow& row : report.Rows)
  {
    json["techniques"].push_back(RowToJson(row, comparison));
  }
  return json;
}
