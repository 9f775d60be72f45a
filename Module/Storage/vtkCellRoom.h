// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCellRoom
 *
 * How many units of room each cell of a tile gets, before it is drawn. Knows no OpenGL.
 *
 * - A tile that was never drawn: two fragments per pixel for each box of a prop, the front and the back of a closed
 *   surface, at least 1 in all, and less where these would be more than 16 on average. In multi-sampled windows a
 *   quarter more where the driver keeps the order of drawing, and else five: pixels on edges hold a fragment of each
 *   triangle, if these are not merged.
 * - A viewport of another size than the one before: what was seen there, scaled about the middle to the new height.
 * - A tile that was drawn before: what its cells took, and an eighth more.
 * - The same while the view moves: what the fullest of a cell and its neighbours within two cells took, or, if that is
 *   more, what they held of two fragments for each box times the boxes that lie there now, unless these would be more
 *   than 16 on average; where units are single fragments at least two for each pixel that boxes cover; and an eighth
 *   more. The view moves where boxes are others than in the frame before, and for a
 *   while after a frame that did not fit.
 *
 * More than was counted is given only where the limit allows it, and what is guessed takes half of the limit at most.
 */
#ifndef vtkCellRoom_h
#define vtkCellRoom_h

#include "vtkTranslucencyABINamespace.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCellRoom
{
public:
  using Rectangle = std::array<int, 4>; // x, y, width, height in window pixels
  using Box = std::array<double, 4>;    // left, bottom, right, top in window pixels
  using Units = std::vector<std::int64_t>;

  /// What a unit is in which room is given.
  struct Unit
  {
    int Fragments = 1;         // that it has room for
    int PixelFragments = 0;    // that a pixel has room for before any unit is taken
    double FragmentsOfBox = 2; // of a pixel that a prop's box covers, as a guess
  };

  /// The units that fragments take that are spread evenly over pixels.
  static std::int64_t GetUnitsFor(const Unit& unit, std::int64_t fragments, std::int64_t pixels);

  /// Cells are 2^shift pixels wide and high: 16 pixels, or more where there would be too many.
  static int GetCellShift(const Rectangle& tile);
  static std::array<int, 2> GetCells(const Rectangle& tile); // across, down

  /// Before the first tile of a frame: where the props lie.
  void BeginFrame(const std::vector<Box>& boxes);

  /// Gives room to the cells of a tile: allowed units at most, if what was counted fits. Initial is how many fragments
  /// there is room for in a tile that was never drawn; 0 if that is to be guessed.
  void BeginTile(const Rectangle& tile, const Unit& unit, std::int64_t initial, std::int64_t allowed);

  /// The units that each cell may take, from below, and in all.
  const Units& GetRanges() const { return this->Ranges; }
  std::int64_t GetUnits() const;

  /// More than that is wanted if memory has to be taken: while the view moves the next frames will want more. Rather
  /// once too much than a little more in every frame.
  std::int64_t GetUnitsToReserve(std::int64_t allowed) const;

  /// The units that each cell of the tile has taken, and the fragments that it holds; false if a cell has taken more
  /// units than it may.
  bool FinishTile(const Units& counts, const Units& fragments);

  /// Whether the last tile has left more than half of a guess empty, and that is more than one fragment per pixel.
  bool IsTooLarge() const { return this->TooLarge; }

  /// Forgets what cells took: units are others now.
  void Forget();

private:
  struct Tile
  {
    Units Counts;         // that each cell took; or what it gets, if the tile was never drawn
    bool Guessed = true;  // it was not
    int FramesMoving = 0; // after one that did not fit
    // The fragments that a cell held to those that its boxes let expect; negative where there was none.
    std::vector<double> Densities;
  };

  std::vector<double> GetCovered(const Rectangle& tile) const;
  Units Guess(const Rectangle& tile, const Unit& unit, std::int64_t allowed) const;
  Units Foresee(const Rectangle& tile, const Unit& unit) const;
  void TakeOver(const Rectangle& tile, Units& counts) const;

  std::map<Rectangle, Tile> Tiles;
  std::vector<Box> Boxes;
  bool Moved = false;
  std::vector<Rectangle> Drawn;         // tiles of this frame
  Rectangle Viewport{ { 0, 0, 0, 0 } }; // of the last frame, if it was drawn in one tile
  std::vector<double> Covered;          // the pixels of each cell of the last tile that boxes cover, all boxes added up
  double FragmentsOfBox = 2;            // as the last tile's unit has it
  Units Ranges;                         // of the last tile:
  std::int64_t Least = 0;               // units for a fragment per pixel
  bool Guessed = false;
  bool Moving = false;
  bool TooLarge = false;
};
VTK_ABI_NAMESPACE_END

#endif
