// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/LayerLists.glsl: what a pixel knows of its layers where several are peeled in a drawing, into targets.
//
// Six of the layers that are left are listed by their depths, and are taken off in the next drawing:
// - PEEL_SIDES 2: the three nearest, nearest first, and the three farthest, farthest first;
// - PEEL_SIDES 1: the six nearest, nearest first.
// The first list's alpha is the nearest depth that is left, the second list's the farthest one, or with PEEL_SIDES 1
// how many layers have been peeled.
//
// Fragments whose depths are not listed fall into buckets, by a hash of the depth. A bucket keeps the nearest of its
// depths, and with PEEL_SIDES 2 the farthest, too: two targets with four numbers each, of which blending (GL_MAX) keeps
// the largest, depths of nearest ones negative. The nearest of all is then known, and of those behind it each that no
// nearer one shares a bucket with. The paper's buckets are intervals of depth; those want to know how depths are
// spread, and depths that are close to each other share one. What a hash has put together, another hash parts: each
// drawing has one of its own.
//
// Needs: PEEL_SIDES.  Gives: PEEL_OUTPUTS, NO_DEPTH, bucketsOf.
#ifndef LayerLists_glsl
#define LayerLists_glsl
#ifndef PEEL_SIDES
#error "Peel/LayerLists.glsl needs PEEL_SIDES"
#endif

#define PEEL_OUTPUTS 8 // two targets of buckets, and one a listed layer

#define NO_DEPTH 1e30
#define DONE_TWICE 2e30 // a nearest depth: no layer is left, and both states say so
#define NOTHING vec4(-NO_DEPTH)

// What a fragment puts into the buckets, as the two targets have it.
void bucketsOf(float depth, int drawing, out vec4 first, out vec4 second)
{
  uint hash = (floatBitsToUint(depth) ^ uint(drawing) * 0x85ebca77u) * 0x9e3779b1u;
#if PEEL_SIDES == 2
  vec4 both = vec4(-depth, depth, -depth, depth);
  vec4 place = vec4(equal(uvec4(0u, 0u, 1u, 1u), uvec4(hash >> 30u & 1u)));
#else
  vec4 both = vec4(-depth);
  vec4 place = vec4(equal(uvec4(0u, 1u, 2u, 3u), uvec4(hash >> 29u & 3u)));
#endif
  vec4 bucket = mix(NOTHING, both, notEqual(place, vec4(0.0)));
  bool of = (hash >> 31u) == 0u;
  first = of ? bucket : NOTHING;
  second = of ? NOTHING : bucket;
}

#endif
