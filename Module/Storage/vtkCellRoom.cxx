// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellRoom.h"

#include "Storage/CellLayout.glsl"

#include <algorithm>
#include <cmath>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int FramesMovingAfterOverflow = 30;
constexpr int ReachWhileMoving = 2; // cells
constexpr std::size_t TilesKept = 256;
constexpr double MostForeseen = 16;  // fragments per pixel, on average
constexpr double LeastToTell = 0.25; // of a cell that boxes have to cover to tell how dense they are

int CellsAcross(int pixels, int shift)
{
  return (pixels + (1 << shift) - 1) >> shift;
}

std::int64_t Sum(const vtkCellRoom::Units& units)
{
  return std::accumulate(units.begin(), units.end(), std::int64_t(0));
}

std::int64_t GetPixels(const vtkCellRoom::Rectangle& tile) // of a cell
{
  return std::int64_t(1) << (2 * vtkCellRoom::GetCellShift(tile));
}

// A fragment per pixel of a cell.
std::int64_t GetLeastUnits(const vtkCellRoom::Rectangle& tile, const vtkCellRoom::Unit& unit)
{
  const std::int64_t pixels = GetPixels(tile);
  return vtkCellRoom::GetUnitsFor(unit, pixels, pixels);
}

// What is given where that many units were taken.
std::int64_t WithReserve(std::int64_t units)
{
  return units + units / 8;
}

// Gives the first cells a fragment per pixel.
vtkCellRoom::Units Spread(const vtkCellRoom::Rectangle& tile, const vtkCellRoom::Unit& unit, std::int64_t fragments)
{
  const auto [across, down] = vtkCellRoom::GetCells(tile);
  vtkCellRoom::Units units(static_cast<std::size_t>(across) * down, GetLeastUnits(tile, unit));
  std::int64_t left = vtkCellRoom::GetUnitsFor(unit, fragments, 0);
  for (std::int64_t& range : units)
  {
    range = std::min(range, left);
    left -= range;
  }
  return units;
}

// Units for fragments that are expected where boxes cover that many pixels of a cell.
std::int64_t GetExpectedUnits(
  const vtkCellRoom::Unit& unit, double fragments, double covered, std::int64_t pixelsOfCell)
{
  // The last unit of a pixel is not always full.
  const double unused = std::min(covered, static_cast<double>(pixelsOfCell)) * (unit.Fragments - 1);
  constexpr double Rounding = 1e-6; // of sums
  return vtkCellRoom::GetUnitsFor(
    unit, static_cast<std::int64_t>(std::ceil(fragments + unused - Rounding)), pixelsOfCell);
}

// Units for as many fragments as boxes may let expect in all.
std::int64_t GetMostForeseen(const vtkCellRoom::Rectangle& tile, const vtkCellRoom::Unit& unit)
{
  const auto [across, down] = vtkCellRoom::GetCells(tile);
  const std::int64_t pixels = GetPixels(tile) * across * down;
  return GetExpectedUnits(unit, MostForeseen * static_cast<double>(pixels), static_cast<double>(pixels), pixels);
}

// Of each cell the most of all within a reach.
template <typename T>
std::vector<T> Widen(const std::vector<T>& values, const std::array<int, 2>& cells, int reach)
{
  const auto [across, down] = cells;
  std::vector<T> rows(values.size());
  std::vector<T> wide(values.size());
  for (int y = 0; y < down; ++y)
  {
    const auto row = values.begin() + y * across;
    for (int x = 0; x < across; ++x)
    {
      rows[y * across + x] = *std::max_element(row + std::max(0, x - reach), row + std::min(across, x + reach + 1));
    }
  }
  for (int y = 0; y < down; ++y)
  {
    for (int x = 0; x < across; ++x)
    {
      T& most = wide[y * across + x];
      most = rows[y * across + x];
      for (int v = std::max(0, y - reach); v < std::min(down, y + reach + 1); ++v)
      {
        most = std::max(most, rows[v * across + x]);
      }
    }
  }
  return wide;
}

// How an interval lies over cells side by side: what the length that it covers of each differs from that of the one
// before. Those that differ are few, however many the interval covers.
std::map<int, double> GetSteps(double from, double to, int side, int cells)
{
  std::map<int, double> steps;
  from = std::clamp(from, 0.0, static_cast<double>(side) * cells);
  to = std::clamp(to, 0.0, static_cast<double>(side) * cells);
  for (const auto& [end, sign] : { std::pair<double, int>{ from, 1 }, { to, -1 } })
  {
    const int cell = static_cast<int>(end / side);
    const double rest = side * (cell + 1.0) - end; // of that cell, behind the end
    steps[cell] += sign * rest;
    steps[cell + 1] += sign * (side - rest);
  }
  return steps;
}
}

