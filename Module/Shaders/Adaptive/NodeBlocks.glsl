// NodeBlocks.glsl: loops over the nodes of a visibility function that every compiler unrolls.
//
// Only then are all indices constants, and the nodes stay in registers (a CPU's SIMD lanes). Mesa unrolls a loop of at most 32 rounds
// and about 800 instructions; where it does not, 64 nodes take ten times as long. So a function with a loop of NODE_BLOCK rounds is
// called for each block of nodes: EACH_BLOCK(call) is call(0) call(16) ..., as many as NODE_COUNT needs, and EACH_BLOCK_BACKWARDS(call)
// the same from the last to the first. The last block may reach beyond NODE_COUNT.
//
// Needs: NODE_COUNT (1 to 64).  Gives: NODE_BLOCK, EACH_BLOCK, EACH_BLOCK_BACKWARDS.
#ifndef NodeBlocks_glsl
#define NodeBlocks_glsl
#ifndef NODE_COUNT
#error "NodeBlocks.glsl needs NODE_COUNT"
#endif

#define NODE_BLOCK 16

#if NODE_COUNT <= 16
#define EACH_BLOCK(call) call(0)
#define EACH_BLOCK_BACKWARDS(call) call(0)
#elif NODE_COUNT <= 32
#define EACH_BLOCK(call) call(0) call(16)
#define EACH_BLOCK_BACKWARDS(call) call(16) call(0)
#elif NODE_COUNT <= 48
#define EACH_BLOCK(call) call(0) call(16) call(32)
#define EACH_BLOCK_BACKWARDS(call) call(32) call(16) call(0)
#else
#define EACH_BLOCK(call) call(0) call(16) call(32) call(48)
#define EACH_BLOCK_BACKWARDS(call) call(48) call(32) call(16) call(0)
#endif

#endif
