// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// EachVector.glsl: EACH_VECTOR(call) is call(0) call(1) ..., one for each of VECTOR_COUNT vectors.
//
// Not a loop: compilers leave some loops over vectors as loops in the mappers' long shaders, and an array whose index
// is not a constant does not stay in registers: each lane of a CPU's vector is then written by itself. That took two to
// five times as long.
//
// Needs: VECTOR_COUNT (1 to 8, or 16).  Gives: EACH_VECTOR.
#ifndef EachVector_glsl
#define EachVector_glsl
#ifndef VECTOR_COUNT
#error "EachVector.glsl needs VECTOR_COUNT"
#endif

#if VECTOR_COUNT == 1
#define EACH_VECTOR(call) call(0)
#elif VECTOR_COUNT == 2
#define EACH_VECTOR(call) call(0) call(1)
#elif VECTOR_COUNT == 3
#define EACH_VECTOR(call) call(0) call(1) call(2)
#elif VECTOR_COUNT == 4
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3)
#elif VECTOR_COUNT == 5
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4)
#elif VECTOR_COUNT == 6
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4) call(5)
#elif VECTOR_COUNT == 7
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4) call(5) call(6)
#elif VECTOR_COUNT == 8
#define EACH_VECTOR(call) call(0) call(1) call(2) call(3) call(4) call(5) call(6) call(7)
#else
#define EACH_VECTOR(call) \
  call(0) call(1) call(2) call(3) call(4) call(5) call(6) call(7) \
  call(8) call(9) call(10) call(11) call(12) call(13) call(14) call(15)
#endif

#endif
