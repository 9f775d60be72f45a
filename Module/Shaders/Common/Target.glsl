// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Target.glsl: reading what an earlier stage has drawn (vtkTranslucencyTargets).
//
// Where the window is multi-sampled the shader runs once for each sample, and reads that sample; or, where the driver
// shades no samples (SHADES_SAMPLES 0), what it draws is drawn once for each (vtkTranslucencyDrawings).
//
// Needs: TARGET_SAMPLES, SHADES_SAMPLES.  Gives: Target, the type of the samplers, fetchTarget, TARGET_SAMPLE.
#ifndef Target_glsl
#define Target_glsl
#ifndef TARGET_SAMPLES
#error "Target.glsl needs TARGET_SAMPLES"
#endif

#ifndef SHADES_SAMPLES
#error "Target.glsl needs SHADES_SAMPLES"
#endif

#if TARGET_SAMPLES > 1
#if SHADES_SAMPLES
#define TARGET_SAMPLE gl_SampleID
#else
uniform int targetSample;
#define TARGET_SAMPLE targetSample
#endif
#define Target sampler2DMS
#define fetchTarget(target, pixel) texelFetch(target, pixel, TARGET_SAMPLE)
#else
#define TARGET_SAMPLE 0
#define Target sampler2D
#define fetchTarget(target, pixel) texelFetch(target, pixel, 0)
#endif

#endif
