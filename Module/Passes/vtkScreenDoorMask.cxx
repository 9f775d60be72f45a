// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScreenDoorMask.h"

#include <algorithm>
#include <cmath>
#include <random>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A pattern of filled cells on a torus, and how crowded it is around each cell.
class Pattern
{
public:
  explicit Pattern(int size)
    : Size(size)
    , Filled(size * size, 0)
    , Crowd(size * size, 0.0)
    , Kernel(2 * size * size)
  {
    constexpr double sigma = 1.5; // cells, Ulichney's choice
    for (int i = 0; i < 2 * size * size; ++i)
    {
      const int x = std::min(i % size, size - i % size);
      const int y = std::min(i / (2 * size), size - i / (2 * size));
      this->Kernel[i] = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
    }
  }

  bool IsFilled(int cell) const { return this->Filled[cell] != 0; }

  void Set(int cell, bool filled)
  {
    this->Filled[cell] = filled ? 1 : 0;
    const double sign = filled ? 1 : -1;
    for (int y = 0; y < this->Size; ++y)
    {
      const int up = (y + this->Size - cell / this->Size) % this->Size;
      const double* kernel = &this->Kernel[up * 2 * this->Size + this->Size - cell % this->Size];
      double* crowd = &this->Crowd[y * this->Size];
      for (int x = 0; x < this->Size; ++x)
      {
        crowd[x] += sign * kernel[x];
      }
    }
  }

  /// The filled cell with the most filled ones around it.
  int FindTightestCluster() const
  {
    return this->Find(true, [this](int a, int b) { return this->Crowd[a] > this->Crowd[b]; });
  }

  /// The empty cell with the fewest filled ones around it. It is also the tightest cluster of empty cells, since filled
  /// and empty ones together are everywhere alike: that is what the method asks for when more than half is filled.
  int FindLargestVoid() const
  {
    return this->Find(false, [this](int a, int b) { return this->Crowd[a] < this->Crowd[b]; });
  }

private:
  template <typename Better>
  int Find(bool filled, const Better& better) const
  {
    int best = -1;
    for (int cell = 0; cell < this->Size * this->Size; ++cell)
    {
      if (this->IsFilled(cell) == filled && (best < 0 || better(cell, best)))
      {
        best = cell;
      }
    }
    return best;
  }

  int Size;
  std::vector<char> Filled;
  std::vector<double> Crowd;
  std::vector<double> Kernel; // each row twice, so that it need not be wrapped around
};

/// A tenth of the cells, scattered at random and then moved apart until the tightest cluster lies where the largest
/// void would be.
Pattern Scatter(int size, int count)
{
  Pattern pattern(size);
  std::mt19937 random(1993);
  for (int filled = 0; filled < count;)
  {
    const int cell = static_cast<int>(random() % static_cast<unsigned int>(size * size));
    if (!pattern.IsFilled(cell))
    {
      pattern.Set(cell, true);
      ++filled;
    }
  }
  for (;;)
  {
    const int cluster = pattern.FindTightestCluster();
    pattern.Set(cluster, false);
    const int hole = pattern.FindLargestVoid();
    pattern.Set(hole, true);
    if (hole == cluster)
    {
      return pattern;
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<unsigned int> vtkScreenDoorMask::MakeOrdered(int size)
{
  std::vector<unsigned int> ranks{ 0 };
  for (int half = 1; half < size; half *= 2)
  {
    // The quarters, a cell of each in turn: first one diagonal, then the other.
    constexpr unsigned int turns[2][2] = { { 0, 2 }, { 3, 1 } };
    std::vector<unsigned int> larger(4 * ranks.size());
    for (int y = 0; y < 2 * half; ++y)
    {
      for (int x = 0; x < 2 * half; ++x)
      {
        larger[y * 2 * half + x] = 4 * ranks[y % half * half + x % half] + turns[y / half][x / half];
      }
    }
    ranks = larger;
  }
  return ranks;
}

//------------------------------------------------------------------------------
std::vector<unsigned int> vtkScreenDoorMask::MakeBlueNoise(int size)
{
  const int cells = size * size;
  const int scattered = std::max(1, cells / 10);
  const Pattern start = Scatter(size, scattered);
  std::vector<unsigned int> ranks(cells);

  Pattern pattern = start;
  for (int rank = scattered - 1; rank >= 0; --rank)
  {
    const int cluster = pattern.FindTightestCluster();
    pattern.Set(cluster, false);
    ranks[cluster] = static_cast<unsigned int>(rank);
  }
  pattern = start;
  for (int rank = scattered; rank < cells; ++rank)
  {
    const int hole = pattern.FindLargestVoid();
    pattern.Set(hole, true);
    ranks[hole] = static_cast<unsigned int>(rank);
  }
  return ranks;
}
VTK_ABI_NAMESPACE_END