//------------------------------------------------------------------------------
std::int64_t vtkCellRoom::GetUnitsFor(const Unit& unit, std::int64_t fragments, std::int64_t pixels)
{
  const std::int64_t left = std::max<std::int64_t>(0, fragments - pixels * unit.PixelFragments);
  return (left + unit.Fragments - 1) / unit.Fragments;
}

//------------------------------------------------------------------------------
int vtkCellRoom::GetCellShift(const Rectangle& tile)
{
  int shift = SMALLEST_CELL_SHIFT;
  while (CellsAcross(tile[2], shift) * CellsAcross(tile[3], shift) > MOST_CELLS)
  {
    ++shift;
  }
  return shift;
}

//------------------------------------------------------------------------------
std::array<int, 2> vtkCellRoom::GetCells(const Rectangle& tile)
{
  const int shift = GetCellShift(tile);
  return { { CellsAcross(tile[2], shift), CellsAcross(tile[3], shift) } };
}

//------------------------------------------------------------------------------
void vtkCellRoom::BeginFrame(const std::vector<Box>& boxes)
{
  this->Moved = !this->Boxes.empty() && this->Boxes != boxes;
  this->Boxes = boxes;
  this->Viewport = this->Drawn.size() == 1 ? this->Drawn[0] : Rectangle{ { 0, 0, 0, 0 } };
  this->Drawn.clear();
}

