// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyTiles
 *
 * The parts in which a viewport is drawn where all of it at once would take too much memory. Knows no OpenGL.
 *
 * A frame begins with the tiles that the frame before has ended with, as long as the viewport stays the same: what had
 * to be cut once is cut from the start.
 */
#ifndef vtkTranslucencyTiles_h
#define vtkTranslucencyTiles_h

#include "vtkTranslucencyABINamespace.h"

#include <array>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyTiles
{
public:
  using Rectangle = std::array<int, 4>; // x, y, width, height in window pixels

  /// Of a rectangle, what another one has, too; of a size of 0 where that is nothing.
  static Rectangle Intersect(const Rectangle& a, const Rectangle& b);

  /// Begins a frame that draws this part of the window.
  void BeginFrame(const Rectangle& viewport);

  const Rectangle& GetViewport() const { return this->Viewport; }
  const Rectangle& GetTile() const { return this->Tile; }

  /// Makes the next tile the current one. False if there is none left.
  bool Next();

  /// Forgets the tiles of the frame before: the current one becomes the whole viewport. Does nothing once a tile of
  /// this frame has been cut or finished.
  void UseWholeViewport();

  /// Cuts the current tile into so many parts, or as many as it has pixels along one side, and goes on with the first
  /// of them.
  void Cut(int parts);

  /// Whether the current tile is one pixel, which can't be cut.
  bool IsSmallest() const { return this->Tile[2] * this->Tile[3] == 1; }

  /// The current tile is drawn, with so many fragments, which took so many units of room in the storage.
  void Finish(std::int64_t fragments = 0, std::int64_t units = 0);

  /// Whether the current tile is.
  bool IsFinished() const { return !this->Finished.empty() && this->Finished.front() == this->Tile; }

  /// Of all tiles finished in this frame; and the units of the frame before.
  std::int64_t GetFragments() const { return this->Fragments; }
  std::int64_t GetLastUnits() const { return this->LastUnits; }

  /// The next frame begins with the whole viewport.
  void Forget() { this->Finished.clear(); }

private:
  Rectangle Viewport{ { 0, 0, 0, 0 } };
  Rectangle Tile{ { 0, 0, 0, 0 } };
  std::vector<Rectangle> Waiting;  // to be drawn in this frame, the next one last
  std::vector<Rectangle> Finished; // in this frame, the last one first: what the next frame begins with
  bool IsCut = false;
  std::int64_t Fragments = 0;
  std::int64_t Units = 0;
  std::int64_t LastUnits = 0;
};
VTK_ABI_NAMESPACE_END

#endif
