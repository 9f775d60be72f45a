// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SortBlock.glsl: sorts BLOCK_SIZE fragments that are held in registers.
//
// Batcher's odd-even merge sort (Batcher 1968, "Sorting networks and their applications"): its comparisons do not
// depend on the data, so every index is a constant after the macros are expanded. No array is ever indexed at run time,
// which is what keeps it in registers on a GPU and in SIMD lanes on a CPU. 8, 16 and 32 elements take 19, 63 and 191
// comparisons. Elements beyond the last fragment have the depth BLOCK_EMPTY and so stay behind.
//
// A network does not keep the order of equals. EQUAL_DEPTHS 1 decides between them (Order.glsl), which takes twice the
// steps; EQUAL_DEPTHS 0 does not, and hasEqualDepths tells afterwards whether it would have been needed.
//
// The networks are most of what compilers have to do for a first frame. So a comparison is one `if` around all that it
// exchanges: compilers make the same selections of it as of a `?:` for each value, and Mesa's takes half as long. And
// what nobody looks at afterwards need not be exchanged, SORTS_COLORS 0 or SORTS_CARRIED 0: compilers find that out,
// too, but late.
//
// Needs: BLOCK_SIZE (8, 16 or 32), EQUAL_DEPTHS, FRAGMENT_ORDER, TRANSMITTANCE_CHANNELS.  Gives: Block, emptyBlock,
// sortBlock, hasEqualDepths.
#ifndef SortBlock_glsl
#define SortBlock_glsl
#include "Common/Channels.glsl"
#include "Common/Language.glsl"
#include "Common/Order.glsl"
#ifndef BLOCK_SIZE
#error "SortBlock.glsl needs BLOCK_SIZE"
#endif
#ifndef EQUAL_DEPTHS
#error "SortBlock.glsl needs EQUAL_DEPTHS"
#endif

struct Block
{
  float depth[BLOCK_SIZE];
  PackedColor color[BLOCK_SIZE];
  uint age[BLOCK_SIZE];
  uint carried[BLOCK_SIZE]; // goes where its fragment goes: where that lies in the storage, or its coverage
};

void emptyBlock(OUT(Block) block)
{
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    block.depth[i] = BLOCK_EMPTY;
    block.color[i] = PackedColor(0u);
    block.age[i] = uint(i);
    block.carried[i] = 0u;
  }
}

#ifndef SORTS_COLORS
#define SORTS_COLORS 1
#endif
#ifndef SORTS_CARRIED
#define SORTS_CARRIED 1
#endif

#define EXCHANGE(type, array) \
  { \
    type a = block.array[I]; \
    block.array[I] = block.array[J]; \
    block.array[J] = a; \
  }
#if SORTS_COLORS
#define EXCHANGE_COLOR EXCHANGE(PackedColor, color)
#else
#define EXCHANGE_COLOR
#endif
#if SORTS_CARRIED
#define EXCHANGE_CARRIED EXCHANGE(uint, carried)
#else
#define EXCHANGE_CARRIED
#endif
#if EQUAL_DEPTHS
#define EXCHANGE_AGE EXCHANGE(uint, age)
#define IN_FRONT(j, i) \
  inFront(block.depth[j], block.color[j], block.age[j], block.depth[i], block.color[i], block.age[i])
#else
#define EXCHANGE_AGE
#define IN_FRONT(j, i) block.depth[j] < block.depth[i]
#endif

#define COMPARE(i, j) \
  { \
    const int I = i; \
    const int J = j; \
    if (IN_FRONT(J, I)) \
    { \
      EXCHANGE(float, depth) \
      EXCHANGE_COLOR \
      EXCHANGE_AGE \
      EXCHANGE_CARRIED \
    } \
  }

// MERGE_n(i, s): merges the two sorted halves of the n elements i, i + s, i + 2s, ...
#define MERGE_2(i, s) COMPARE((i), (i) + (s))
#define MERGE_4(i, s) \
  MERGE_2((i), 2 * (s)) MERGE_2((i) + (s), 2 * (s)) COMPARE((i) + (s), (i) + 2 * (s))
#define MERGE_8(i, s) \
  MERGE_4((i), 2 * (s)) \
  MERGE_4((i) + (s), 2 * (s)) \
  COMPARE((i) + (s), (i) + 2 * (s)) \
  COMPARE((i) + 3 * (s), (i) + 4 * (s)) COMPARE((i) + 5 * (s), (i) + 6 * (s))
#define MERGE_16(i, s) \
  MERGE_8((i), 2 * (s)) \
  MERGE_8((i) + (s), 2 * (s)) \
  COMPARE((i) + (s), (i) + 2 * (s)) \
  COMPARE((i) + 3 * (s), (i) + 4 * (s)) \
  COMPARE((i) + 5 * (s), (i) + 6 * (s)) \
  COMPARE((i) + 7 * (s), (i) + 8 * (s)) \
  COMPARE((i) + 9 * (s), (i) + 10 * (s)) \
  COMPARE((i) + 11 * (s), (i) + 12 * (s)) COMPARE((i) + 13 * (s), (i) + 14 * (s))

#define SORT_2(i) MERGE_2(i, 1)
#define SORT_4(i) SORT_2(i) SORT_2((i) + 2) MERGE_4(i, 1)
#define SORT_8(i) SORT_4(i) SORT_4((i) + 4) MERGE_8(i, 1)
#define SORT_16(i) SORT_8(i) SORT_8((i) + 8) MERGE_16(i, 1)

void sortBlock(INOUT(Block) block)
{
#if BLOCK_SIZE == 8
  SORT_8(0)
#elif BLOCK_SIZE == 16
  SORT_16(0)
#else
  // Two sorted halves of 16, merged: the even elements, the odd ones, and then neighbours.
  SORT_16(0)
  SORT_16(16)
  MERGE_16(0, 2)
  MERGE_16(1, 2)
  COMPARE(1, 2) COMPARE(3, 4) COMPARE(5, 6) COMPARE(7, 8) COMPARE(9, 10)
  COMPARE(11, 12) COMPARE(13, 14) COMPARE(15, 16) COMPARE(17, 18) COMPARE(19, 20)
  COMPARE(21, 22) COMPARE(23, 24) COMPARE(25, 26) COMPARE(27, 28) COMPARE(29, 30)
#endif
}

// Whether a sorted block holds fragments of equal depth.
bool hasEqualDepths(INOUT(Block) block)
{
  bool equal = false;
  for (int i = 1; i < BLOCK_SIZE; ++i)
  {
    equal = equal || (block.depth[i] == block.depth[i - 1] && block.depth[i] < BLOCK_EMPTY);
  }
  return equal;
}

#endif
