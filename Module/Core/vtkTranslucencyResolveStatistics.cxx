// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyResolveStatistics.h"

#include "Common/Bindings.glsl"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkTypeInt64 StatisticsWordBytes = sizeof(unsigned int);
constexpr vtkTypeInt64 FrameBytes = StatisticsWordBytes * STATISTICS_WORDS;

vtkTypeInt64 BytesFor(const vtkTranslucencyTiles::Rectangle& tile)
{
  using Statistics = vtkTranslucencyResolveStatistics;
  return FrameBytes + StatisticsWordBytes * Statistics::GetSquares(tile[2]) * Statistics::GetSquares(tile[3]);
}
}

//------------------------------------------------------------------------------
int vtkTranslucencyResolveStatistics::GetSquares(int pixels)
{
  return (pixels + RESOLVE_SQUARE - 1) / RESOLVE_SQUARE;
}

//------------------------------------------------------------------------------
void vtkTranslucencyResolveStatistics::BeginFrame()
{
  this->InUse = false;
  this->Read.emplace(); // zeros, until a shader counts: most techniques have none that does
}

//------------------------------------------------------------------------------
bool vtkTranslucencyResolveStatistics::Use(const Rectangle& viewport)
{
  if (!this->InUse)
  {
    // No tile has more squares than all of them together: what was counted is not lost by growing in between.
    if (!this->Block.Reserve(BytesFor(viewport)) || !this->Copy.ReserveForReading(sizeof(Words)))
    {
      return false;
    }
    this->Block.Clear(FrameBytes);
    this->InUse = true;
  }
  this->Block.BindStorage(STORAGE_BINDING_STATISTICS);
  return true;
}

//------------------------------------------------------------------------------
void vtkTranslucencyResolveStatistics::BeginSum()
{
  this->Block.Clear(
    StatisticsWordBytes * (STATISTICS_RESOLVES - STATISTICS_TILE), StatisticsWordBytes * STATISTICS_TILE);
}

//------------------------------------------------------------------------------
void vtkTranslucencyResolveStatistics::BeginTile(const Rectangle& tile)
{
  constexpr vtkTypeInt64 before = StatisticsWordBytes * STATISTICS_RESOLVES;
  this->Block.Clear(BytesFor(tile) - before, before);
}

//------------------------------------------------------------------------------
vtkFragmentStorage::Sum vtkTranslucencyResolveStatistics::GetSum()
{
  const Words& words = this->GetWords();
  return { words.Overflowed != 0, words.Fragments, words.Units, words.FullestCell };
}

//------------------------------------------------------------------------------
void vtkTranslucencyResolveStatistics::Release(bool contextAlive)
{
  this->Block.Release(contextAlive);
  this->Copy.Release(contextAlive);
}

//------------------------------------------------------------------------------
const vtkTranslucencyResolveStatistics::Words& vtkTranslucencyResolveStatistics::GetWords()
{
  if (!this->Read)
  {
    this->Read.emplace();
    this->Copy.Copy(this->Block, sizeof(Words));
    this->Copy.Download(&*this->Read, sizeof(Words));
  }
  return *this->Read;
}
VTK_ABI_NAMESPACE_END
