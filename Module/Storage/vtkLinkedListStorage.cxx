#include "vtkLinkedListStorage.h"

#include "Common/Bindings.glsl"
#include "Storage/LinkedListLayout.glsl"
#include "vtkTranslucencyCapabilities.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

vtkStandardNewMacro(vtkLinkedListStorage);

namespace
{
constexpr vtkTypeInt64 WordBytes = 4;
constexpr vtkTypeInt64 LayoutBytes = 16;
constexpr int FramesMovingAfterOverflow = 30;
constexpr std::size_t LayoutsKept = 256;

vtkTypeInt64 Pixels(const vtkFragmentStorage::Rectangle& tile)
{
  return static_cast<vtkTypeInt64>(tile[2]) * tile[3];
}

int CellsAcross(int pixels, int shift)
{
  return (pixels + (1 << shift) - 1) >> shift;
}

int SmallestCellShift(const vtkFragmentStorage::Rectangle& tile)
{
  int shift = LIST_SMALLEST_CELL_SHIFT;
  while (CellsAcross(tile[2], shift) * CellsAcross(tile[3], shift) > LIST_MOST_CELLS)
  {
    ++shift;
  }
  return shift;
}

vtkTypeInt64 CounterBytes(const vtkFragmentStorage::Rectangle& tile)
{
  const int shift = SmallestCellShift(tile);
  return CellsAcross(tile[2], shift) * CellsAcross(tile[3], shift) *
    static_cast<vtkTypeInt64>(LIST_COUNTER_STRIDE * WordBytes);
}
}

