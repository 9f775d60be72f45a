// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/Merge.glsl: puts the layers just peeled behind those from the front, and in front of those from the back.
//
// Blending does that: under and over. The bounds of the next layers are the lesser ones, GL_MIN: what is left lies
// between the layers that have been peeled, and NO_BOUNDS is less than any.
//
// Needs: PEEL_METHOD, TARGET_SAMPLES.  Gives: main.
#ifndef PEEL_METHOD
#error "Peel/Merge.glsl needs PEEL_METHOD"
#endif
#include "Common/Target.glsl"
#include "Peel/Methods.glsl"

uniform Target nextBounds;
uniform Target frontLayer;
layout(location = 0) out vec4 fragOutput0;
layout(location = 1) out vec4 fragOutput1;
#if PEEL_METHOD == PEEL_DUAL
uniform Target backLayer;
layout(location = 2) out vec4 fragOutput2;
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  fragOutput0 = fetchTarget(nextBounds, pixel);
  fragOutput1 = fetchTarget(frontLayer, pixel);
#if PEEL_METHOD == PEEL_DUAL
  fragOutput2 = fetchTarget(backLayer, pixel);
#endif
}
