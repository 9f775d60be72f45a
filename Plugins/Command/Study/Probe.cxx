// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe.h"

#include "Basics/Failure.h"
#include "Basics/Progress.h"
#include "Basics/Suffix.h"
#include "Report/Report.h"
#include "Scenes/Scene.h"
#include "Techniques/Stage.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace
{
using Fragment = vtkStorageSimulator::Fragment;
using OrderedJson = nlohmann::ordered_json;

// What a probe adds to a pixel is its colour times its opacity, 1. Half floats hold both as they are.
constexpr double ProbeOpacity = 1.0 / 1024;
constexpr double ProbeColor = 1 / ProbeOpacity;

// A probe at a fragment's depth stands in front of it by that much of the window's depth: twice what floats round.
constexpr double InFront = 1.0 / (1 << 20);

// Pixels: probes of a row, and the height of a row, over which chance is averaged.
constexpr int MostColumns = 1024;
constexpr int RowHeight = 8;

// Window depths as distances, and back.
class Lens
{
public:
  explicit Lens(vtkCamera* camera)
    : Parallel(camera->GetParallelProjection() != 0)
    , HalfHeight(
        Parallel ? camera->GetParallelScale() : std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle() / 2)))
  {
    camera->GetClippingRange(this->Near, this->Far);
  }

  double ToDistance(double window) const
  {
    return this->Parallel ? this->Near + window * (this->Far - this->Near)
                          : this->Near * this->Far / (this->Far - window * (this->Far - this->Near));
  }

  double ToWindow(double distance) const
  {
    const double part = (distance - this->Near) / (this->Far - this->Near);
    return this->Parallel ? part : part * this->Far / distance;
  }

  // Half the height of what is seen at that distance.
  double GetHalfHeight(double distance) const
  {
    return this->Parallel ? this->HalfHeight : this->HalfHeight * distance;
  }

private:
  bool Parallel;
  double HalfHeight; // at distance 1 in perspectives
  double Near = 0;
  double Far = 0;
};

// Where probes are: each in its own pixels of a picture.
struct Layout
{
  explicit Layout(std::size_t count)
    : Columns(std::min(static_cast<int>(count), MostColumns))
    , Rows((static_cast<int>(count) + Columns - 1) / Columns)
  {
  }

  std::array<int, 2> GetSize() const { return { { this->Columns, this->Rows * RowHeight } }; }

  int Columns;
  int Rows;
};

// A rectangle of the picture, in parts of its width and height.
struct Area
{
  double Left;
  double Bottom;
  double Right;
  double Top;
};
constexpr Area Everywhere{ -1, -1, 2, 2 }; // beyond all edges

class QuadMaker
{
public:
  QuadMaker(const Lens& lens, const std::array<int, 2>& size)
    : Eye(lens)
    , Aspect(static_cast<double>(size[0]) / size[1])
  {
    this->Surface->SetPoints(this->Points);
    this->Surface->SetPolys(this->Cells);
  }

  void Add(const Area& area, double window)
  {
    const double distance = this->Eye.ToDistance(window);
    const double height = this->Eye.GetHalfHeight(distance);
    const double corners[4][2] = { { area.Left, area.Bottom }, { area.Right, area.Bottom }, { area.Right, area.Top },
      { area.Left, area.Top } };
    this->Cells->InsertNextCell(4);
    for (const auto& corner : corners)
    {
      this->Cells->InsertCellPoint(this->Points->InsertNextPoint(
        (2 * corner[0] - 1) * height * this->Aspect, (2 * corner[1] - 1) * height, -distance));
    }
  }

  // Not lit: of this very colour.
  Part MakePart(const std::string& name, const Color& color, double opacity)
  {
    Part part = ::MakePart(name, this->Surface);
    SetLook(part, color, opacity, std::nullopt);
    part.Actor->GetProperty()->LightingOff();
    part.Actor->ForceTranslucentOn(); // opaque fragments, too
    return part;
  }

private:
  Lens Eye;
  double Aspect;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkPolyData> Surface;
};

// The window depth at which the probe of a depth stands.
double PlaceOf(const Probe& probe, std::size_t index)
{
  const double depth = probe.Depths[index].Window;
  double before = depth - 2 * InFront; // the depth of the nearest fragment in front
  for (const ProbeFragment& fragment : probe.Fragments)
  {
    before = fragment.Depth.Window < depth ? std::max(before, fragment.Depth.Window) : before;
  }
  return depth - std::min(InFront, (depth - before) / 2);
}

