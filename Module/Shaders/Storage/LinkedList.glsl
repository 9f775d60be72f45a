// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// LinkedList.glsl: one linked list of fragments per pixel, the last drawn first (Yang et al. 2010). Every fragment
// takes a node, and offers it by an exchange.
//
// Where a driver keeps the order of drawing, LinkedListInOrder.glsl is used instead.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, FRAGMENT_ORDER, NODE_LINKS.
// Gives: what Shaders/README.md asks of a storage.
#ifndef LinkedList_glsl
#define LinkedList_glsl
#define READS_COUNT 1
#define TABLE_COUNTS 1
#define UNIT_LENGTH 1
#define READ_GROUP 1
#include "Storage/Nodes.glsl"

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
  uint counter = counterOf(pixel);
  COUNT_STORE(counter);
  uint index = takeUnit(counter);
  if (index < nodeRoom())
  {
    writeNode(index, atomicExchange(heads[headIndex(pixel)], index + 1u), fragment);
  }
}

#endif
