// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Target.glsl: reading what an earlier stage has drawn (vtkTranslucencyTargets).
//
// Where the window is multi-sampled the shader runs once for each sample, and reads that sample.
//
// Needs: TARGET_SAMPLES.  Gives: Target, the type of the samplers, and fetchTarget.
#ifndef Target_glsl
#define Target_glsl
#ifndef TARGET_SAMPLES
#error "Target.glsl needs TARGET_SAMPLES"
#endif

#if TARGET_SAMPLES > 1
#define Target sampler2DMS
#define fetchTarget(target, pixel) texelFetch(target, pixel, gl_SampleID)
#else
#define Target sampler2D
#define fetchTarget(target, pixel) texelFetch(target, pixel, 0)
#endif

#endif
