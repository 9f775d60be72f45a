// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyResolveStatistics
 *
 * What shaders count on the GPU and leave to later ones (Shaders/Common/Statistics.glsl): a few words of the whole
 * frame and of the tile, and one for each square of pixels of the tile.
 */
#ifndef vtkTranslucencyResolveStatistics_h
#define vtkTranslucencyResolveStatistics_h

#include "vtkFragmentStorage.h"
#include "vtkTranslucencyBuffer.h"
#include "vtkTranslucencyTiles.h"

#include <optional>

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyResolveStatistics
{
public:
  using Rectangle = vtkTranslucencyTiles::Rectangle;

  /// Squares that have so many pixels of a row or column.
  static int GetSquares(int pixels);

  /// Nothing is counted yet.
  void BeginFrame();

  /// Binds the block for a shader that counts in a part of this viewport. False if there is no memory for it.
  bool Use(const Rectangle& viewport);

  /// Nothing of a tile has been added up yet. Of blocks in use.
  void BeginSum();

  /// Nothing of the tile is left to any level yet. Of blocks in use.
  void BeginTile(const Rectangle& tile);

  /// A shader has counted: what was read before holds no longer.
  void Change() { this->Read.reset(); }

  /// Whether pixels of the tile were left to a level; the most fragments that a pixel of the frame has; whether a pixel
  /// was not finished. Each waits for the shaders so far.
  bool IsLeftTo(int level) { return (this->GetWords().LeftLevels >> level) & 1u; }
  vtkTypeInt64 GetDeepestPixel() { return this->GetWords().DeepestPixel; }
  bool IsUnfinished() { return this->GetWords().Unfinished != 0; }

  /// What the tile's storage holds, after Storage/SumCells.glsl was run. Waits, too.
  vtkFragmentStorage::Sum GetSum();

  vtkTranslucencyBuffer& GetBlock() { return this->Block; }

  vtkTypeInt64 GetBytes() const { return this->Block.GetBytes() + this->Copy.GetBytes(); }
  void Release(bool contextAlive);

private:
  // As the shaders have them.
  struct Words
  {
    unsigned int DeepestPixel;
    unsigned int Unfinished;
    unsigned int Overflowed;
    unsigned int Fragments;
    unsigned int Units;
    unsigned int FullestCell;
    unsigned int LeftLevels;
    unsigned int Unused;
  };
  const Words& GetWords();

  vtkTranslucencyBuffer Block;
  vtkTranslucencyBuffer Copy; // of the words, to be read
  std::optional<Words> Read;
  bool InUse = false; // by a shader of this frame
};
VTK_ABI_NAMESPACE_END

#endif
