// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// EachNode.glsl: loops over the nodes of a visibility function, unrolled by the preprocessor.
//
// Only where all indices are constants do the nodes stay in registers (a CPU's SIMD lanes). Compilers unroll short
// loops of few instructions (Mesa 32 rounds, about 800 instructions, and not always where other code stands around
// them); one that is not unrolled takes ten times as long, in silence. That is so for many nodes, too: as loops over 32
// or 64 nodes a frame in fixed memory took three times as long, and compiling was no faster (Documentation/Drivers.md).
//
// EACH_NODE(call) is call(0) call(1) ... call(NODE_COUNT - 1), and EACH_NODE_BACKWARDS(call) the same from the last to
// the first.
//
// Needs: NODE_COUNT (1 to 64).  Gives: EACH_NODE, EACH_NODE_BACKWARDS.
#ifndef EachNode_glsl
#define EachNode_glsl
#ifndef NODE_COUNT
#error "EachNode.glsl needs NODE_COUNT"
#endif

#define NODES_1(call, k) call((k))
#define NODES_2(call, k) NODES_1(call, k) NODES_1(call, (k) + 1)
#define NODES_4(call, k) NODES_2(call, k) NODES_2(call, (k) + 2)
#define NODES_8(call, k) NODES_4(call, k) NODES_4(call, (k) + 4)
#define NODES_16(call, k) NODES_8(call, k) NODES_8(call, (k) + 8)
#define NODES_32(call, k) NODES_16(call, k) NODES_16(call, (k) + 16)
#define NODES_64(call, k) NODES_32(call, k) NODES_32(call, (k) + 32)

#define BACKWARDS_1(call, k) call((k))
#define BACKWARDS_2(call, k) BACKWARDS_1(call, (k) + 1) BACKWARDS_1(call, k)
#define BACKWARDS_4(call, k) BACKWARDS_2(call, (k) + 2) BACKWARDS_2(call, k)
#define BACKWARDS_8(call, k) BACKWARDS_4(call, (k) + 4) BACKWARDS_4(call, k)
#define BACKWARDS_16(call, k) BACKWARDS_8(call, (k) + 8) BACKWARDS_8(call, k)
#define BACKWARDS_32(call, k) BACKWARDS_16(call, (k) + 16) BACKWARDS_16(call, k)
#define BACKWARDS_64(call, k) BACKWARDS_32(call, (k) + 32) BACKWARDS_32(call, k)

// NODE_COUNT as a sum of powers of two, each with what the greater ones have taken.
#if NODE_COUNT / 64 % 2 == 1
#define FORWARDS_PART_64(call) NODES_64(call, NODE_COUNT / 128 * 128)
#define BACKWARDS_PART_64(call) BACKWARDS_64(call, NODE_COUNT / 128 * 128)
#else
#define FORWARDS_PART_64(call)
#define BACKWARDS_PART_64(call)
#endif
#if NODE_COUNT / 32 % 2 == 1
#define FORWARDS_PART_32(call) NODES_32(call, NODE_COUNT / 64 * 64)
#define BACKWARDS_PART_32(call) BACKWARDS_32(call, NODE_COUNT / 64 * 64)
#else
#define FORWARDS_PART_32(call)
#define BACKWARDS_PART_32(call)
#endif
#if NODE_COUNT / 16 % 2 == 1
#define FORWARDS_PART_16(call) NODES_16(call, NODE_COUNT / 32 * 32)
#define BACKWARDS_PART_16(call) BACKWARDS_16(call, NODE_COUNT / 32 * 32)
#else
#define FORWARDS_PART_16(call)
#define BACKWARDS_PART_16(call)
#endif
#if NODE_COUNT / 8 % 2 == 1
#define FORWARDS_PART_8(call) NODES_8(call, NODE_COUNT / 16 * 16)
#define BACKWARDS_PART_8(call) BACKWARDS_8(call, NODE_COUNT / 16 * 16)
#else
#define FORWARDS_PART_8(call)
#define BACKWARDS_PART_8(call)
#endif
#if NODE_COUNT / 4 % 2 == 1
#define FORWARDS_PART_4(call) NODES_4(call, NODE_COUNT / 8 * 8)
#define BACKWARDS_PART_4(call) BACKWARDS_4(call, NODE_COUNT / 8 * 8)
#else
#define FORWARDS_PART_4(call)
#define BACKWARDS_PART_4(call)
#endif
#if NODE_COUNT / 2 % 2 == 1
#define FORWARDS_PART_2(call) NODES_2(call, NODE_COUNT / 4 * 4)
#define BACKWARDS_PART_2(call) BACKWARDS_2(call, NODE_COUNT / 4 * 4)
#else
#define FORWARDS_PART_2(call)
#define BACKWARDS_PART_2(call)
#endif
#if NODE_COUNT / 1 % 2 == 1
#define FORWARDS_PART_1(call) NODES_1(call, NODE_COUNT / 2 * 2)
#define BACKWARDS_PART_1(call) BACKWARDS_1(call, NODE_COUNT / 2 * 2)
#else
#define FORWARDS_PART_1(call)
#define BACKWARDS_PART_1(call)
#endif

#define EACH_NODE(call) \
  FORWARDS_PART_64(call) FORWARDS_PART_32(call) FORWARDS_PART_16(call) FORWARDS_PART_8(call) \
  FORWARDS_PART_4(call) FORWARDS_PART_2(call) FORWARDS_PART_1(call)
#define EACH_NODE_BACKWARDS(call) \
  BACKWARDS_PART_1(call) BACKWARDS_PART_2(call) BACKWARDS_PART_4(call) BACKWARDS_PART_8(call) \
  BACKWARDS_PART_16(call) BACKWARDS_PART_32(call) BACKWARDS_PART_64(call)

#endif
