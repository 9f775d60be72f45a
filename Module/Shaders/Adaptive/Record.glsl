// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/Record.glsl: what a pixel's record holds in fixed memory. Its count is that of its fragments, up to
// NODE_COUNT + 1: then nodes were removed.
//
// First the depths of the nodes, then their transmittances: in 16 bits each, two a word, since a word more takes more
// time than packing; with three channels (Common/Channels.glsl) in floats. With ESTIMATE_ERROR 1 there follows what the
// estimate is made of.
//
// In colours (RECORD_TARGETS, one channel and no estimate) the count lies before them, and behind them the sums over
// the pixel's weighted fragments, which blending adds up elsewhere.
//
// Needs: NODE_COUNT, ESTIMATE_ERROR, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: Common/RecordNumbers.glsl, fragmentCount,
// setFragmentCount, nodeTransmittance, LOAD_TRANSMITTANCE(k), STORE_TRANSMITTANCE(k), RECORD_DEPTH, RECORD_LOST,
// RECORD_NEAREST, RECORD_FARTHEST, RECORD_SUMS.
#ifndef Record_glsl
#define Record_glsl
#ifndef NODE_COUNT
#error "Adaptive/Record.glsl needs NODE_COUNT"
#endif
#ifndef ESTIMATE_ERROR
#error "Adaptive/Record.glsl needs ESTIMATE_ERROR"
#endif
#include "Common/Channels.glsl"

#if RECORD_TARGETS
#define RECORD_DEPTH 1
#else
#define RECORD_DEPTH 0
#endif
#define RECORD_TRANSMITTANCE (RECORD_DEPTH + NODE_COUNT)
#if TRANSMITTANCE_CHANNELS == 3
#define RECORD_LOST (RECORD_TRANSMITTANCE + 3 * NODE_COUNT)
#else
#define RECORD_LOST (RECORD_TRANSMITTANCE + (NODE_COUNT + 1) / 2)
#endif
#define RECORD_NEAREST (RECORD_LOST + 1)
#define RECORD_FARTHEST (RECORD_LOST + 2)
#define RECORD_SUMS RECORD_LOST
#if ESTIMATE_ERROR
#define PIXEL_WORDS (RECORD_LOST + 3)
#else
#define PIXEL_WORDS RECORD_LOST
#endif
#include "Common/RecordNumbers.glsl"

#if RECORD_TARGETS
uint fragmentCount(PixelRecord record)
{
  return recordFloat(record, 0) == EMPTY_NUMBER ? 0u : recordWord(record, 0);
}

void setFragmentCount(PixelRecord record, uint count)
{
  setRecordWord(record, 0, count);
}
#else
#define fragmentCount recordCount
#define setFragmentCount setRecordCount
#endif

// The macros are for EACH_NODE: k is a constant, last the transmittance of the node before, values are of nodes below
// count.
#if TRANSMITTANCE_CHANNELS == 3
Channels nodeTransmittance(PixelRecord record, int node)
{
  int word = RECORD_TRANSMITTANCE + 3 * node;
  return uintBitsToFloat(uvec3(recordWord(record, word), recordWord(record, word + 1), recordWord(record, word + 2)));
}

void setNodeTransmittance(PixelRecord record, int node, Channels transmittance)
{
  int word = RECORD_TRANSMITTANCE + 3 * node;
  setRecordWord(record, word, floatBitsToUint(transmittance.r));
  setRecordWord(record, word + 1, floatBitsToUint(transmittance.g));
  setRecordWord(record, word + 2, floatBitsToUint(transmittance.b));
}

#define LOAD_TRANSMITTANCE(k) \
  if (uint(k) < count) \
  { \
    last = nodeTransmittance(record, k); \
  } \
  visibility.t[k] = last;
#define STORE_TRANSMITTANCE(k) \
  if (uint(k) < count) \
  { \
    setNodeTransmittance(record, k, visibility.t[k]); \
  }
#else
vec2 pairOfTransmittances(PixelRecord record, int pair)
{
  return unpackUnorm2x16(recordWord(record, RECORD_TRANSMITTANCE + pair));
}

Channels nodeTransmittance(PixelRecord record, int node)
{
  vec2 pair = pairOfTransmittances(record, node / 2);
  return node % 2 == 0 ? pair.x : pair.y;
}

#define LOAD_TRANSMITTANCE(k) \
  if ((k) % 2 == 0 && uint(k) < count) \
  { \
    pair = pairOfTransmittances(record, (k) / 2); \
  } \
  last = uint(k) < count ? ((k) % 2 == 0 ? pair.x : pair.y) : last; \
  visibility.t[k] = last;
#define STORE_TRANSMITTANCE(k) \
  if ((k) % 2 == 0 && uint(k) < count) \
  { \
    setRecordWord(record, RECORD_TRANSMITTANCE + (k) / 2, \
      packUnorm2x16(vec2(visibility.t[k], visibility.t[(k) + 1]))); \
  }
#endif

#endif
