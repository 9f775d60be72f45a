// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Coverage.glsl: which samples of its pixel a fragment is for.
//
// Needs: SAMPLES.  Gives: coveredSamples.
#ifndef Coverage_glsl
#define Coverage_glsl
#include "Common/Tile.glsl"

// The samples that the primitive covers and that pass the depth test; one of them where a shader runs for each sample.
uint coveredSamples()
{
#if SAMPLES > 1
  return uint(gl_SampleMaskIn[0]) & ALL_SAMPLES;
#else
  return ALL_SAMPLES;
#endif
}

#endif