//------------------------------------------------------------------------------
void vtkLinkedListStorage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fragments: " << this->Fragments << "\n";
  os << indent << "Bytes: " << this->GetBytes() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkLinkedListStorage::GetShaderName() const
{
  return "LinkedList";
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListStorage::GetNodeBytes() const
{
  return (this->ColorFormat == RGBA8 ? 3 : 4) * WordBytes + (this->Channels == 3 ? WordBytes : 0);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListStorage::GetNodesAllowed(
  const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities) const
{
  const double table = static_cast<double>(Pixels(tile) * WordBytes);
  const double block = static_cast<double>(capabilities.MaximumBlockBytes);
  // A single pixel can't be cut: its fragments may pass the limit, but not what the driver can address.
  const double limit = Pixels(tile) == 1
    ? block
    : this->GetLimitBytes(capabilities) - table - static_cast<double>(CounterBytes(tile) + LayoutBytes);
  const double bytes = table > block ? 0 : std::min(limit, block);
  // Heads have so many bits for a node's number, and 0 is none.
  return static_cast<vtkTypeInt64>(
    std::clamp(std::floor(bytes / static_cast<double>(this->GetNodeBytes())), 0.0,
      static_cast<double>(LIST_HEAD_MASK - 1)));
}

//------------------------------------------------------------------------------
std::string vtkLinkedListStorage::GetObstacle(
  const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const
{
  const Rectangle row{ { 0, 0, viewport[2], 1 } };
  if (this->GetNodesAllowed(row, capabilities) >= viewport[2])
  {
    return "";
  }
  const double needed = static_cast<double>(
    viewport[2] * (WordBytes + this->GetNodeBytes()) + CounterBytes(row) + LayoutBytes);
  std::ostringstream out;
  out << "MemoryLimit is " << this->MemoryLimit << " MiB, expected at least "
      << needed / (1024.0 * 1024.0) << " MiB, one row of " << viewport[2]
      << " pixels with one fragment each";
  return out.str();
}

//------------------------------------------------------------------------------
bool vtkLinkedListStorage::Fits(vtkTypeInt64 fragments, const Rectangle& viewport,
  const vtkTranslucencyCapabilities& capabilities) const
{
  return fragments <= this->GetNodesAllowed(viewport, capabilities);
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Outcome vtkLinkedListStorage::Begin(
  const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities)
{
  this->Tile = tile;
  this->NodesAllowed = this->GetNodesAllowed(tile, capabilities);
  if (this->NodesAllowed < Pixels(tile))
  {
    this->Fragments = Pixels(tile); // what a fragment a pixel would take, for GetPartsNeeded
    return Outcome::TooLarge;
  }
  if (this->Layouts.count(tile) == 0)
  {
    if (this->Layouts.size() >= LayoutsKept)
    {
      this->Layouts.clear();
    }
    TileLayout& layout = this->Layouts[tile];
    layout.CellShift = SmallestCellShift(tile);
    layout.CellsPerRow = CellsAcross(tile[2], layout.CellShift);
    layout.Rows = CellsAcross(tile[3], layout.CellShift);
  }

  this->Ranges = this->GetRanges(this->Layouts[tile]);
  const vtkTypeInt64 nodes =
    std::accumulate(this->Ranges.begin(), this->Ranges.end(), vtkTypeInt64(0));
  if (nodes > this->NodesAllowed) // the limit has been lowered since they were counted
  {
    this->Fragments = nodes;
    return Outcome::TooLarge;
  }
  // While the view moves, the next frames will want more: rather once too much than a little more in every frame.
  const bool moving = this->Layouts[tile].FramesMoving > 0;
  const vtkTypeInt64 room = moving ? std::min(nodes + nodes / 2, this->NodesAllowed) : nodes;
  if (!this->ReserveBuffers(nodes * this->GetNodeBytes(), room * this->GetNodeBytes(), capabilities))
  {
    return Outcome::OutOfMemory;
  }
  std::vector<unsigned int> counters(CounterBytes(tile) / WordBytes, 0);
  vtkTypeInt64 first = 0;
  for (std::size_t cell = 0; cell < this->Ranges.size(); ++cell)
  {
    counters[cell * LIST_COUNTER_STRIDE] = static_cast<unsigned int>(first);
    counters[cell * LIST_COUNTER_STRIDE + 1] = static_cast<unsigned int>(first);
    first += this->Ranges[cell];
    counters[cell * LIST_COUNTER_STRIDE + 2] = static_cast<unsigned int>(first);
  }
  const TileLayout& layout = this->Layouts[tile];
  const std::array<unsigned int, 4> words{ { static_cast<unsigned int>(layout.CellShift),
    static_cast<unsigned int>(layout.CellsPerRow), static_cast<unsigned int>(nodes), 0 } };
  this->Layout.Upload(words.data(), LayoutBytes);
  this->Counters.Upload(counters.data(), CounterBytes(tile));
  this->Table.Clear(Pixels(tile) * WordBytes);
  this->Counters.BindStorage(STORAGE_BINDING_COUNTERS);
  this->Table.BindStorage(STORAGE_BINDING_TABLE);
  this->Nodes.BindStorage(STORAGE_BINDING_FRAGMENTS);
  this->Layout.BindUniform(UNIFORM_BINDING_STORAGE);
  return Outcome::Complete;
}

//------------------------------------------------------------------------------
std::vector<vtkTypeInt64> vtkLinkedListStorage::GetRanges(const TileLayout& layout) const
{
  const int across = layout.CellsPerRow;
  const int rows = layout.Rows;
  const vtkTypeInt64 pixelsOfCell = vtkTypeInt64(1) << (2 * layout.CellShift);
  std::vector<vtkTypeInt64> tight(static_cast<std::size_t>(across) * rows, pixelsOfCell);
  if (layout.Counts.empty())
  {
    return tight; // a fragment a pixel, to begin with
  }
  tight = layout.Counts;
  std::vector<vtkTypeInt64> wide(tight.size());
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < across; ++x)
    {
      vtkTypeInt64 most = layout.Counts[y * across + x];
      const int reach = layout.FramesMoving > 0 ? 2 : 0;
      for (int v = std::max(0, y - reach); v <= std::min(rows - 1, y + reach); ++v)
      {
        for (int u = std::max(0, x - reach); u <= std::min(across - 1, x + reach); ++u)
        {
          most = std::max(most, layout.Counts[v * across + u]);
        }
      }
      wide[y * across + x] = most + most / 8;
    }
  }
  // What was counted has to fit; what is more than that only if the limit allows it.
  const bool fits =
    std::accumulate(wide.begin(), wide.end(), vtkTypeInt64(0)) <= this->NodesAllowed;
  return fits ? wide : tight;
}

//------------------------------------------------------------------------------
bool vtkLinkedListStorage::ReserveBuffers(
  vtkTypeInt64 nodeBytes, vtkTypeInt64 roomBytes, const vtkTranslucencyCapabilities& capabilities)
{
  if (nodeBytes <= this->Nodes.GetBytes())
  {
    roomBytes = nodeBytes; // there is room already
  }
  const vtkTypeInt64 tableBytes = Pixels(this->Tile) * WordBytes;
  const vtkTypeInt64 kept = std::max(this->Table.GetBytes(), tableBytes) +
    std::max(this->Nodes.GetBytes(), roomBytes) +
    std::max(this->Counters.GetBytes(), CounterBytes(this->Tile)) + LayoutBytes;
  if (static_cast<double>(kept) > this->GetLimitBytes(capabilities))
  {
    this->Counters.Release(); // what earlier, larger tiles left
    this->Table.Release();
    this->Nodes.Release();
  }
  return this->Table.Reserve(tableBytes) && this->Counters.Reserve(CounterBytes(this->Tile)) &&
    (this->Nodes.Reserve(roomBytes) || this->Nodes.Reserve(nodeBytes)) && this->Layout.Reserve(LayoutBytes);
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Outcome vtkLinkedListStorage::End()
{
  TileLayout& layout = this->Layouts[this->Tile];
  std::vector<unsigned int> counters(CounterBytes(this->Tile) / WordBytes);
  this->Counters.Download(counters.data(), CounterBytes(this->Tile));
  const bool first = layout.Counts.empty();
  layout.Counts.resize(this->Ranges.size());
  bool overflow = false;
  this->Fragments = 0;
  this->FullestCell = 0;
  for (std::size_t cell = 0; cell < this->Ranges.size(); ++cell)
  {
    layout.Counts[cell] =
      counters[cell * LIST_COUNTER_STRIDE] - counters[cell * LIST_COUNTER_STRIDE + 1];
    this->Fragments += layout.Counts[cell];
    this->FullestCell = std::max(this->FullestCell, layout.Counts[cell]);
    overflow = overflow || layout.Counts[cell] > this->Ranges[cell];
  }
  if (!overflow)
  {
    layout.FramesMoving = std::max(0, layout.FramesMoving - 1);
    return Outcome::Complete;
  }
  layout.FramesMoving = first ? 0 : FramesMovingAfterOverflow;
  return this->Fragments <= this->NodesAllowed && this->FullestCell <= LIST_MOST_NODES_OF_CELL
    ? Outcome::Grown
    : Outcome::TooLarge;
}

//------------------------------------------------------------------------------
int vtkLinkedListStorage::GetPartsNeeded() const
{
  const vtkTypeInt64 allowed = std::max<vtkTypeInt64>(1, this->NodesAllowed);
  return static_cast<int>(
    std::clamp<vtkTypeInt64>((this->Fragments + allowed - 1) / allowed, 2, Pixels(this->Tile)));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListStorage::GetFragments() const
{
  return this->Fragments;
}

//------------------------------------------------------------------------------
int vtkLinkedListStorage::GetMostExpected() const
{
  const vtkTypeInt64 pixels = vtkTypeInt64(1) << (2 * SmallestCellShift(this->Tile));
  return static_cast<int>(
    std::min<vtkTypeInt64>(VTK_INT_MAX, (this->FullestCell + pixels - 1) / pixels));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListStorage::GetBytes() const
{
  return this->Counters.GetBytes() + this->Table.GetBytes() + this->Nodes.GetBytes() +
    this->Layout.GetBytes();
}

//------------------------------------------------------------------------------
void vtkLinkedListStorage::Release(bool contextAlive)
{
  this->Counters.Release(contextAlive);
  this->Table.Release(contextAlive);
  this->Nodes.Release(contextAlive);
  this->Layout.Release(contextAlive);
  this->Layouts.clear();
}
