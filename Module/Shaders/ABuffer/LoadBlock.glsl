// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ABuffer/LoadBlock.glsl: a pixel's list, as far as it fits, into the registers in which it is sorted.
//
// Needs: what the storage and Common/SortBlock.glsl need.  Gives: loadBlock, Block.
#ifndef LoadBlock_glsl
#define LoadBlock_glsl
#include "Common/Fragment.glsl"
#if SAMPLES == 1 // where all fragments cover the same
#define SORTS_CARRIED 0
#endif
#include "Common/SortBlock.glsl"
#include "Storage/Selected.glsl"

// count is the number of fragments in the block, which carries their coverage along; unread is 0 if they are all that
// the pixel has.
void loadBlock(ivec2 pixel, out Block block, out uint count, out uint unread)
{
  emptyBlock(block);
  count = 0u;
  unread = firstFragment(pixel);
#if READ_GROUP > 1
  for (int i = 0; i < BLOCK_SIZE; i += READ_GROUP)
  {
    Fragment group[READ_GROUP];
    count += nextGroup(unread, group);
    for (int j = 0; j < READ_GROUP; ++j)
    {
      block.depth[i + j] = group[j].depth;
      block.color[i + j] = group[j].color;
      block.carried[i + j] = group[j].coverage;
    }
  }
#else
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    Fragment fragment;
    if (nextFragment(unread, fragment))
    {
      block.depth[i] = fragment.depth;
      block.color[i] = fragment.color;
      block.carried[i] = fragment.coverage;
      ++count;
    }
  }
#endif
}

#endif
