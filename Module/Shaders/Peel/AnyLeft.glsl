// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/AnyLeft.glsl: leaves a fragment where a pixel has layers that are yet to be peeled (LayerLists.glsl).
//
// Needs: PEEL_SIDES, PEEL_LAYERS (the most to peel, 0 for all), TARGET_SAMPLES.  Gives: main.
#ifndef PEEL_LAYERS
#error "Peel/AnyLeft.glsl needs PEEL_LAYERS"
#endif
#include "Common/Target.glsl"
#include "Peel/LayerLists.glsl"

uniform Target firstList;
uniform Target secondList;
out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool left = fetchTarget(firstList, pixel).a < NO_DEPTH;
#if PEEL_SIDES == 1 && PEEL_LAYERS > 0
  left = left && fetchTarget(secondList, pixel).a < float(PEEL_LAYERS);
#endif
  fragOutput0 = vec4(0.0);
  if (!left)
  {
    discard;
  }
}
