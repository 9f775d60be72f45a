// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SortList.glsl: puts a pixel's list into front-to-back order by changing its links, in n log n steps.
//
// Runs of 32 nodes are sorted in registers; then, pass after pass, pairs of runs are merged (the bottom-up merge sort
// of linked lists). A run that was nearer the head keeps precedence among equals, which keeps the order of drawing.
// Each list belongs to one invocation: nothing is shared. Loops take several nodes a round: drivers may limit the
// rounds of a loop.
//
// A storage whose fragments have no links gets them for this (vtkFragmentStorage::ReserveLinks).
//
// Needs: what the storage needs, FRAGMENT_ORDER.  Gives: sortRuns, mergeRuns, and for lists that a resolve merges
// itself: SortedList, startList, appendSortedRun, endList.
#ifndef SortList_glsl
#define SortList_glsl
#define BLOCK_SIZE 32
#define EQUAL_DEPTHS 1
#include "Common/Order.glsl"
#if FRAGMENT_ORDER == FRAGMENT_ORDER_DRAWN // colours decide nothing, and are not read
#define SORTS_COLORS 0
#endif
#include "Common/SortBlock.glsl"
#include "Storage/Selected.glsl"

#define NODES_A_ROUND 8

// A list that is being put into order from its head on.
struct SortedList
{
  uint first; // what is in order,
  uint last;
  uint rest;  // and what is not yet
};

SortedList startList(ivec2 pixel)
{
  return SortedList(0u, 0u, firstFragment(pixel));
}

// Puts what is in order before the rest.
void endList(SortedList list, ivec2 pixel)
{
  if (list.last != 0u)
  {
    linkNode(list.last, list.rest);
    setFirstFragment(pixel, list.first);
  }
}

void appendNode(inout SortedList list, uint node)
{
  node = linkedNode(node);
  if (list.last != 0u)
  {
    linkNode(list.last, node);
  }
  list.first = list.last == 0u ? node : list.first;
  list.last = node;
}

// Takes up to 32 nodes from the rest and appends them, sorted. Gives the first of them, and how many they are.
uint appendSortedRun(inout SortedList list, out uint length)
{
  Block block;
  emptyBlock(block);
  length = 0u;
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    if (list.rest != 0u)
    {
      block.carried[i] = list.rest;
      Fragment fragment = loadNode(list.rest, list.rest);
      block.depth[i] = fragment.depth;
      block.color[i] = fragment.color;
      ++length;
    }
  }
  sortBlock(block);
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    if (block.carried[i] != 0u)
    {
      appendNode(list, block.carried[i]);
    }
  }
  return linkedNode(block.carried[0]);
}

// Sorts the list in runs of 32. Gives the number of fragments; unread is 0 unless the driver has ended the loop.
uint sortRuns(ivec2 pixel, out uint unread)
{
  SortedList list = startList(pixel);
  uint count = 0u;
  while (list.rest != 0u)
  {
    uint length;
    appendSortedRun(list, length);
    count += length;
  }
  unread = list.rest;
  endList(list, pixel);
  return count;
}

// Merges runs of runLength in pairs. Gives 0 unless the driver has ended a loop.
uint mergeRuns(ivec2 pixel, uint runLength)
{
  SortedList list = startList(pixel);
  while (list.rest != 0u)
  {
    uint a = list.rest;
    uint b = a;
    uint leftA = 0u;
    while (b != 0u && leftA < runLength)
    {
      for (int i = 0; i < NODES_A_ROUND; ++i) // runLength is a multiple of it
      {
        if (b != 0u)
        {
          loadLinked(b, b);
          ++leftA;
        }
      }
    }
    uint leftB = b == 0u ? 0u : runLength;
    uint nextA;
    uint nextB = 0u;
    Fragment headA = loadLinked(a, nextA);
    Fragment headB = headA;
    if (leftB > 0u)
    {
      headB = loadLinked(b, nextB);
    }
    while (leftA > 0u || leftB > 0u)
    {
      for (int i = 0; i < NODES_A_ROUND; ++i)
      {
        if (leftA > 0u || leftB > 0u)
        {
          bool takeB = leftA == 0u ||
            (leftB > 0u && inFront(headB.depth, headB.color, 1u, headA.depth, headA.color, 0u));
          appendNode(list, takeB ? b : a);
          uint node = takeB ? nextB : nextA;
          uint left = (takeB ? leftB : leftA) - 1u;
          left = node == 0u ? 0u : left;
          uint next = 0u;
          Fragment head = EMPTY_FRAGMENT(BLOCK_EMPTY);
          if (left > 0u)
          {
            head = loadLinked(node, next);
          }
          a = takeB ? a : node;
          b = takeB ? node : b;
          leftA = takeB ? leftA : left;
          leftB = takeB ? left : leftB;
          nextA = takeB ? nextA : next;
          nextB = takeB ? next : nextB;
          headA.depth = takeB ? headA.depth : head.depth;
          headA.color = takeB ? headA.color : head.color;
          headB.depth = takeB ? head.depth : headB.depth;
          headB.color = takeB ? head.color : headB.color;
        }
      }
    }
    list.rest = b;
  }
  uint unread = list.rest;
  endList(list, pixel);
  return unread;
}

#endif
