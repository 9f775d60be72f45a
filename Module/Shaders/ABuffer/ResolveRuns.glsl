// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ABuffer/ResolveRuns.glsl: pixels of up to RUNS * 32 fragments.
//
// The list becomes sorted runs of 32, whose first fragments are then compared: the nearest of them is blended, and the
// next of its run takes its place. Longer lists are left to LONGER_LEVEL.
//
// Needs: LONGER_LEVEL, COLOR_FORMAT, FRAGMENT_ORDER.
#ifndef LONGER_LEVEL
#error "ABuffer/ResolveRuns.glsl needs LONGER_LEVEL"
#endif
#include "ABuffer/Blend.glsl"
#include "Common/Fragment.glsl"
#include "Common/FinishPixel.glsl"
#include "Common/Statistics.glsl"
#include "Storage/SortList.glsl"

#define RUNS 8

struct Runs
{
  Fragment head[RUNS];
  uint rest[RUNS]; // the cursor behind the head
  uint left[RUNS]; // fragments behind the head
};

// Puts the fragment that follows in a run in front of it, or an empty one behind all others.
void advanceRun(inout Runs runs, int nearest)
{
  uint rest = 0u;
  uint left = 0u;
  for (int k = 0; k < RUNS; ++k)
  {
    rest = k == nearest ? runs.rest[k] : rest;
    left = k == nearest ? runs.left[k] : left;
  }
  Fragment next = EMPTY_FRAGMENT(BLOCK_EMPTY);
  if (left > 0u)
  {
    next = atSample(loadLinked(rest, rest));
    --left;
  }
  for (int k = 0; k < RUNS; ++k)
  {
    runs.head[k].depth = k == nearest ? next.depth : runs.head[k].depth;
    runs.head[k].color = k == nearest ? next.color : runs.head[k].color;
    runs.rest[k] = k == nearest ? rest : runs.rest[k];
    runs.left[k] = k == nearest ? left : runs.left[k];
  }
}

int nearestRun(Runs runs)
{
  int nearest = 0;
  Fragment head = runs.head[0];
  for (int k = 1; k < RUNS; ++k)
  {
    bool nearer = inFront(runs.head[k].depth, runs.head[k].color, uint(k), head.depth,
      head.color, uint(nearest));
    nearest = nearer ? k : nearest;
    head.depth = nearer ? runs.head[k].depth : head.depth;
    head.color = nearer ? runs.head[k].color : head.color;
  }
  return nearest;
}

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  Runs runs;
  for (int k = 0; k < RUNS; ++k)
  {
    runs.head[k] = EMPTY_FRAGMENT(BLOCK_EMPTY);
    runs.rest[k] = 0u;
    runs.left[k] = 0u;
  }
  uint count = 0u;
  int used = 0;
  SortedList list = startList(pixel);
  while (list.rest != 0u && used < RUNS)
  {
    uint length;
    uint first = appendSortedRun(list, length);
    count += length;
    for (int k = 0; k < RUNS; ++k)
    {
      runs.rest[k] = k == used ? first : runs.rest[k];
      runs.left[k] = k == used ? length : runs.left[k];
    }
    ++used;
  }
  endList(list, pixel);
  if (list.rest != 0u)
  {
    leaveToLevel(pixel, LONGER_LEVEL);
    return false;
  }
  for (int k = 0; k < RUNS; ++k)
  {
    advanceRun(runs, k);
  }
  uint blended = 0u;
  while (blended < count)
  {
    int nearest = nearestRun(runs);
    PackedColor words = PackedColor(0u);
    for (int k = 0; k < RUNS; ++k)
    {
      words = k == nearest ? runs.head[k].color : words;
    }
    blendBehind(color, transmittance, words);
    advanceRun(runs, nearest);
    ++blended;
  }
  finishPixel(pixel, count);
  return count > 0u;
}

#include "Common/Resolve.glsl"
