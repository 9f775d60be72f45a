// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// CompositeSamples.glsl: the samples of which the colours wait in sampleColors, each in an invocation of its own.
//
// Needs: SAMPLES, TRANSMITTANCE_CHANNELS.
#include "Common/SampleColors.glsl"
#include "Common/Samples.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  return takeSample(pixel, gl_SampleID, color, transmittance);
}

#include "Common/Resolve.glsl"
