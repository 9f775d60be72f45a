// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Retrieve.glsl: one pass over the R-buffer's queues, an invocation a cell, which reads its fragments one after the
// other.
//
// A pass takes the farthest fragment of each pixel out of the queue. The first one read of a pixel is held; where a
// later one is behind it, that one is held, and the one before takes its place in the queue. Depths of those that are
// held are the second depth buffer. Of equal depths the one drawn earlier leaves first. What is held is put before the
// pixel's list when the pixel is next met in a later pass, or at the end: so the list begins with the nearest fragment
// when the queue is empty.
//
// The state of a pixel, three bits, is the pass that its fragment was held in, modulo 8: until none of it is in the
// queue, it is met in every pass. Nothing is shared: a pixel belongs to one cell, a cell to one invocation.
//
// An invocation reads QUEUE_READS fragments, or up to 7 more. A pass over a longer queue takes several drawings: what
// is unread is linked behind what was put back, whose last fragment the cell keeps. So a drawing ends before a driver
// takes it for one that hangs, and where a driver ends a loop after a number of rounds, the next drawing goes on.
//
// Needs: QUEUE_READS, FRAGMENT_ORDER, and what the storage needs.  Gives: main; the fragment is discarded when
// the cell's queue is empty.
#include "Common/Order.glsl"
#include "Storage/Selected.glsl"
#ifndef QUEUE_READS
#error "Storage/Retrieve.glsl needs QUEUE_READS"
#endif

#define NODES_A_ROUND 8

out vec4 fragOutput0;

uint framesBuffered = 0u; // fragments that have left: the paper blends them with the frame buffer then

// Puts what is held of a pixel before its list.
void leaveQueue(uint at)
{
  uint node = secondDepths[at].x & HEAD_MASK;
  if (node != 0u)
  {
    linkNode(node, heads[at]);
    heads[at] = node;
    secondDepths[at].x = 0u;
    ++framesBuffered;
  }
}

void hold(uint at, uint node, float depth, uint state)
{
  secondDepths[at] = uvec2(state << uint(HEAD_BITS) | node, floatBitsToUint(depth));
}

bool isBehind(uint node, Fragment fragment, uint held, float depth)
{
#if FRAGMENT_ORDER == FRAGMENT_ORDER_DRAWN
  PackedColor color = fragment.color;
#else
  uint next;
  PackedColor color = loadNode(held, next).color;
#endif
  return inFront(depth, color, ~held, fragment.depth, fragment.color, ~node);
}

// Puts a node at the end of the part of the queue that has been read, behind last; gives the queue's first one.
uint putBack(uint first, uint last, uint node)
{
  if (last != 0u)
  {
    linkNode(last, node);
  }
  return last == 0u ? node : first;
}

void main()
{
  ivec2 cell = ivec2(gl_FragCoord.xy) - frameTile.xy;
  uint counter = counterOfCell(uvec2(cell));
  uint pass = cells[counter + CELL_PASSES];
  uint end = cells[counter + CELL_NEXT];
  uint queue = cells[counter + CELL_QUEUE];
  uint cursor = queue != 0u || pass > 0u ? queue : cells[counter + CELL_FIRST] + 1u;
  uint first = 0u;
  uint last = cells[counter + CELL_PUT_BACK];
  if (last != 0u)
  {
    first = queue;
    loadNode(last, cursor);
  }
  bool empty = cursor == 0u || cursor > end; // the last one's link leads to where the next one would have been
  uint read = 0u;
  while (cursor != 0u && cursor <= end && read < uint(QUEUE_READS))
  {
    for (int i = 0; i < NODES_A_ROUND; ++i)
    {
      if (cursor != 0u && cursor <= end)
      {
        uint node = cursor;
        Fragment fragment = loadNode(node, cursor);
        uint at = queuePixels[node - 1u];
        uvec2 second = secondDepths[at];
        uint held = second.x & HEAD_MASK;
        bool met = held != 0u && second.x >> uint(HEAD_BITS) == (pass & 7u);
        ++read;
        if (!met)
        {
          leaveQueue(at);
          hold(at, node, fragment.depth, pass & 7u);
        }
        else
        {
          uint nearer = node;
          if (isBehind(node, fragment, held, uintBitsToFloat(second.y)))
          {
            nearer = held;
            hold(at, node, fragment.depth, pass & 7u);
          }
          first = putBack(first, last, nearer);
          last = nearer;
        }
      }
    }
  }
  bool unread = cursor != 0u && cursor <= end;
  first = putBack(first, last, unread ? cursor : 0u);
  if (!empty && first == 0u)
  {
    ivec2 corner = cell << cellShift;
    ivec2 size = min(frameTile.zw - corner, ivec2(1 << cellShift));
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; ++x)
      {
        leaveQueue(uint((corner.y + y) * frameTile.z + corner.x + x));
      }
    }
  }
  addAccesses(counter, CELL_READS, read);
  addAccesses(counter, CELL_SECOND_DEPTH, read);
  addAccesses(counter, CELL_FRAME_BUFFER, framesBuffered);
  cells[counter + CELL_QUEUE] = first;
  cells[counter + CELL_PUT_BACK] = unread ? last : 0u;
  cells[counter + CELL_PASSES] = unread ? pass : pass + 1u;
  if (first == 0u)
  {
    discard;
  }
  fragOutput0 = vec4(0.0);
}
