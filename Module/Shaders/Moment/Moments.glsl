// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/Moments.glsl: which moments, by number: 4, 6, 8 power moments, or 2, 3, 4 trigonometric ones.
//
// MOMENT_BIAS is the share of the distribution that has mass all over, as far as 32 bits need it for a few layers of
// any opacity: more loses detail, with less, rounding decides where masses are. Where sums are rounded more it is more:
// at least TERM_ROUNDING.
//
// Valid C++, too.
//
// Needs: MOMENT_BASIS (0 to 5); in C++ OVERESTIMATION, of which GLSL makes a uniform.  Gives: what Moment/Power.glsl or
// Moment/Trigonometric.glsl gives.
#ifndef Moments_glsl
#define Moments_glsl
#ifndef MOMENT_BASIS
#error "Moment/Moments.glsl needs MOMENT_BASIS"
#endif

#if MOMENT_BASIS == 2
#define MOMENT_BIAS 5e-5f
#elif MOMENT_BASIS == 1
#define MOMENT_BIAS 5e-6f
#else
#define MOMENT_BIAS 5e-7f
#endif

#ifndef __cplusplus
uniform float overestimation;
#define OVERESTIMATION overestimation
#endif

#if MOMENT_BASIS < 3
#define MOMENTS (4 + 2 * MOMENT_BASIS)
#include "Moment/Power.glsl"
#else
#define TRIGONOMETRIC_MOMENTS (MOMENT_BASIS - 1)
#include "Moment/Trigonometric.glsl"
#endif

#endif
