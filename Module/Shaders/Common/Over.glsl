// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Over.glsl: what blending takes to put a colour over what is there: colour + transmittance * that
// (vtkTranslucencyFrame::GetOver).
//
// With one channel it takes the transmittance from alpha, which is 1 - transmittance; with three from a second source
// colour.
//
// Needs: TRANSMITTANCE_CHANNELS.  Gives: overOutput, which is output 0.
#ifndef Over_glsl
#define Over_glsl
#include "Common/Channels.glsl"

#if TRANSMITTANCE_CHANNELS == 3
layout(location = 0, index = 1) out vec4 transmittanceOutput;

vec4 overOutput(vec3 color, Channels opacity)
{
  transmittanceOutput = vec4(1.0 - opacity, 0.0);
  return vec4(color, meanOf(opacity));
}
#else
vec4 overOutput(vec3 color, Channels opacity)
{
  return vec4(color, opacity);
}
#endif

#endif
