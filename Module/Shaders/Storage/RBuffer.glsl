// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// RBuffer.glsl: a first-in first-out buffer of fragments with their pixel: the R-buffer.
//
// Each cell of pixels has a buffer of its own, the range of nodes that it takes from: fragments of one pixel lie in it
// in the order of drawing, those of others between them. Reading them takes passes over all of it,
// Storage/Retrieve.glsl, which makes a list of each pixel in the end.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, FRAGMENT_ORDER, COUNT_ACCESSES, NODE_LINKS.
// Gives: what Shaders/README.md asks of a storage, queuePixels, secondDepths.
#ifndef RBuffer_glsl
#define RBuffer_glsl
#define READS_COUNT 0 // of its lists: Storage/Retrieve.glsl has counted
#define TABLE_COUNTS 0
#define UNIT_LENGTH 1
#include "Storage/Nodes.glsl"

layout(std430, binding = STORAGE_BINDING_NEXT) buffer QueuePixels
{
  uint queuePixels[]; // of each node, as heads count them
};

layout(std430, binding = STORAGE_BINDING_LINKS) buffer SecondDepths
{
  uvec2 secondDepths[]; // of each pixel: the node that is taken out of the queue, below its state, and its depth
};

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
  uint at = headIndex(pixel);
#if MERGES_SAMPLES
  uint last = heads[at]; // until lists are made the one drawn last
  if (mergeIntoNode(last, fragment, depthExtent))
  {
    return;
  }
#endif
  uint counter = counterOf(pixel);
  uint index = takeUnit(counter);
  COUNT_STORE(counter);
  if (index < cellUnits)
  {
    writeNode(index, index + 2u, fragment); // the next one of the queue, if there will be one
    queuePixels[index] = at;
#if MERGES_SAMPLES
    heads[at] = index + 1u;
#endif
  }
}

#endif
