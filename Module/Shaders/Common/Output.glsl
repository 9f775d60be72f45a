// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Output.glsl: what a full-screen pass gives to blending, which puts it over the opaque picture.
//
// Needs: TRANSMITTANCE_CHANNELS.  Gives: writeOutput.
#ifndef Output_glsl
#define Output_glsl
#include "Common/Over.glsl"

#if TRANSMITTANCE_CHANNELS == 3
layout(location = 0, index = 0) out vec4 fragOutput0;
#else
out vec4 fragOutput0;
#endif

void writeOutput(vec3 color, Channels transmittance)
{
  fragOutput0 = overOutput(color, 1.0 - transmittance);
}

#endif