// The pixel's fragments, each across the whole picture, and the probes.
Scene MakeScene(const std::vector<Fragment>& fragments, const Lens& lens, const Layout& layout, const Probe& probe)
{
  Scene scene;
  scene.Size = layout.GetSize();
  scene.Behind = Color{ { 0, 0, 0 } };
  for (const Fragment& fragment : fragments)
  {
    QuadMaker quad(lens, scene.Size);
    quad.Add(Everywhere, fragment.Depth);
    scene.Parts.push_back(quad.MakePart("fragment", { { 0, 0, 0 } }, fragment.Color[3]));
  }
  QuadMaker quads(lens, scene.Size);
  for (std::size_t i = 0; i < probe.Depths.size(); ++i)
  {
    const int column = static_cast<int>(i) % layout.Columns;
    const int row = static_cast<int>(i) / layout.Columns;
    const double width = 1.0 / layout.Columns;
    const double height = 1.0 / layout.Rows;
    quads.Add({ column * width, row * height, (column + 1) * width, (row + 1) * height }, PlaceOf(probe, i));
  }
  scene.Parts.push_back(quads.MakePart("probes", { { ProbeColor, ProbeColor, ProbeColor } }, ProbeOpacity));
  return scene;
}

// The mean of red over each probe's pixels.
std::vector<double> ReadProbes(const std::vector<float>& pixels, const Layout& layout, std::size_t count)
{
  constexpr std::size_t channels = 4;
  std::vector<double> means(count, 0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t first = i / layout.Columns * RowHeight * layout.Columns + i % layout.Columns;
    for (std::size_t y = 0; y < RowHeight; ++y)
    {
      means[i] += pixels[channels * (first + y * layout.Columns)] / RowHeight;
    }
  }
  return means;
}

struct Error
{
  double Rmse = 0;
  double Largest = 0;
};

Error ErrorOf(const ProbeRow& row, const std::vector<double>& exact)
{
  Error error;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const double difference = std::abs(row.Visibility[i] - exact[i]);
    error.Rmse += difference * difference / static_cast<double>(exact.size());
    error.Largest = std::max(error.Largest, difference);
  }
  error.Rmse = std::sqrt(error.Rmse);
  return error;
}

void AddDepth(const ProbeDepth& depth, OrderedJson& json)
{
  json["depth"] = depth.Window;
  json["distance"] = depth.Distance;
}

OrderedJson RowToJson(const ProbeRow& row, const std::vector<double>& exact)
{
  OrderedJson json = ToJson(row.Technique, row.Help);
  const Error error = ErrorOf(row, exact);
  json["fallback"] = row.Fallback.empty() ? OrderedJson() : OrderedJson(row.Fallback);
  json["rmse"] = error.Rmse;
  json["largest_difference"] = error.Largest;
  json["visibility"] = row.Visibility;
  return json;
}

std::string ToJsonText(const Probe& probe)
{
  OrderedJson json;
  json["kind"] = "probe";
  json["title"] = probe.Title;
  json["inputs"] = probe.Inputs;
  json["size"] = probe.Size;
  json["pixel"] = probe.Pixel;
  json["driver"] = probe.Driver;
  json["fragments"] = OrderedJson::array();
  for (const ProbeFragment& fragment : probe.Fragments)
  {
    OrderedJson row;
    AddDepth(fragment.Depth, row);
    row["opacity"] = fragment.Opacity;
    row["transmittance"] = fragment.Transmittance;
    json["fragments"].push_back(row);
  }
  json["depths"] = OrderedJson::array();
  json["distances"] = OrderedJson::array();
  for (const ProbeDepth& depth : probe.Depths)
  {
    json["depths"].push_back(depth.Window);
    json["distances"].push_back(depth.Distance);
  }
  json["exact"] = probe.Exact;
  json["techniques"] = OrderedJson::array();
  for (const ProbeRow& row : probe.Rows)
  {
    json["techniques"].push_back(RowToJson(row, probe.Exact));
  }
  return json.dump(1) + "\n";
}

// Names of techniques hold no commas: they separate them on the command line.
std::string ToCsvText(const Probe& probe)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(9); // as many digits as floats have
  out << "depth,distance,exact";
  for (const ProbeRow& row : probe.Rows)
  {
    out << "," << row.Technique.Label;
  }
  out << "\n";
  for (std::size_t i = 0; i < probe.Depths.size(); ++i)
  {
    out << probe.Depths[i].Window << "," << probe.Depths[i].Distance << "," << probe.Exact[i];
    for (const ProbeRow& row : probe.Rows)
    {
      out << "," << row.Visibility[i];
    }
    out << "\n";
  }
  return out.str();
}
}

//------------------------------------------------------------------------------
std::vector<Fragment> TakePixel(
  const std::vector<Fragment>& fragments, const std::array<int, 2>& pixel, const std::string& title)
{
  std::vector<Fragment> taken;
  std::copy_if(fragments.begin(), fragments.end(), std::back_inserter(taken),
    [&pixel](const Fragment& fragment) { return fragment.X == pixel[0] && fragment.Y == pixel[1]; });
  if (taken.empty())
  {
    throw Failure(title + ": pixel " + std::to_string(pixel[0]) + " " + std::to_string(pixel[1]) +
      " has no translucent fragments, expected at least one");
  }
  return taken;
}

