// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellStorage.h"

#include "Common/Bindings.glsl"
#include "Storage/CellLayout.glsl"
#include "vtkCellRoom.h"
#include "vtkFragmentCounter.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyOption.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkTypeInt64 CellWordBytes = 4;
constexpr vtkTypeInt64 LayoutBytes = 16;

vtkTypeInt64 Pixels(const vtkFragmentStorage::Rectangle& tile)
{
  return static_cast<vtkTypeInt64>(tile[2]) * tile[3];
}

vtkTypeInt64 CounterBytes(const vtkFragmentStorage::Rectangle& tile)
{
  const auto [across, down] = vtkCellRoom::GetCells(tile);
  return across * down * static_cast<vtkTypeInt64>(CELL_WORDS * CellWordBytes);
}

// Of a tile, beside the layouts: the counters, and their copy.
vtkTypeInt64 OwnBytes(const vtkFragmentStorage::Rectangle& tile)
{
  return 2 * CounterBytes(tile) + LayoutBytes;
}

vtkTypeInt64 DividedUp(vtkTypeInt64 number, vtkTypeInt64 divisor)
{
  return (number + divisor - 1) / divisor;
}

// A count of two words.
vtkTypeInt64 WideCount(const unsigned int* words)
{
  return static_cast<vtkTypeInt64>(words[1]) << 32 | words[0];
}
}

//------------------------------------------------------------------------------
vtkCellStorage::vtkCellStorage()
  : Room(new vtkCellRoom)
  , Counter(new vtkFragmentCounter)
{
}

//------------------------------------------------------------------------------
vtkCellStorage::~vtkCellStorage() = default;

//------------------------------------------------------------------------------
void vtkCellStorage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InitialFragments: " << this->InitialFragments << "\n";
  os << indent << "CountAccesses: " << this->CountAccesses << "\n";
  os << indent << "Fragments: " << this->Fragments << "\n";
  os << indent << "Bytes: " << this->GetBytes() << "\n";
}

//------------------------------------------------------------------------------
void vtkCellStorage::SetInitialFragments(vtkTypeInt64 fragments)
{
  vtkTranslucencyOption::SetInteger(this, "InitialFragments", this->InitialFragments, fragments, 0);
}

//------------------------------------------------------------------------------
int vtkCellStorage::GetColorWords() const
{
  return (this->ColorFormat == RGBA8 ? 1 : 2) + (this->Channels == 3 ? 1 : 0);
}

