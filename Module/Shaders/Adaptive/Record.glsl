// Adaptive/Record.glsl: what a pixel's record holds in fixed memory: the depth and the transmittance of each node, and with ESTIMATE_ERROR 1 what
// the estimate is made of. Its count is that of the nodes in use.
//
// Needs: NODE_COUNT, ESTIMATE_ERROR, SAMPLES.  Gives: Common/Pixels.glsl, RECORD_LOST, RECORD_NEAREST, RECORD_FARTHEST.
#ifndef Record_glsl
#define Record_glsl
#ifndef NODE_COUNT
#error "Adaptive/Record.glsl needs NODE_COUNT"
#endif
#ifndef ESTIMATE_ERROR
#error "Adaptive/Record.glsl needs ESTIMATE_ERROR"
#endif
#define RECORD_LOST (2 * NODE_COUNT)
#define RECORD_NEAREST (2 * NODE_COUNT + 1)
#define RECORD_FARTHEST (2 * NODE_COUNT + 2)
#if ESTIMATE_ERROR
#define PIXEL_WORDS (2 * NODE_COUNT + 3)
#else
#define PIXEL_WORDS (2 * NODE_COUNT)
#endif
#include "Common/Pixels.glsl"

#endif
