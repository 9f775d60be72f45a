// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ScreenDoor/Resolve.glsl: the nearest fragment that the mask has let through, opaque.
//
// Needs: TARGET_SAMPLES.
#include "Common/Target.glsl"

uniform Target screenDoorNearest;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 nearest = fetchTarget(screenDoorNearest, pixel);
  color = nearest.rgb;
  transmittance = 0.0;
  return nearest.a > 0.0;
}

#include "Common/Composite.glsl"
