// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CellLayout.glsl: the numbers of how storages allocate by cells of pixels, shared by the shaders and vtkCellStorage.
#ifndef CellLayout_glsl
#define CellLayout_glsl

#define SMALLEST_CELL_SHIFT 4 // cells of 16 x 16 pixels, or larger where there would be more than
#define MOST_CELLS 8192

// The words of a cell. Each cell has a cache line of its own.
#define CELL_WORDS 16u
#define CELL_NEXT 0u      // the unit that is given out next
#define CELL_FIRST 1u     // the first unit of the cell's range
#define CELL_END 2u       // the first one behind it
// Fragments that were drawn: counted by shaders or filled in by the application, vtkCellStorage::CountFragments.
#define CELL_FRAGMENTS 3u
#define CELL_PIXELS 4u    // M-buffer: pixels that hold any
#define CELL_INSERTED 5u  // fragments of volumes, which are stored from the range's end
#define CELL_PUT_BACK 5u  // R-buffer, before that: in the middle of a pass the fragment that was put back last, or 0
#define CELL_QUEUE 6u     // R-buffer: the fragment that is read first in the next pass
#define CELL_PASSES 7u    // R-buffer: passes so far
// Accesses, where they are counted. Those that may be many take two words.
#define CELL_STORES 8u
#define CELL_TABLE 9u
#define CELL_READS 10u
#define CELL_SECOND_DEPTH 12u
#define CELL_FRAME_BUFFER 14u

#define HEAD_BITS 29 // of a fragment's number in a pixel's entry; those above it count the samples that are resolved
#define HEAD_MASK 0x1fffffffu
#define LINK_BITS 24u // of the distance to the next fragment, where the coverage lies beside it
#define LINK_MASK 0xffffffu
#define MOST_FRAGMENTS_OF_CELL 7456540 // with the eighth more that is given to a cell, they are not farther apart

#define NODE_RUN 4         // nodes that a pixel takes at a time in order, see LinkedListInOrder.glsl
#define MOST_TEXEL_WORDS 4 // nodes of more words are not fetched as texels

#endif
