// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// RBufferInOrder.glsl: the R-buffer (Storage/RBuffer.glsl) where the driver keeps the order of drawing: a fragment may
// join the one before it in its pixel.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, NODE_LINKS.
// Gives: what Shaders/README.md asks of a storage.
#ifndef RBufferInOrder_glsl
#define RBufferInOrder_glsl
#define READS_COUNT 0 // of its lists: Storage/Retrieve.glsl has counted
#define TABLE_COUNTS 0
#define READ_GROUP 1
#define UNIT_LENGTH 1
#include "Storage/NodesInOrder.glsl"
#include "Storage/Queue.glsl"

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
#if MERGES_SAMPLES
  uint at = headIndex(pixel);
  uint last = heads[at]; // until lists are made, a pixel's entry is the one drawn last
  if (mergeIntoNode(last, fragment, depthExtent))
  {
    return;
  }
  uint node = queueFragment(pixel, fragment);
  if (node != 0u)
  {
    heads[at] = node;
  }
#else
  queueFragment(pixel, fragment);
#endif
}

#endif
