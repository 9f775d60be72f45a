// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// LinkedListInOrder.glsl: linked lists (Storage/LinkedList.glsl) where the driver keeps the order of drawing.
//
// Nobody else is at the pixel's head. So a pixel takes a run of NODE_RUN nodes at a time, and its next fragments go
// into the nodes behind: one atomic operation for four fragments, which lie side by side when they are read. Every node
// has its link all the same. A run begins at a multiple of its length, so a head tells whether the next node is the
// pixel's.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, FRAGMENT_ORDER, NODE_LINKS.
// Gives: what Shaders/README.md asks of a storage.
#ifndef LinkedListInOrder_glsl
#define LinkedListInOrder_glsl
#define READS_COUNT 1
#define TABLE_COUNTS 1
#include "Common/Order.glsl"
#include "Storage/CellLayout.glsl"
#define UNIT_LENGTH NODE_RUN
#include "Storage/NodesInOrder.glsl"

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
  uint at = headIndex(pixel);
  uint last = heads[at];
#if MERGES_SAMPLES
  if (mergeIntoNode(last, fragment, depthExtent))
  {
    return;
  }
#endif
  uint counter = counterOf(pixel);
  COUNT_STORE(counter);
  uint index = last;
  if (last % uint(UNIT_LENGTH) == 0u)
  {
    index = takeUnit(counter) * uint(UNIT_LENGTH);
  }
  heads[at] = index + 1u; // where there is no room, too: the frame is counted to its end
  if (index < nodeRoom())
  {
    writeNode(index, last, fragment);
  }
}

// As many fragments as are read together: a run of nodes, where none has been moved. Those that are not there are
// empty. Gives the number of those that are.
#if NODE_LINKS < 2
#define READ_GROUP NODE_RUN

uint nextGroup(inout uint cursor, out Fragment group[READ_GROUP])
{
  uint run = cursor == 0u ? 0u : (cursor - 1u) / uint(UNIT_LENGTH) * uint(UNIT_LENGTH);
  uint count = cursor - run;
  uint next = 0u;
  for (int i = 0; i < READ_GROUP; ++i)
  {
    uint place = run + uint(UNIT_LENGTH) - 1u - uint(i);
    Fragment fragment = loadNode(place + 1u, next);
    group[i] = EMPTY_FRAGMENT(BLOCK_EMPTY);
    if (place < cursor)
    {
      group[i] = atSample(fragment);
    }
  }
  cursor = cursor == 0u ? 0u : next; // of the run's first node
  return count;
}
#else
#define READ_GROUP 1
#endif

#endif
