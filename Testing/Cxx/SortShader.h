// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Module/Shaders/Common/SortBlock.glsl, compiled as C++, once for each size of a block, number of channels and order
 * among fragments of equal depth.
 */
#ifndef SortShader_h
#define SortShader_h

#include <cstdint>
#include <string>
#include <vector>

struct SortedFragment
{
  float Depth;
  std::uint32_t Color[3]; // the third word with three channels only
  std::uint32_t Node;     // where the fragment was before sorting, from 1
};

struct SortVariant
{
  int BlockSize;
  int Channels;
  std::string Order; // among equals: "Drawn", "Content" or "None"

  /// Sorts up to BlockSize fragments; gives back the block's elements in use, in their order, and whether two of them
  /// are at one depth.
  std::vector<SortedFragment> (*Sort)(const std::vector<SortedFragment>& fragments, bool& equalDepths);
};

/// All that were compiled.
const std::vector<SortVariant>& SortVariants();

#endif
