// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// LinkedList.glsl: one linked list of fragments a pixel, the last drawn first (Yang et al. 2010).
//
// Where fragments of a pixel are drawn in order, nobody else is at the pixel's head. Then a pixel takes a run of
// NODE_RUN nodes at a time, and its next fragments go into the nodes behind: one atomic operation for four fragments,
// which lie side by side when they are read. Every node has its link all the same. A run begins at a multiple of its
// length, so a head tells whether the next node is the pixel's.
//
// Elsewhere every fragment takes a node, and offers it by an exchange.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, FRAGMENT_ORDER, COUNT_ACCESSES, NODE_LINKS.
// Gives: what Shaders/README.md asks of a storage.
#ifndef LinkedList_glsl
#define LinkedList_glsl
#define READS_COUNT 1
#define TABLE_COUNTS 1
#include "Common/Order.glsl"
#include "Storage/CellLayout.glsl"
#if FRAGMENT_ORDER == FRAGMENT_ORDER_DRAWN
#define UNIT_LENGTH NODE_RUN
#else
#define UNIT_LENGTH 1
#endif
#include "Storage/Nodes.glsl"

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
  uint at = headIndex(pixel);
#if MERGES_SAMPLES
  if (mergeIntoNode(heads[at], fragment, depthExtent))
  {
    return;
  }
#endif
  uint counter = counterOf(pixel);
  COUNT_STORE(counter);
#if FRAGMENT_ORDER == FRAGMENT_ORDER_DRAWN
  uint last = heads[at];
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
#else
  uint index = takeUnit(counter);
  if (index < nodeRoom())
  {
    writeNode(index, atomicExchange(heads[at], index + 1u), fragment);
  }
#endif
}

#endif
