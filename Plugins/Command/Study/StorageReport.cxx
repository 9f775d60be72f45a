// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StorageReport.h"

#include "Basics/Failure.h"
#include "Basics/Progress.h"
#include "Report/Report.h"

#include <cmath>
#include <sstream>

namespace
{
using Accounting = vtkStorageAccounting;
using Design = Accounting::Design;
using OrderedJson = nlohmann::ordered_json;

void CheckSame(const std::string& where, const Accounting::Cost& simulated, const Accounting::Cost& computed)
{
  const auto numbers = [](const Accounting::Cost& cost)
  {
    const Accounting::Accesses& count = cost.Count;
    return std::array<double, 8>{ { static_cast<double>(cost.Fragments), static_cast<double>(cost.Sections), cost.Bytes,
      static_cast<double>(count.Stores), static_cast<double>(count.Reads), static_cast<double>(count.Table),
      static_cast<double>(count.SecondDepth), static_cast<double>(count.FrameBuffer) } };
  };
  if (numbers(simulated) != numbers(computed))
  {
    throw Failure(where + ": the simulator counts " + Fixed(simulated.Bytes, 1) + " bytes and " +
      std::to_string(simulated.Count.GetTotal()) + " accesses, expected the closed form's " + Fixed(computed.Bytes, 1) +
      " and " + std::to_string(computed.Count.GetTotal()));
  }
}

void Simulate(const TraceFrame& fragments, const StorageFrame& frame, Progress& progress)
{
  for (std::size_t i = 0; i < frame.Layouts.size(); ++i)
  {
    const std::string where = frame.Name + ", " + vtkStorageDesign::GetName(frame.Layouts[i].Kind);
    progress.Step(where);
    const vtkStorageSimulator::Result result = vtkStorageSimulator::Run(frame.Layouts[i], fragments.Fragments);
    if (!result.Error.empty())
    {
      throw Failure(where + ": " + result.Error);
    }
    CheckSame(where, result.Cost, frame.Costs[i]);
  }
}

std::string SectionLengthText(const Accounting::Layout& layout)
{
  return layout.Kind == Design::TBuffer || layout.Kind == Design::MBuffer ? Grouped(layout.SectionLength) : "-";
}

std::string FrameText(const StorageFrame& frame)
{
  const double density = 100.0 * static_cast<double>(frame.Pixels.GetPixels()) /
    (static_cast<double>(frame.Pixels.Width) * frame.Pixels.Height);
  std::vector<std::vector<std::string>> rows{ { "design", "fragments", "a section", "sections", "address bits", "KiB",
    "stores", "reads", "table", "second depth", "frame buffer", "accesses" } };
  for (std::size_t i = 0; i < frame.Costs.size(); ++i)
  {
    const Accounting::Layout& layout = frame.Layouts[i];
    const Accounting::Cost& cost = frame.Costs[i];
    const bool points = layout.Kind != Design::RBuffer;
    rows.push_back({ vtkStorageDesign::GetName(layout.Kind), Grouped(cost.Fragments), SectionLengthText(layout),
      points ? Grouped(cost.Sections) : "-", points ? std::to_string(layout.Bits.Address) : "-",
      Fixed(cost.Bytes / 1024, 1), Grouped(cost.Count.Stores), Grouped(cost.Count.Reads), Grouped(cost.Count.Table),
      Grouped(cost.Count.SecondDepth), Grouped(cost.Count.FrameBuffer), Grouped(cost.Count.GetTotal()) });
  }
  return frame.Name + ": " + Grouped(frame.Pixels.GetFragments()) + " fragments in " +
    Grouped(frame.Pixels.GetPixels()) + " pixels (" + Fixed(density, 1) + " %), the deepest of " +
    Grouped(frame.Pixels.Pixels.empty() ? 0 : frame.Pixels.Pixels.rbegin()->first) + "\n" + Aligned(rows);
}

// A saving as a change: "-28.8 %".
std::string ChangeText(double saving)
{
  const std::string percent = Fixed(std::abs(100 * saving), 1);
  return (percent == "0.0" ? "" : saving > 0 ? "-" : "+") + percent + " %";
}

OrderedJson DesignToJson(const Accounting::Layout& layout, const Accounting::Cost& cost)
{
  const bool points = layout.Kind != Design::RBuffer;
  const bool sections = layout.Kind == Design::TBuffer || layout.Kind == Design::MBuffer;
  const Accounting::Accesses& count = cost.Count;
  OrderedJson json;
  json["design"] = vtkStorageDesign::GetName(layout.Kind);
  json["section_length"] = sections ? OrderedJson(layout.SectionLength) : OrderedJson();
  json["sections"] = points ? OrderedJson(cost.Sections) : OrderedJson();
  json["address_bits"] = points ? OrderedJson(layout.Bits.Address) : OrderedJson();
  json["bytes"] = cost.Bytes;
  json["accesses"] = { { "stores", count.Stores }, { "reads", count.Reads }, { "table", count.Table },
    { "second_depth", count.SecondDepth }, { "frame_buffer", count.FrameBuffer }, { "total", count.GetTotal() } };
  return json;
}
}

