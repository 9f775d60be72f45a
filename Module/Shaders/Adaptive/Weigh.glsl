// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/Weigh.glsl: the visibility that a fragment is weighted with.
//
// A fragment that has a node of its own is seen through what lies before that node. One whose node was removed is
// somewhere among others of which no order is left: its step, and theirs, went to the node k in front of them
// (NODE_REMOVAL_UNDERESTIMATE), so that t[k] is what all of them let through, and t[k - 1] what is let through before
// any of them. In the middle of n fragments of one opacity it is the geometric mean of both, whatever n: sqrt(t[k - 1]
// * t[k]) A fragment does not hide itself, so it is no less than t[k] / (1 - opacity), which is right for the last of
// them, and so for one alone.
//
// What is behind something opaque stays hidden, and nothing is seen better than what has a node in front of it.
//
// Only where nodes were removed, and with ALPHA_CORRECTION 1; else, and with the other rules, which move steps to the
// farther node, too, it is Eq. 6.
//
// Valid C++, too.
//
// Needs: ALPHA_CORRECTION, and what Visibility.glsl needs.  Gives: WEIGHS_BY_MEANS, visibilityBetween, visibilityAt;
// Visibility.glsl.
#ifndef AdaptiveWeigh_glsl
#define AdaptiveWeigh_glsl
#include "Adaptive/Visibility.glsl"
#ifndef ALPHA_CORRECTION
#error "Adaptive/Weigh.glsl needs ALPHA_CORRECTION"
#endif

#define WEIGHS_BY_MEANS (ALPHA_CORRECTION == 1 && NODE_REMOVAL == NODE_REMOVAL_UNDERESTIMATE)

// Of a fragment without a node, from the transmittances before and behind the node in front of it.
Channels visibilityBetween(Channels before, Channels behind, Channels opacity)
{
  Channels withoutItself = behind / max(1.0f - opacity, Channels(1e-6f));
  return min(max(sqrt(before * behind), withoutItself), before);
}

// removed: whether nodes were. Where fragments of equal depth have come in, passNode follows.
Channels visibilityAt(INOUT(Visibility) v, float depth, Channels opacity, bool removed)
{
  Channels behind = transmittanceBefore(v, depth);
  // Of the node in front; no more than behind it, if nodes at this depth are the fragment's own and those that coincide
  // with it.
  Channels before = Channels(1.0f);
#define FIND_BEFORE_NODE(k) before = v.z[(k) + 1] <= depth ? v.t[k] : before;
  EACH_NODE(FIND_BEFORE_NODE)
  return WEIGHS_BY_MEANS && removed ? visibilityBetween(max(before, behind), behind, opacity) : behind;
}

#endif
