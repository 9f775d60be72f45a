// Absorbance/EachVector.glsl: EACH_VECTOR(call) is call(0) call(1) ..., one for each of TERM_VECTORS vectors.
//
// Not a loop: compilers leave some loops over the terms as loops in the mappers' long shaders, and an array whose index is not a constant does
// not stay in registers. That took five times as long.
//
// Needs: TERM_VECTORS (1 to 8).  Gives: EACH_VECTOR.
#ifndef EachVector_glsl
#define EachVector_glsl
#ifndef TERM_VECTORS
#error "Absorbance/EachVector.glsl needs TERM_VECTORS"
#endif

#if TERM_VECTORS == 1
#define EACH_VECTOR(call) call(0)
#elif TERM_VECTORS == 2
#define EACH_VECTOR(call) call(0) call(1)
#elif TERM_VECTORS == 3
#define EACH_VECTOR(call) call(0) call(1) call(2)
#elif TERM_VECTORS == 4
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3)
#elif TERM_VECTORS == 5
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4)
#elif TERM_VECTORS == 6
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4) call(5)
#elif TERM_VECTORS == 7
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4) call(5) call(6)
#else
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4) call(5) call(6) call(7)
#endif

#endif