//------------------------------------------------------------------------------
StorageReport AccountStorage(const std::string& context, const std::vector<std::string>& names,
  const std::vector<Accounting::Histogram>& frames, const Accounting::Settings& settings)
{
  const Accounting accounting(settings, frames);
  if (!accounting.GetError().empty())
  {
    throw Failure(context + ": " + accounting.GetError());
  }
  StorageReport report;
  report.Size = { { frames.front().Width, frames.front().Height } };
  report.Settings = settings;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    StorageFrame frame{ names[i], frames[i], {}, {} };
    for (const Design design : vtkStorageDesign::GetAll())
    {
      frame.Layouts.push_back(accounting.GetLayout(design, i));
      frame.Costs.push_back(accounting.GetCost(design, i));
    }
    report.Frames.push_back(frame);
  }
  for (const Design other : { Design::RBuffer, Design::MBuffer, Design::LinkedList })
  {
    report.Means.push_back({ Design::TBuffer, other, accounting.GetSaving(Design::TBuffer, other) });
  }
  return report;
}

//------------------------------------------------------------------------------
StorageReport AccountStorage(const std::string& context, const std::vector<std::string>& names, const Trace& trace,
  const Accounting::Settings& settings)
{
  std::vector<Accounting::Histogram> frames;
  for (const TraceFrame& frame : trace.Frames)
  {
    frames.push_back(vtkStorageSimulator::Count(trace.Size[0], trace.Size[1], frame.Fragments));
  }
  StorageReport report = AccountStorage(context, names, frames, settings);
  Progress progress("simulating", static_cast<int>(frames.size() * vtkStorageDesign::GetAll().size()));
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    Simulate(trace.Frames[i], report.Frames[i], progress);
  }
  report.Simulated = true;
  return report;
}

//------------------------------------------------------------------------------
std::string ToText(const StorageReport& report)
{
  const Accounting::Packing& bits = report.Settings.Bits;
  std::ostringstream out;
  out << report.Title << ", " << report.Size[0] << "x" << report.Size[1] << "\n"
      << "bits: depth " << bits.Depth << ", colour " << bits.Color << ", coordinate " << bits.Coordinate << ", state "
      << bits.State << "; "
      << (report.Simulated ? "closed forms; the simulator has come to the same numbers" : "closed forms") << "\n";
  for (const StorageFrame& frame : report.Frames)
  {
    out << "\n" << FrameText(frame);
  }
  out << "\n" << (report.Frames.size() > 1 ? "Means of " + std::to_string(report.Frames.size()) + " frames:\n" : "");
  for (const StorageMean& mean : report.Means)
  {
    out << vtkStorageDesign::GetName(mean.Design) << " against " << vtkStorageDesign::GetName(mean.Against) << ": "
        << ChangeText(mean.Saved.Storage) << " storage, " << ChangeText(mean.Saved.Accesses) << " accesses\n";
  }
  return out.str();
}

//------------------------------------------------------------------------------
OrderedJson ToJson(const StorageReport& report)
{
  const Accounting::Packing& bits = report.Settings.Bits;
  OrderedJson json;
  json["kind"] = "storage";
  json["title"] = report.Title;
  json["inputs"] = report.Inputs;
  json["size"] = report.Size;
  json["bits"] = { { "coordinate", bits.Coordinate }, { "depth", bits.Depth }, { "color", bits.Color },
    { "state", bits.State } };
  json["simulated"] = report.Simulated;
  json["frames"] = OrderedJson::array();
  for (const StorageFrame& frame : report.Frames)
  {
    OrderedJson row;
    row["name"] = frame.Name;
    row["fragments"] = frame.Pixels.GetFragments();
    row["pixels"] = frame.Pixels.GetPixels();
    row["deepest_pixel"] = frame.Pixels.Pixels.empty() ? 0 : frame.Pixels.Pixels.rbegin()->first;
    row["designs"] = OrderedJson::array();
    for (std::size_t i = 0; i < frame.Costs.size(); ++i)
    {
      row["designs"].push_back(DesignToJson(frame.Layouts[i], frame.Costs[i]));
    }
    json["frames"].push_back(row);
  }
  json["means"] = OrderedJson::array();
  for (const StorageMean& mean : report.Means)
  {
    json["means"].push_back(
      { { "design", vtkStorageDesign::GetName(mean.Design) }, { "against", vtkStorageDesign::GetName(mean.Against) },
        { "less_storage", mean.Saved.Storage }, { "fewer_accesses", mean.Saved.Accesses } });
  }
  return json;
}
