// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shaders that store fragments, compiled as C++ (ShaderAsCxx.h), to be called by many threads at once: the storages of
 * Module/Shaders/Storage where fragments of a pixel come in any order, and records of pixels under the critical
 * sections of Module/Shaders/CriticalSection.
 */
#ifndef ConcurrentShader_h
#define ConcurrentShader_h

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// What a test breaks, to see that this is found.
enum class Fault
{
  None,
  PlainAdd,       // atomicAdd reads, then writes
  PlainCompSwap,  // atomicCompSwap reads, then writes
  SplitExchange,  // atomicExchange is two atomic operations: no race, but not what is meant
  NoFirstBarrier, // of a critical section's two
  NoSecondBarrier
};

/// Set before threads begin.
inline Fault PresentFault = Fault::None;

/// A fragment of a pixel. Storages keep the first words of the colour.
struct DrawnFragment
{
  int X;
  int Y;
  float Depth;
  std::array<std::uint32_t, 3> Color;
  std::uint32_t Coverage;
};

/// What is drawn to: pixels from an origin on, in cells.
struct DrawnTile
{
  int X;
  int Y;
  int Width;
  int Height;
  std::uint32_t CellShift;
};

class ConcurrentStorage
{
public:
  virtual ~ConcurrentStorage() = default;

  /// An empty storage with that much room in each cell.
  virtual void Begin(const DrawnTile& tile, const std::vector<std::uint32_t>& unitsOfCells) = 0;

  /// Where all threads call it. A helper invocation has no fragment: it must come back, and change nothing.
  virtual void Store(const DrawnFragment& fragment, bool helper) = 0;
  virtual std::uint32_t TakePlace(int x, int y) = 0;

  /// The fragments of a pixel, as the storage's lists give them.
  virtual std::vector<DrawnFragment> Read(int x, int y) = 0;

  /// A cell's word of Storage/CellLayout.glsl.
  virtual std::uint32_t GetWord(int cell, std::uint32_t word) = 0;
};

struct StorageVariant
{
  std::string Name;
  std::string Storage; // the file of Shaders/Storage
  int ColorWords;
  int Samples;
  bool CountsAccesses;
  bool OwnSections; // of pixels
  std::unique_ptr<ConcurrentStorage> (*New)();
};

/// Multi-layer records, of the nearest fragments and the sums of all others.
class ConcurrentRecords
{
public:
  static constexpr int Layers = 4;

  struct Record
  {
    std::vector<float> Depths;
    float TailColor = 0;
    float TailOpacity = 0;
  };

  virtual ~ConcurrentRecords() = default;
  virtual void Begin(const DrawnTile& tile) = 0;
  virtual void Draw(int x, int y, float depth, float color, float opacity, bool helper) = 0;
  virtual Record Read(int x, int y) = 0;
  virtual void TakeLock(int x, int y) = 0; // and keep it
};

struct RecordVariant
{
  std::string Name; // the file of Shaders/CriticalSection
  std::unique_ptr<ConcurrentRecords> (*New)();
};

/// All that were compiled.
const std::vector<StorageVariant>& StorageVariants();
const std::vector<RecordVariant>& RecordVariants();

#endif
