// Adaptive/Record.glsl: what a pixel's record holds in fixed memory: the depth and the transmittance, or three of them, of each node, and with ESTIMATE_ERROR 1 what
// the estimate is made of. Its count is that of the nodes in use.
//
// Needs: NODE_COUNT, ESTIMATE_ERROR, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: Common/Pixels.glsl, NODE_WORDS, nodeTransmittance,
// setNodeTransmittance, RECORD_LOST, RECORD_NEAREST, RECORD_FARTHEST.
#ifndef Record_glsl
#define Record_glsl
#ifndef NODE_COUNT
#error "Adaptive/Record.glsl needs NODE_COUNT"
#endif
#ifndef ESTIMATE_ERROR
#error "Adaptive/Record.glsl needs ESTIMATE_ERROR"
#endif
#include "Common/Channels.glsl"

#define NODE_WORDS (1 + TRANSMITTANCE_CHANNELS)
#define RECORD_LOST (NODE_WORDS * NODE_COUNT)
#define RECORD_NEAREST (NODE_WORDS * NODE_COUNT + 1)
#define RECORD_FARTHEST (NODE_WORDS * NODE_COUNT + 2)
#if ESTIMATE_ERROR
#define PIXEL_WORDS (NODE_WORDS * NODE_COUNT + 3)
#else
#define PIXEL_WORDS (NODE_WORDS * NODE_COUNT)
#endif
#include "Common/Pixels.glsl"

Channels nodeTransmittance(PixelRecord record, int node)
{
  int word = NODE_WORDS * node + 1;
#if TRANSMITTANCE_CHANNELS == 3
  return uintBitsToFloat(uvec3(recordWord(record, word), recordWord(record, word + 1), recordWord(record, word + 2)));
#else
  return uintBitsToFloat(recordWord(record, word));
#endif
}

void setNodeTransmittance(PixelRecord record, int node, Channels transmittance)
{
  int word = NODE_WORDS * node + 1;
#if TRANSMITTANCE_CHANNELS == 3
  setRecordWord(record, word, floatBitsToUint(transmittance.r));
  setRecordWord(record, word + 1, floatBitsToUint(transmittance.g));
  setRecordWord(record, word + 2, floatBitsToUint(transmittance.b));
#else
  setRecordWord(record, word, floatBitsToUint(transmittance));
#endif
}

#endif
