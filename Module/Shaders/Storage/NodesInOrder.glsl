// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// NodesInOrder.glsl: nodes where the driver keeps the order of drawing, as software rasterizers do: nobody else is at a
// pixel's fragments.
//
// A node is written in numbers of 64 bits where there are such: a software rasterizer stores each component on its own,
// and checks where to.
//
// Needs: what Storage/Nodes.glsl needs.  Gives: what that gives, MERGES_SAMPLES, and if that is 1: mergeIntoNode.
#ifndef NodesInOrder_glsl
#define NodesInOrder_glsl
#include "Common/Bindings.glsl"
#ifdef GL_ARB_gpu_shader_int64
#define NODE_PAIRS
layout(std430, binding = STORAGE_BINDING_FRAGMENTS) buffer NodePairs
{
  u64vec2 nodePairs[];
};
#endif
#include "Common/MergeSamples.glsl"
#include "Storage/Nodes.glsl"

#if MERGES_SAMPLES
// Whether a fragment has joined the one that was stored last in its pixel; 0 if there is none. A node behind the last
// one is counted only.
bool mergeIntoNode(uint last, Fragment fragment, float depthExtent)
{
  if (last != 0u && last <= nodeRoom())
  {
    uint next;
    Fragment stored = loadNode(last, next);
    if (mayMerge(stored, fragment, depthExtent))
    {
      writeNode(last - 1u, next, mergeFragments(stored, fragment));
      return true;
    }
  }
  return false;
}
#endif

#endif