//------------------------------------------------------------------------------
void AddExact(const std::vector<Fragment>& fragments, vtkCamera* camera, int count, Probe& probe)
{
  const Lens lens(camera);
  std::vector<Fragment> sorted = fragments;
  std::stable_sort(
    sorted.begin(), sorted.end(), [](const Fragment& a, const Fragment& b) { return a.Depth < b.Depth; });
  double transmittance = 1;
  std::vector<double> windows;
  for (const Fragment& fragment : sorted)
  {
    transmittance *= 1 - fragment.Color[3];
    probe.Fragments.push_back(
      { { fragment.Depth, lens.ToDistance(fragment.Depth) }, fragment.Color[3], transmittance });
    windows.push_back(fragment.Depth);
  }
  const double first = probe.Fragments.front().Depth.Distance;
  const double last = probe.Fragments.back().Depth.Distance;
  for (int i = 1; i <= count; ++i)
  {
    const double window = lens.ToWindow(first + (last - first) * i / (count + 1));
    const auto coincides = [window](const Fragment& fragment)
    { return std::abs(fragment.Depth - window) < 2 * InFront; };
    if (std::none_of(sorted.begin(), sorted.end(), coincides))
    {
      windows.push_back(window);
    }
  }
  std::sort(windows.begin(), windows.end());
  windows.erase(std::unique(windows.begin(), windows.end()), windows.end());
  for (const double window : windows)
  {
    double visibility = 1;
    for (const ProbeFragment& fragment : probe.Fragments)
    {
      visibility = fragment.Depth.Window < window ? fragment.Transmittance : visibility;
    }
    probe.Depths.push_back({ window, lens.ToDistance(window) });
    probe.Exact.push_back(visibility);
  }
}

//------------------------------------------------------------------------------
void MeasureRows(const std::vector<Fragment>& fragments, vtkCamera* camera, Probe& probe)
{
  const Layout layout(probe.Depths.size());
  const Scene scene = MakeScene(fragments, Lens(camera), layout, probe);
  vtkNew<vtkCamera> straight; // looks along -z, with the same lens
  straight->DeepCopy(camera);
  straight->SetPosition(0, 0, 0);
  straight->SetFocalPoint(0, 0, -1);
  straight->SetViewUp(0, 1, 0);
  Stage stage(scene.Size);
  stage.SetCamera(straight);
  probe.Driver = stage.GetDriver();
  Progress progress("probing", static_cast<int>(probe.Rows.size()));
  for (ProbeRow& row : probe.Rows)
  {
    progress.Step(row.Technique.Label);
    const int number = stage.Add(scene, row.Technique);
    stage.Settle(number);
    row.Visibility = ReadProbes(stage.DrawInFloats(number), layout, probe.Depths.size());
    row.Fallback = stage.GetStatistics(number).Fallback;
  }
}

//------------------------------------------------------------------------------
std::string ToText(const Probe& probe)
{
  std::vector<std::vector<std::string>> rows{ { "technique", "RMSE %", "largest %" } };
  for (const ProbeRow& row : probe.Rows)
  {
    const Error error = ErrorOf(row, probe.Exact);
    rows.push_back({ row.Technique.Label + (row.Fallback.empty() ? "" : " (by " + row.Fallback + ")"),
      Fixed(100 * error.Rmse, 3), Fixed(100 * error.Largest, 2) });
  }
  return probe.Title + ", pixel " + std::to_string(probe.Pixel[0]) + " " + std::to_string(probe.Pixel[1]) + " of " +
    std::to_string(probe.Size[0]) + "x" + std::to_string(probe.Size[1]) + ": " +
    Grouped(static_cast<long long>(probe.Fragments.size())) + " fragments, which let through " +
    Fixed(100 * probe.Fragments.back().Transmittance, 2) + " %\ndifferences: to the exact visibility at " +
    std::to_string(probe.Depths.size()) + " depths\n\n" + Aligned(rows);
}

//------------------------------------------------------------------------------
void CheckProbeSuffix(const std::string& file)
{
  const std::string suffix = SuffixOf(file);
  if (suffix != ".csv" && suffix != ".json")
  {
    throw Failure("'" + file + "' has the suffix '" + suffix + "', expected .csv or .json");
  }
}

//------------------------------------------------------------------------------
std::string ToFile(const Probe& probe, const std::string& file)
{
  return SuffixOf(file) == ".csv" ? ToCsvText(probe) : ToJsonText(probe);
}
