// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Cells.glsl: what all storages share: units (a node, a section) that a cell of pixels takes from a range of its own.
//
// vtkCellStorage.h says why. A cell's counter begins at the range's first unit. Counting goes on when the range is used
// up, into the next cell's units or past the last one, so that the application knows what was needed: it then draws
// again.
//
// Writes need no memory barrier among each other: each unit is written by those invocations only that were given a
// place in it, and only the atomic operations meet. The barrier between writing and reading is the application's.
//
// A shader that changes no fragments says so by FRAGMENTS_READ_ONLY 1, and a storage then fetches them as texels of its
// buffer: by a path with caches of its own on a GPU, and on the software rasterizer for all lanes of a vector at once,
// where reading a buffer is a loop over the lanes that checks each word.
//
// A shader that stores is given COUNT_ACCESSES 1 where what it stores is to be counted, and one that counts what it
// reads defines it itself, before it includes this. All others are the same programs, whatever is counted.
//
// Needs: UNIT_LENGTH (fragments that a unit has room for).
// Gives: what CellGrid.glsl gives, takeUnit, takePlace, addAccesses; COUNT_STORE, COUNT_READ, COUNT_TABLE, and where
// accesses are counted readAccesses, tableAccesses.
#ifndef Cells_glsl
#define Cells_glsl
#ifndef COUNT_ACCESSES
#define COUNT_ACCESSES 0
#endif
#ifndef UNIT_LENGTH
#error "Storage/Cells.glsl needs UNIT_LENGTH"
#endif
#ifndef FRAGMENTS_READ_ONLY
#define FRAGMENTS_READ_ONLY 0
#endif
#include "Common/Bindings.glsl"
#include "Storage/CellGrid.glsl"

layout(std430, binding = STORAGE_BINDING_COUNTERS) buffer StorageCounters
{
  uint cells[]; // CELL_WORDS each
};

uint takeUnit(uint counter)
{
  return atomicAdd(cells[counter + CELL_NEXT], 1u);
}

// A place for a fragment of a volume, from the end of the cell's range on, one by one.
#define NO_PLACE 0xffffffffu
uint takePlace(uint counter)
{
  uint taken = atomicAdd(cells[counter + CELL_INSERTED], 1u);
  bool fits = taken < (cells[counter + CELL_END] - cells[counter + CELL_NEXT]) * uint(UNIT_LENGTH);
  return fits ? cells[counter + CELL_END] * uint(UNIT_LENGTH) - 1u - taken : NO_PLACE;
}

void addAccesses(uint counter, uint kind, uint count)
{
  uint before = atomicAdd(cells[counter + kind], count);
  if (before + count < before)
  {
    atomicAdd(cells[counter + kind + 1u], 1u);
  }
}

#if COUNT_ACCESSES
// Of an invocation that reads lists. The storage says which of them count: READS_COUNT, TABLE_COUNTS.
uint readAccesses = 0u;
uint tableAccesses = 0u;

#define COUNT_STORE(counter) atomicAdd(cells[(counter) + CELL_STORES], 1u)
#define COUNT_READ() readAccesses += uint(READS_COUNT)
// As in the paper, where empty entries cost nothing.
#define COUNT_TABLE(entry) tableAccesses += (entry) != 0u ? uint(TABLE_COUNTS) : 0u
#else
#define COUNT_STORE(counter)
#define COUNT_READ()
#define COUNT_TABLE(entry)
#endif

#endif