//------------------------------------------------------------------------------
void vtkCellRoom::BeginTile(const Rectangle& tile, const Unit& unit, std::int64_t initial, std::int64_t allowed)
{
  if (this->Drawn.empty() || this->Drawn.back() != tile)
  {
    this->Drawn.push_back(tile);
  }
  this->Covered = this->GetCovered(tile);
  this->FragmentsOfBox = unit.FragmentsOfBox;
  if (this->Tiles.count(tile) == 0)
  {
    Units counts = initial > 0 ? Spread(tile, unit, initial) : this->Guess(tile, unit, allowed);
    if (this->Tiles.size() >= TilesKept)
    {
      this->Tiles.clear();
    }
    this->Tiles[tile].Counts.swap(counts);
  }

  const Tile& last = this->Tiles[tile];
  this->Least = static_cast<std::int64_t>(last.Counts.size()) * GetLeastUnits(tile, unit);
  this->Guessed = last.Guessed;
  this->Moving = !last.Guessed && (this->Moved || last.FramesMoving > 0);
  this->Ranges = last.Counts;
  if (this->Guessed)
  {
    return;
  }
  Units wide = this->Moving ? this->Foresee(tile, unit) : last.Counts;
  for (std::int64_t& range : wide)
  {
    range = WithReserve(range);
  }
  if (Sum(wide) <= allowed)
  {
    this->Ranges.swap(wide);
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkCellRoom::GetCovered(const Rectangle& tile) const
{
  const auto [across, down] = GetCells(tile);
  const int side = 1 << GetCellShift(tile);
  const int row = across + 2; // steps may lie behind the last cell
  std::vector<double> steps(static_cast<std::size_t>(row) * (down + 2), 0);
  for (const Box& box : this->Boxes)
  {
    const auto ofRows = GetSteps(box[1] - tile[1], box[3] - tile[1], side, down);
    for (const auto& [x, width] : GetSteps(box[0] - tile[0], box[2] - tile[0], side, across))
    {
      for (const auto& [y, height] : ofRows)
      {
        steps[y * row + x] += width * height;
      }
    }
  }
  std::vector<double> covered(static_cast<std::size_t>(across) * down);
  for (int y = 0; y < down; ++y)
  {
    double sum = 0;
    for (int x = 0; x < across; ++x)
    {
      sum += steps[y * row + x];
      covered[y * across + x] = sum + (y > 0 ? covered[(y - 1) * across + x] : 0);
    }
  }
  return covered;
}

//------------------------------------------------------------------------------
vtkCellRoom::Units vtkCellRoom::Guess(const Rectangle& tile, const Unit& unit, std::int64_t allowed) const
{
  const std::int64_t pixels = GetPixels(tile);
  const std::int64_t least = GetLeastUnits(tile, unit);
  Units units;
  for (double covered : this->Covered)
  {
    units.push_back(GetExpectedUnits(unit, unit.FragmentsOfBox * covered, covered, pixels));
  }
  this->TakeOver(tile, units);

  std::int64_t more = 0;
  for (std::int64_t& range : units)
  {
    range = std::max(range, least);
    more += range - least;
  }
  const std::int64_t leastOfAll = least * static_cast<std::int64_t>(units.size());
  const std::int64_t mostOfAll = std::min(allowed / 2, GetMostForeseen(tile, unit));
  const std::int64_t left = std::max<std::int64_t>(0, mostOfAll - leastOfAll);
  if (more > left)
  {
    for (std::int64_t& range : units)
    {
      range = least + (range - least) * left / more;
    }
  }
  return units;
}

//------------------------------------------------------------------------------
// What cells will take while the view moves.
vtkCellRoom::Units vtkCellRoom::Foresee(const Rectangle& tile, const Unit& unit) const
{
  const Tile& last = this->Tiles.at(tile);
  const std::int64_t pixels = GetPixels(tile);
  const Units wide = Widen(last.Counts, GetCells(tile), ReachWhileMoving);
  const std::vector<double> densities = Widen(last.Densities, GetCells(tile), ReachWhileMoving);
  Units units;
  for (std::size_t cell = 0; cell < wide.size(); ++cell)
  {
    const double covered = this->Covered[cell];
    // What comes from farther away than that finds room in units that are not full, or, where those are single
    // fragments, in that of one box.
    const double ofOneBox = unit.Fragments > 1 ? 0 : std::min(covered, static_cast<double>(pixels));
    const double fragments = unit.FragmentsOfBox * std::max(ofOneBox, covered * densities[cell]);
    units.push_back(std::max(wide[cell], GetExpectedUnits(unit, fragments, covered, pixels)));
  }
  return Sum(units) <= GetMostForeseen(tile, unit) ? units : wide;
}

//------------------------------------------------------------------------------
// Gives cells whose middle was seen in a viewport of another size what they took there.
void vtkCellRoom::TakeOver(const Rectangle& tile, Units& counts) const
{
  const Rectangle& from = this->Viewport;
  const auto before = this->Tiles.find(from);
  if (before == this->Tiles.end() || this->Drawn.size() > 1)
  {
    return;
  }
  const auto [across, down] = GetCells(tile);
  const auto [acrossBefore, downBefore] = GetCells(from);
  const int side = 1 << GetCellShift(tile);
  const int sideBefore = 1 << GetCellShift(from);
  const double scale = static_cast<double>(from[3]) / tile[3];
  const double pixels = static_cast<double>(GetPixels(tile)) / static_cast<double>(GetPixels(from));
  const Units wide = Widen(before->second.Counts, GetCells(from), ReachWhileMoving);
  for (int y = 0; y < down; ++y)
  {
    for (int x = 0; x < across; ++x)
    {
      const double column = ((x + 0.5) * side - tile[2] / 2.0) * scale + from[2] / 2.0;
      const double row = (y + 0.5) * side * scale;
      const int u = static_cast<int>(std::floor(column / sideBefore));
      const int v = static_cast<int>(std::floor(row / sideBefore));
      if (u >= 0 && u < acrossBefore && v >= 0 && v < downBefore)
      {
        const auto units = static_cast<double>(wide[v * acrossBefore + u]);
        counts[y * across + x] = WithReserve(static_cast<std::int64_t>(std::ceil(units * pixels)));
      }
    }
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkCellRoom::GetUnits() const
{
  return Sum(this->Ranges);
}

//------------------------------------------------------------------------------
std::int64_t vtkCellRoom::GetUnitsToReserve(std::int64_t allowed) const
{
  const std::int64_t units = this->GetUnits();
  return this->Moving ? std::min(units + units / 2, allowed) : units;
}

//------------------------------------------------------------------------------
bool vtkCellRoom::FinishTile(const Units& counts, const Units& fragments)
{
  Tile& tile = this->Tiles[this->Drawn.back()];
  const auto pixels = static_cast<double>(GetPixels(this->Drawn.back()));
  bool fits = true;
  tile.Densities.clear();
  for (std::size_t cell = 0; cell < counts.size(); ++cell)
  {
    fits = fits && counts[cell] <= this->Ranges[cell];
    const double covered = this->Covered[cell];
    const bool tells = covered >= pixels * LeastToTell;
    tile.Densities.push_back(tells ? static_cast<double>(fragments[cell]) / (this->FragmentsOfBox * covered) : -1);
  }
  this->TooLarge = this->Guessed && this->GetUnits() > 2 * std::max(Sum(counts), this->Least);
  if (fits)
  {
    tile.FramesMoving = std::max(0, tile.FramesMoving - 1);
  }
  else
  {
    tile.FramesMoving = this->Guessed ? 0 : FramesMovingAfterOverflow;
  }
  tile.Counts = counts;
  tile.Guessed = false;
  return fits;
}

//------------------------------------------------------------------------------
void vtkCellRoom::Forget()
{
  this->Tiles.clear();
}
VTK_ABI_NAMESPACE_END
