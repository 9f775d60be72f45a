// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// RemoveNode.glsl: makes room in a full visibility function (Salvi 2011, section 3.2).
//
// Dropping node j loses the area of a rectangle under the step function (Eq. 7): its height is the step t[j-1] - t[j],
// its width the distance over which the step moves.
// - NODE_REMOVAL_UNDERESTIMATE moves the step to the nearer neighbour, z[j] - z[j-1] away, whose transmittance becomes
//   t[j]. The last node may go, and the total transmittance stays exact. The first may not: before it lies the implicit
//   node, whose transmittance is 1.
// - NODE_REMOVAL_OVERESTIMATE moves it to the farther neighbour, z[j+1] - z[j] away. The first node may go. The last
//   may not: behind it lies infinity.
// - NODE_REMOVAL_MIXED takes the cheaper of the two, node by node.
//
// With three channels (Common/Channels.glsl) nodes have three transmittances and common depths; the area is the mean of
// the three.
//
// The paper removes the node whose area is least. An area is what vis is off by where fragments could lie, at any depth
// alike. But fragments lie at nodes, and one whose node goes is seen through the wrong transmittance however thin the
// rectangle is: of many nearly coincident ones, areas remove all nodes but one, whatever these hide. So with
// ALPHA_CORRECTION 1 every rectangle counts as wider than it is, by 1/256 of the distance from the first node to the
// last (Documentation/Adaptive.md). A power of two: products of such widths stay exact.
//
// ESTIMATE_ERROR 1: the areas that were lost are summed.
//
// REMOVAL_LOSS(step, width) and REMOVAL_WIDER: other losses, and other parts of that distance
// (scripts/document-adaptive has tried some).
//
// Needs: NODE_COUNT, NODE_REMOVAL, ALPHA_CORRECTION, TRANSMITTANCE_CHANNELS.  Gives: Visibility, removeNode.
#ifndef RemoveNode_glsl
#define RemoveNode_glsl
#include "Adaptive/EachNode.glsl"
#include "Common/Channels.glsl"
#include "Common/Language.glsl"
#ifndef NODE_REMOVAL
#error "RemoveNode.glsl needs NODE_REMOVAL"
#endif
#ifndef ALPHA_CORRECTION
#error "RemoveNode.glsl needs ALPHA_CORRECTION"
#endif

#define NODE_REMOVAL_UNDERESTIMATE 0
#define NODE_REMOVAL_OVERESTIMATE 1
#define NODE_REMOVAL_MIXED 2
#define NODE_EMPTY 2.0f // behind every window depth
#ifndef REMOVAL_LOSS
#define REMOVAL_LOSS(step, width) ((step) * (width))
#endif
#ifndef REMOVAL_WIDER
#if ALPHA_CORRECTION
#define REMOVAL_WIDER (1.0f / 256.0f)
#else
#define REMOVAL_WIDER 0.0f
#endif
#endif
#ifndef ESTIMATE_ERROR
#define ESTIMATE_ERROR 0
#endif

struct Visibility
{
  float z[NODE_COUNT + 1];
  Channels t[NODE_COUNT + 1];
  float narrowest; // of the distances between neighbours when a node was removed
#if ESTIMATE_ERROR
  float lost; // the areas of all removals
  float nearest; // of the fragments
  float farthest;
#endif
};

// What goes: node `depth`'s depth, and one transmittance: that of node depth - 1 (underestimate) or of the node itself
// (overestimate). loss is what decides.
struct Removal
{
  float loss;
#if ESTIMATE_ERROR
  float area;
#endif
  int depth;
  int transmittance;
};

// Takes a removal if it loses less. It is given what it needs: of a whole function each call would have a copy, which
// took compilers seconds for 64 nodes.
void considerRemoval(INOUT(Removal) least, int depth, int transmittance, float step, float width, float wider)
{
  float loss = REMOVAL_LOSS(step, width + wider);
  bool less = loss < least.loss;
  least.depth = less ? depth : least.depth;
  least.transmittance = less ? transmittance : least.transmittance;
#if ESTIMATE_ERROR
  least.area = less ? step * width : least.area;
#endif
  least.loss = min(loss, least.loss);
}

void removeNode(INOUT(Visibility) v)
{
  Removal least;
  least.depth = 0;
  least.transmittance = 0;
  least.loss = 1e30f;
#if ESTIMATE_ERROR
  least.area = 0.0f;
#endif
  float wider = REMOVAL_WIDER * (v.z[NODE_COUNT] - v.z[0]);
  float step;
#if NODE_REMOVAL != NODE_REMOVAL_UNDERESTIMATE
  considerRemoval(least, 0, 0, 1.0f - meanOf(v.t[0]), v.z[1] - v.z[0], wider);
#define CONSIDER_FARTHER(k) \
  if ((k) < NODE_COUNT) \
  { \
    considerRemoval(least, (k), (k), step, v.z[min((k) + 1, NODE_COUNT)] - v.z[k], wider); \
  }
#else
#define CONSIDER_FARTHER(k)
#endif
#if NODE_REMOVAL != NODE_REMOVAL_OVERESTIMATE
#define CONSIDER_NEARER(k) considerRemoval(least, (k), (k)-1, step, v.z[k] - v.z[(k)-1], wider);
#else
#define CONSIDER_NEARER(k)
#endif
#define FIND_LEAST(i) \
  v.narrowest = min(v.narrowest, v.z[(i) + 1] - v.z[i]); \
  step = meanOf(v.t[i] - v.t[(i) + 1]); \
  CONSIDER_NEARER((i) + 1) \
  CONSIDER_FARTHER((i) + 1)
  EACH_NODE(FIND_LEAST)
#if ESTIMATE_ERROR
  v.lost += least.area;
#endif
  // Those behind what is removed move up. Written so that a compiler sees what comparisons have in common.
#if NODE_REMOVAL == NODE_REMOVAL_UNDERESTIMATE
#define KEEPS_TRANSMITTANCE(k) ((k) + 1 < least.depth)
#else
#define KEEPS_TRANSMITTANCE(k) ((k) < least.transmittance)
#endif
#define MOVE_UP(k) \
  v.z[k] = (k) < least.depth ? v.z[k] : v.z[(k) + 1]; \
  v.t[k] = KEEPS_TRANSMITTANCE(k) ? v.t[k] : v.t[(k) + 1];
  EACH_NODE(MOVE_UP)
  v.z[NODE_COUNT] = NODE_EMPTY;
}

#endif
