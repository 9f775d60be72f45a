// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility.glsl: the visibility function of adaptive transparency (Salvi 2011, sections 3.1 and 3.3).
//
// vis(z), the transmittance between the viewer and depth z, is a step function of NODE_COUNT nodes in front-to-back
// order: behind depth z[k] it is t[k]. Before z[0] it is 1: that node is implicit. There is one node more than
// NODE_COUNT, for the fragment that has just come in. A node that is not in use lies at NODE_EMPTY and holds the total
// transmittance.
//
// Needs: NODE_COUNT, NODE_REMOVAL, ALPHA_CORRECTION, TRANSMITTANCE_CHANNELS.  Gives: Visibility, clearVisibility,
// insertFragment, coincide, transmittanceBefore, passNode, with ESTIMATE_ERROR 1 estimateError.
#ifndef Visibility_glsl
#define Visibility_glsl
#include "Adaptive/RemoveNode.glsl"

// Lists are walked from the fragment drawn last, which lies in front of those that it coincides with. INSERTED_AS_DRAWN
// 1: fragments come as they are drawn, and of equal depths the later one is put in front.
#if defined(INSERTED_AS_DRAWN) && INSERTED_AS_DRAWN
#define STAYS_IN_FRONT(z, depth) ((z) < (depth))
#else
#define STAYS_IN_FRONT(z, depth) ((z) <= (depth))
#endif

void clearVisibility(OUT(Visibility) v)
{
#define CLEAR(k) \
  v.z[k] = NODE_EMPTY; \
  v.t[k] = Channels(1.0f);
  EACH_NODE(CLEAR)
  CLEAR(NODE_COUNT)
  v.narrowest = NODE_EMPTY;
#if ESTIMATE_ERROR
  v.lost = 0.0f;
  v.nearest = NODE_EMPTY;
  v.farthest = 0.0f;
#endif
}

// Multiplies vis(z) with the step of a fragment (Eq. 5). Of equal depths, the fragment that comes later is put behind,
// or in front (INSERTED_AS_DRAWN). count fragments were inserted before this one. One that lies behind NODE_EMPTY and
// hides nothing takes no node, and none is removed for it: a rule that keeps the last node would remove another one.
void insertFragment(INOUT(Visibility) v, float depth, Channels alpha, int count)
{
  Channels passes = 1.0f - alpha;
#define INSERT_BEHIND(k) \
  v.t[(k) + 1] = STAYS_IN_FRONT(v.z[(k) + 1], depth) ? v.t[(k) + 1] : passes * v.t[k]; \
  v.z[(k) + 1] = min(v.z[(k) + 1], max(v.z[k], depth));
  EACH_NODE_BACKWARDS(INSERT_BEHIND)
  v.t[0] = STAYS_IN_FRONT(v.z[0], depth) ? v.t[0] : passes;
  v.z[0] = min(v.z[0], depth);
#if ESTIMATE_ERROR
  v.nearest = min(v.nearest, depth);
  v.farthest = depth < NODE_EMPTY ? max(v.farthest, depth) : v.farthest;
#endif
  if (count >= NODE_COUNT && v.z[NODE_COUNT] < NODE_EMPTY)
  {
    removeNode(v);
  }
}

// Whether fragments of equal depth have come in. They are neighbours: then still, or when one of their nodes was
// removed. So an insertion need not look.
bool coincide(Visibility v)
{
  bool found = v.narrowest == 0.0f;
#define FIND_COINCIDENT(k) found = found || (v.z[(k) + 1] < NODE_EMPTY && v.z[k] == v.z[(k) + 1]);
  EACH_NODE(FIND_COINCIDENT)
  return found;
}

#if ESTIMATE_ERROR
// The areas lost, over the distance from the nearest to the farthest fragment: at least the mean of |vis - what it was
// without removals| there (each area was that when its node went, and what came later can only have made it less), 0 if
// nothing was removed, at most 1.
float estimateError(float lost, float nearest, float farthest)
{
  return lost > 0.0f ? min(lost / (farthest - nearest), 1.0f) : 0.0f;
}
#endif

// Moves the first node at this depth just in front of it: a fragment there has asked for its transmittance, and those
// of equal depth that come after it lie behind it. Fragments have to ask in the order in which they were inserted. With
// no more fragments than nodes that is exact; where nodes of that depth were removed, as many fragments hide each other
// as there are nodes left.
void passNode(INOUT(Visibility) v, float depth)
{
  float nearer = depth > 0.0f ? uintBitsToFloat(floatBitsToUint(depth) - 1u) : -1.0f;
  bool passed = false;
  bool first;
#define PASS_NODE(k) \
  first = !passed && v.z[k] == depth; \
  v.z[k] = first ? nearer : v.z[k]; \
  passed = passed || first;
  EACH_NODE(PASS_NODE)
}

// vis at a depth (Eq. 6). Where fragments of equal depth have come in, passNode follows.
Channels transmittanceBefore(INOUT(Visibility) v, float depth)
{
  Channels before = Channels(1.0f);
#define FIND_BEFORE(k) before = v.z[k] < depth ? v.t[k] : before;
  EACH_NODE(FIND_BEFORE)
  return before;
}

#endif
