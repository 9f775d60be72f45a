// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Queue.glsl: the queues of fragments of the R-buffer, one for each cell of pixels: the range of nodes that the cell
// takes from. Fragments of one pixel lie in it in the order of drawing, those of others between them.
//
// Needs: Storage/Nodes.glsl or Storage/NodesInOrder.glsl before it.  Gives: queuePixels, secondDepths, queueFragment.
#ifndef Queue_glsl
#define Queue_glsl
layout(std430, binding = STORAGE_BINDING_NEXT) buffer QueuePixels
{
  uint queuePixels[]; // of each node, as heads count them
};

layout(std430, binding = STORAGE_BINDING_LINKS) buffer SecondDepths
{
  uvec2 secondDepths[]; // of each pixel: the node that is taken out of the queue, below its state, and its depth
};

// Gives the fragment's node; 0 if there is no room for it.
uint queueFragment(ivec2 pixel, Fragment fragment)
{
  uint counter = counterOf(pixel);
  uint index = takeUnit(counter);
  COUNT_STORE(counter);
  if (index >= cellUnits)
  {
    return 0u;
  }
  writeNode(index, index + 2u, fragment); // the next one of the queue, if there will be one
  queuePixels[index] = headIndex(pixel);
  return index + 1u;
}

#endif