//------------------------------------------------------------------------------
vtkCellStorage::Layout vtkCellStorage::GetNodes() const
{
  const int words = 2 + this->GetColorWords();
  const int unitWords = this->GetUnitFragments() * words;
  if (words > MOST_TEXEL_WORDS) // a node is a texel
  {
    return { STORAGE_BINDING_FRAGMENTS, 0, unitWords };
  }
  return { STORAGE_BINDING_FRAGMENTS, 0, unitWords, Use::Written, "fragmentTexels", words };
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCellStorage::GetLayoutBytes(const Layout& layout, const Rectangle& tile, vtkTypeInt64 units) const
{
  return CellWordBytes * (layout.PixelWords * Pixels(tile) + layout.UnitWords * units);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCellStorage::GetUnitsAllowed(
  const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities) const
{
  const auto block = static_cast<double>(capabilities.MaximumBlockBytes);
  double units = static_cast<double>(this->GetMostUnits(tile));
  double pixelBytes = static_cast<double>(OwnBytes(tile));
  double unitBytes = 0;
  for (const Layout& layout : this->GetLayouts()) // with links: they have to fit when they are wanted
  {
    const auto ofPixels = static_cast<double>(this->GetLayoutBytes(layout, tile, 0));
    if (ofPixels > block)
    {
      return -1;
    }
    if (layout.UnitWords > 0)
    {
      const double texels = static_cast<double>(layout.TexelWords * CellWordBytes * capabilities.MaximumTexels);
      const double most = texels > 0 ? std::min(block, texels) : block;
      units = std::min(units, std::floor((most - ofPixels) / static_cast<double>(layout.UnitWords * CellWordBytes)));
    }
    pixelBytes += ofPixels;
    unitBytes += static_cast<double>(layout.UnitWords * CellWordBytes);
  }
  // A single pixel can't be cut: its fragments may pass the limit, but not what the driver can address.
  if (Pixels(tile) > 1)
  {
    units = std::min(units, std::floor((this->GetLimitBytes(capabilities) - pixelBytes) / unitBytes));
  }
  return static_cast<vtkTypeInt64>(std::max(units, -1.0));
}

//------------------------------------------------------------------------------
std::string vtkCellStorage::GetShaderName() const
{
  return std::string(this->GetFileName()) + (this->KeepsDrawOrder ? "InOrder" : "");
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> vtkCellStorage::GetDefines() const
{
  std::map<std::string, std::string> defines = this->Superclass::GetDefines();
  defines["UNITS_ARE_FRAGMENTS"] = this->UnitsAreFragments() ? "1" : "0";
  return defines;
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> vtkCellStorage::GetStoringDefines() const
{
  return { { "COUNT_ACCESSES", this->CountAccesses ? "1" : "0" } };
}

//------------------------------------------------------------------------------
void vtkCellStorage::BeginFrame(const std::vector<Box>& boxes, const vtkTranslucencyCapabilities& capabilities)
{
  this->CountSummed();
  this->Room->BeginFrame(boxes);
  if (this->KeepsDrawOrder != capabilities.KeepsDrawOrder)
  {
    this->KeepsDrawOrder = capabilities.KeepsDrawOrder;
    this->ForgetUnits(); // which may depend on it
  }
}

//------------------------------------------------------------------------------
std::string vtkCellStorage::GetObstacle(
  const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const
{
  const Rectangle row{ { 0, 0, viewport[2], 1 } };
  const vtkTypeInt64 units = this->GetPixelFragments() > 0 ? 0 : viewport[2];
  if (this->GetUnitsAllowed(row, capabilities) >= units)
  {
    return "";
  }
  vtkTypeInt64 needed = OwnBytes(row);
  for (const Layout& layout : this->GetLayouts())
  {
    needed += this->GetLayoutBytes(layout, row, units);
  }
  std::ostringstream out;
  out << "MemoryLimit is " << this->MemoryLimit << " MiB, expected at least "
      << static_cast<double>(needed) / (1024.0 * 1024.0) << " MiB, one row of " << viewport[2]
      << " pixels with one fragment each";
  return out.str();
}

//------------------------------------------------------------------------------
bool vtkCellStorage::Fits(
  vtkTypeInt64 units, const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const
{
  return units <= this->GetUnitsAllowed(viewport, capabilities);
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Outcome vtkCellStorage::Begin(
  const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities)
{
  this->CountSummed();
  this->Tile = tile;
  this->Linked = Links::None;
  this->LimitBytes = this->GetLimitBytes(capabilities);
  this->BlockBytes = static_cast<double>(capabilities.MaximumBlockBytes);
  this->UnitsAllowed = this->GetUnitsAllowed(tile, capabilities);
  const double fragmentsOfBox = this->Samples == 1 ? 2 : this->KeepsDrawOrder ? 2.5 : 5;
  const vtkCellRoom::Unit unit{ this->GetUnitFragments(), this->GetPixelFragments(), fragmentsOfBox };
  const vtkTypeInt64 least = vtkCellRoom::GetUnitsFor(unit, Pixels(tile), Pixels(tile));
  if (this->UnitsAllowed < least)
  {
    this->Units = std::max<vtkTypeInt64>(1, least); // what a fragment a pixel would take, for GetPartsNeeded
    return Outcome::TooLarge;
  }
  if (this->Room->IsTooLarge()) // what was guessed
  {
    this->ReleaseBuffers();
  }
  this->Room->BeginTile(tile, unit, this->InitialFragments, this->UnitsAllowed);
  const vtkTypeInt64 units = this->Room->GetUnits();
  if (units > this->UnitsAllowed) // the limit has been lowered since they were counted
  {
    this->Units = units;
    return Outcome::TooLarge;
  }
  if (!this->ReserveBuffers(units, this->Room->GetUnitsToReserve(this->UnitsAllowed), capabilities))
  {
    return Outcome::OutOfMemory;
  }
  std::vector<unsigned int> cells(CounterBytes(tile) / CellWordBytes, 0);
  vtkTypeInt64 first = 0;
  unsigned int* words = cells.data();
  for (vtkTypeInt64 range : this->Room->GetRanges())
  {
    words[CELL_NEXT] = static_cast<unsigned int>(first);
    words[CELL_FIRST] = static_cast<unsigned int>(first);
    first += range;
    words[CELL_END] = static_cast<unsigned int>(first);
    words += CELL_WORDS;
  }
  const std::array<unsigned int, 4> block{ { static_cast<unsigned int>(vtkCellRoom::GetCellShift(tile)),
    static_cast<unsigned int>(units), 0, 0 } };
  this->LayoutBlock.Upload(block.data(), LayoutBytes);
  this->Counters.Upload(cells.data(), CounterBytes(tile));
  this->Counters.BindStorage(STORAGE_BINDING_COUNTERS);
  this->LayoutBlock.BindUniform(UNIFORM_BINDING_STORAGE);
  for (const Layout& own : this->GetLayouts())
  {
    if (own.Used != Use::Links)
    {
      this->Buffers[own.Binding].BindStorage(own.Binding);
    }
    if (own.Used == Use::Cleared)
    {
      this->Buffers[own.Binding].Clear(this->GetLayoutBytes(own, tile, units));
    }
  }
  return Outcome::Complete;
}

//------------------------------------------------------------------------------
bool vtkCellStorage::ReserveBuffers(
  vtkTypeInt64 units, vtkTypeInt64 room, const vtkTranslucencyCapabilities& capabilities)
{
  const std::vector<Layout> layouts = this->GetLayouts();
  const bool hasRoom = std::all_of(layouts.begin(), layouts.end(),
    [&](const Layout& layout)
    {
      return layout.Used == Use::Links ||
        this->GetLayoutBytes(layout, this->Tile, units) <= this->Buffers[layout.Binding].GetBytes();
    });
  room = hasRoom ? units : room;
  vtkTypeInt64 kept =
    std::max(this->Counters.GetBytes() + this->CountersRead.GetBytes() + LayoutBytes, OwnBytes(this->Tile));
  for (const Layout& layout : layouts)
  {
    kept += std::max(this->Buffers[layout.Binding].GetBytes(), this->GetLayoutBytes(layout, this->Tile, room));
  }
  if (static_cast<double>(kept) > this->GetLimitBytes(capabilities))
  {
    this->ReleaseBuffers(); // what earlier, larger tiles left
  }
  const auto reserve = [&](const Layout& layout)
  {
    vtkTranslucencyBuffer& buffer = this->Buffers[layout.Binding];
    return layout.Used == Use::Links || buffer.Reserve(this->GetLayoutBytes(layout, this->Tile, room)) ||
      buffer.Reserve(this->GetLayoutBytes(layout, this->Tile, units));
  };
  return this->Counters.Reserve(CounterBytes(this->Tile)) &&
    this->CountersRead.ReserveForReading(CounterBytes(this->Tile)) && this->LayoutBlock.Reserve(LayoutBytes) &&
    std::all_of(layouts.begin(), layouts.end(), reserve);
}

//------------------------------------------------------------------------------
bool vtkCellStorage::ReserveLinks()
{
  if (this->Linked != Links::None)
  {
    return true;
  }
  const vtkTypeInt64 units = this->Room->GetUnits();
  for (const Layout& layout : this->GetLayouts())
  {
    if (layout.Used == Use::Links)
    {
      vtkTranslucencyBuffer& buffer = this->Buffers[layout.Binding];
      if (!buffer.Reserve(this->GetLayoutBytes(layout, this->Tile, units)))
      {
        return false;
      }
      buffer.BindStorage(layout.Binding);
    }
  }
  // Resolves come again for each sample, when some lists have been moved: one program then does for both.
  this->Linked = this->Samples > 1 ? Links::Mixed : Links::Made;
  return true;
}

//------------------------------------------------------------------------------
void vtkCellStorage::FinishLinks()
{
  this->Linked = this->Linked == Links::None ? Links::None : Links::Mixed;
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Links vtkCellStorage::GetLinks() const
{
  return this->Linked;
}

//------------------------------------------------------------------------------
void vtkCellStorage::CopyCells()
{
  this->CountersRead.Copy(this->Counters, CounterBytes(this->Tile));
}

//------------------------------------------------------------------------------
std::vector<unsigned int> vtkCellStorage::ReadCells() const
{
  std::vector<unsigned int> cells(CounterBytes(this->Tile) / CellWordBytes);
  this->CountersRead.Download(cells.data(), CounterBytes(this->Tile));
  return cells;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCellStorage::CountUnits(const unsigned int* cell) const
{
  return cell[CELL_NEXT] - cell[CELL_FIRST] +
    DividedUp(static_cast<vtkTypeInt64>(cell[CELL_INSERTED]), this->GetUnitFragments());
}

//------------------------------------------------------------------------------
// Fills in what shaders have not counted, for later shaders, too.
void vtkCellStorage::CountFragments(std::vector<unsigned int>& cells)
{
  if (this->UnitsAreFragments()) // which shaders know
  {
    for (std::size_t first = 0; first < cells.size(); first += CELL_WORDS)
    {
      cells[first + CELL_FRAGMENTS] = cells[first + CELL_NEXT] - cells[first + CELL_FIRST];
    }
  }
  else if (this->KeepsDrawOrder && this->Linked == Links::None) // else there are no entries any more
  {
    this->Counter->Count(cells, this->Tile, this->GetUnitFragments(), this->Buffers[STORAGE_BINDING_TABLE],
      [this](const unsigned int* entries, int count) { return this->CountFree(entries, count); });
    this->Counters.Upload(cells.data(), CounterBytes(this->Tile));
  }
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Outcome vtkCellStorage::End()
{
  this->CopyCells();
  return this->Count();
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Outcome vtkCellStorage::End(const Sum& sum)
{
  if (sum.Overflowed)
  {
    return this->End();
  }
  this->CopyCells();
  this->Summed = true;
  this->Fragments = sum.Fragments;
  this->Units = sum.Units;
  this->FullestCell = sum.FullestCell;
  return Outcome::Complete;
}

//------------------------------------------------------------------------------
// Where the order of drawing is kept the application has a part in counting: CountFragments.
const char* vtkCellStorage::GetSummary() const
{
  return this->KeepsDrawOrder ? nullptr : "Storage/SumCells.glsl";
}

//------------------------------------------------------------------------------
void vtkCellStorage::CountSummed()
{
  if (this->Summed)
  {
    this->Summed = false;
    this->Count();
  }
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Outcome vtkCellStorage::Count()
{
  std::vector<unsigned int> cells = this->ReadCells();
  this->CountFragments(cells);
  vtkCellRoom::Units counts;
  vtkCellRoom::Units held;
  this->Fragments = 0;
  this->FullestCell = 0;
  for (std::size_t first = 0; first < cells.size(); first += CELL_WORDS)
  {
    const unsigned int* words = &cells[first];
    const vtkTypeInt64 fragments = static_cast<vtkTypeInt64>(words[CELL_FRAGMENTS]) + words[CELL_INSERTED];
    counts.push_back(this->CountUnits(words));
    held.push_back(fragments);
    this->Fragments += fragments;
    this->FullestCell = std::max(this->FullestCell, fragments);
  }
  this->Units = std::accumulate(counts.begin(), counts.end(), vtkTypeInt64(0));
  if (this->Room->FinishTile(counts, held))
  {
    this->Learn(cells);
    return Outcome::Complete;
  }
  const vtkTypeInt64 most = *std::max_element(counts.begin(), counts.end());
  return this->Units <= this->UnitsAllowed && most * this->GetUnitFragments() <= MOST_FRAGMENTS_OF_CELL
    ? Outcome::Grown
    : Outcome::TooLarge;
}

//------------------------------------------------------------------------------
int vtkCellStorage::GetPartsNeeded() const
{
  double parts = 2;
  double bytes = static_cast<double>(OwnBytes(this->Tile));
  for (const Layout& layout : this->GetLayouts())
  {
    const auto own = static_cast<double>(this->GetLayoutBytes(layout, this->Tile, this->Units));
    parts = std::max(parts, std::ceil(own / this->BlockBytes));
    bytes += own;
  }
  parts = std::max(parts, std::ceil(bytes / this->LimitBytes));
  return static_cast<int>(std::min(parts, static_cast<double>(Pixels(this->Tile))));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCellStorage::GetFragments() const
{
  return this->Fragments;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCellStorage::GetUnits() const
{
  return this->Units;
}

//------------------------------------------------------------------------------
int vtkCellStorage::GetMostExpected() const
{
  const vtkTypeInt64 pixels = vtkTypeInt64(1) << (2 * vtkCellRoom::GetCellShift(this->Tile));
  return static_cast<int>(std::min<vtkTypeInt64>(VTK_INT_MAX, DividedUp(this->FullestCell, pixels)));
}

//------------------------------------------------------------------------------
vtkStorageDesign::Accesses vtkCellStorage::GetAccesses()
{
  this->CopyCells();
  vtkStorageDesign::Accesses accesses;
  const std::vector<unsigned int> cells = this->ReadCells();
  for (std::size_t first = 0; first < cells.size(); first += CELL_WORDS)
  {
    const unsigned int* words = &cells[first];
    accesses.Stores += words[CELL_STORES];
    accesses.Table += words[CELL_TABLE];
    accesses.Reads += WideCount(words + CELL_READS);
    accesses.SecondDepth += WideCount(words + CELL_SECOND_DEPTH);
    accesses.FrameBuffer += WideCount(words + CELL_FRAME_BUFFER);
  }
  return accesses;
}

//------------------------------------------------------------------------------
std::vector<vtkFragmentStorage::Texels> vtkCellStorage::GetTexels()
{
  std::vector<Texels> texels{ { "counterTexels", &this->Counters, 1 } };
  for (const Layout& layout : this->GetLayouts())
  {
    if (layout.Sampler)
    {
      texels.push_back({ layout.Sampler, &this->Buffers[layout.Binding], layout.TexelWords });
    }
  }
  return texels;
}

//------------------------------------------------------------------------------
std::array<int, 2> vtkCellStorage::GetCells() const
{
  return vtkCellRoom::GetCells(this->Tile);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCellStorage::GetBytes() const
{
  vtkTypeInt64 bytes = this->Counters.GetBytes() + this->CountersRead.GetBytes() + this->LayoutBlock.GetBytes();
  for (const auto& buffer : this->Buffers)
  {
    bytes += buffer.second.GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkCellStorage::ClearTable()
{
  this->Buffers[STORAGE_BINDING_TABLE].Clear(Pixels(this->Tile) * CellWordBytes);
}

//------------------------------------------------------------------------------
void vtkCellStorage::ForgetUnits()
{
  this->Summed = false;
  this->Room->Forget();
}

//------------------------------------------------------------------------------
void vtkCellStorage::ReleaseBuffers(bool contextAlive)
{
  this->Counters.Release(contextAlive);
  this->CountersRead.Release(contextAlive);
  for (auto& buffer : this->Buffers)
  {
    buffer.second.Release(contextAlive);
  }
}

//------------------------------------------------------------------------------
void vtkCellStorage::Release(bool contextAlive)
{
  this->ReleaseBuffers(contextAlive);
  this->LayoutBlock.Release(contextAlive);
  this->ForgetUnits();
}
VTK_ABI_NAMESPACE_END
