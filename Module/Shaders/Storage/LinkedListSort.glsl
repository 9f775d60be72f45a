// LinkedListSort.glsl: puts a pixel's list into front-to-back order by changing its links, in n log n steps.
//
// Runs of 32 nodes are sorted in registers; then, pass after pass, pairs of runs are merged (the bottom-up merge sort of linked
// lists). A run that was nearer the head keeps precedence among equals, which keeps the order of drawing. Each list belongs to
// one invocation: nothing is shared. Loops take several nodes a round: drivers may limit the rounds of a loop.
//
// Needs: COLOR_FORMAT, FRAGMENT_ORDER.  Gives: sortRuns, mergeRuns.
#ifndef LinkedListSort_glsl
#define LinkedListSort_glsl
#define BLOCK_SIZE 32
#include "Common/SortBlock.glsl"
#include "Storage/LinkedList.glsl"

#define NODES_A_ROUND 8

// The list that is being written.
struct SortedList
{
  uint first;
  uint last;
};

void appendNode(inout SortedList list, uint node)
{
  if (list.last == 0u)
  {
    list.first = node;
  }
  else
  {
    linkNode(list.last, node);
  }
  list.last = node;
}

// Takes up to 32 nodes from the list at cursor, sorted, and gives their number.
uint appendSortedRun(inout SortedList list, inout uint cursor)
{
  Block block;
  emptyBlock(block);
  uint count = 0u;
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    if (cursor != 0u)
    {
      block.node[i] = cursor;
      Fragment fragment = loadNode(cursor, cursor);
      block.depth[i] = fragment.depth;
      block.color[i] = fragment.color;
      ++count;
    }
  }
  sortBlock(block);
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    if (block.node[i] != 0u)
    {
      appendNode(list, block.node[i]);
    }
  }
  return count;
}

// Sorts the list in runs of 32. Gives the number of fragments; cursor is 0 unless the driver has ended the loop.
uint sortRuns(ivec2 pixel, out uint cursor)
{
  SortedList list = SortedList(0u, 0u);
  uint count = 0u;
  cursor = firstFragment(pixel);
  while (cursor != 0u)
  {
    count += appendSortedRun(list, cursor);
  }
  if (count > 0u)
  {
    linkNode(list.last, 0u);
    setFirstFragment(pixel, list.first);
  }
  return count;
}

// Merges runs of runLength in pairs. Gives 0 unless the driver has ended a loop.
uint mergeRuns(ivec2 pixel, uint runLength)
{
  SortedList list = SortedList(0u, 0u);
  uint a = firstFragment(pixel);
  while (a != 0u)
  {
    uint b = a;
    uint leftA = 0u;
    while (b != 0u && leftA < runLength)
    {
      for (int i = 0; i < NODES_A_ROUND; ++i) // runLength is a multiple of it
      {
        if (b != 0u)
        {
          loadNode(b, b);
          ++leftA;
        }
      }
    }
    uint leftB = b == 0u ? 0u : runLength;
    uint nextA;
    uint nextB = 0u;
    Fragment headA = loadNode(a, nextA);
    Fragment headB = headA;
    if (leftB > 0u)
    {
      headB = loadNode(b, nextB);
    }
    while (leftA > 0u || leftB > 0u)
    {
      for (int i = 0; i < NODES_A_ROUND; ++i)
      {
        bool takeB = leftA == 0u ||
          (leftB > 0u &&
            inFront(headB.depth, headB.color, 1u, headA.depth, headA.color, 0u));
        if (takeB && leftB > 0u)
        {
          appendNode(list, b);
          b = nextB;
          leftB = b == 0u ? 0u : leftB - 1u;
          if (leftB > 0u)
          {
            headB = loadNode(b, nextB);
          }
        }
        else if (leftA > 0u)
        {
          appendNode(list, a);
          a = nextA;
          --leftA;
          if (leftA > 0u)
          {
            headA = loadNode(a, nextA);
          }
        }
      }
    }
    a = b;
  }
  if (list.last != 0u)
  {
    linkNode(list.last, 0u);
    setFirstFragment(pixel, list.first);
  }
  return a;
}

#endif
