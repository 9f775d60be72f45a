// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyTiles.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTranslucencyTiles::Rectangle vtkTranslucencyTiles::Intersect(const Rectangle& a, const Rectangle& b)
{
  const int x = std::max(a[0], b[0]);
  const int y = std::max(a[1], b[1]);
  return { { x, y, std::max(0, std::min(a[0] + a[2], b[0] + b[2]) - x),
    std::max(0, std::min(a[1] + a[3], b[1] + b[3]) - y) } };
}

//------------------------------------------------------------------------------
void vtkTranslucencyTiles::BeginFrame(const Rectangle& viewport)
{
  if (this->Viewport != viewport)
  {
    this->Viewport = viewport;
    this->Finished.clear();
  }
  this->Waiting.swap(this->Finished);
  this->Finished.clear();
  if (this->Waiting.empty())
  {
    this->Waiting.push_back(viewport);
  }
  this->Tile = viewport;
  this->IsCut = false;
  this->LastUnits = this->Units;
  this->Units = 0;
  this->Fragments = 0;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyTiles::Next()
{
  if (this->Waiting.empty())
  {
    return false;
  }
  this->Tile = this->Waiting.back();
  this->Waiting.pop_back();
  return this->Tile[2] > 0 && this->Tile[3] > 0;
}

//------------------------------------------------------------------------------
void vtkTranslucencyTiles::UseWholeViewport()
{
  if (!this->IsCut && this->Finished.empty())
  {
    this->Waiting.clear();
    this->Tile = this->Viewport;
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyTiles::Cut(int parts)
{
  // Strips of rows while there are enough rows: neighbours in memory stay together. Then pieces of a row.
  const int axis = this->Tile[3] > 1 ? 1 : 0;
  const int length = this->Tile[2 + axis];
  parts = std::min(parts, length);
  this->IsCut = true;
  for (int part = parts - 1; part >= 0; --part)
  {
    const int from = static_cast<int>(static_cast<std::int64_t>(length) * part / parts);
    const int to = static_cast<int>(static_cast<std::int64_t>(length) * (part + 1) / parts);
    Rectangle piece = this->Tile;
    piece[axis] += from;
    piece[2 + axis] = to - from;
    this->Waiting.push_back(piece);
  }
  this->Tile = this->Waiting.back();
  this->Waiting.pop_back();
}

//------------------------------------------------------------------------------
void vtkTranslucencyTiles::Finish(std::int64_t fragments, std::int64_t units)
{
  this->Finished.insert(this->Finished.begin(), this->Tile);
  this->Fragments += fragments;
  this->Units += units;
}
VTK_ABI_NAMESPACE_END
