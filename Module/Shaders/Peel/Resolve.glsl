// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/Resolve.glsl: a pixel's colour: the layers from the front, then the tail, then the layers from the back.
//
// Colours of layers are multiplied by their opacity. Alpha is what the front ones let through, and the opacity of the
// back ones. The tail's colour is the mean of its fragments' colours by their opacities, as opaque as they all are one
// behind the other: (1 - product(1 - a)) * sum(a c) / sum(a)
//
// Needs: PEEL_METHOD, PEEL_TAIL (whether there is one), TARGET_SAMPLES.
#ifndef PEEL_METHOD
#error "Peel/Resolve.glsl needs PEEL_METHOD"
#endif
#ifndef PEEL_TAIL
#error "Peel/Resolve.glsl needs PEEL_TAIL"
#endif
#include "Common/Target.glsl"
#include "Peel/Methods.glsl"

uniform Target frontLayers;
#if PEEL_METHOD == PEEL_DUAL
uniform Target backLayers;
#endif
#if PEEL_TAIL
uniform Target tailOpacities;
uniform Target tailColors;
#endif

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 front = fetchTarget(frontLayers, pixel);
  color = front.rgb;
  transmittance = front.a;
#if PEEL_TAIL
  float opacities = fetchTarget(tailOpacities, pixel).r;
  vec4 tail = fetchTarget(tailColors, pixel);
  color += transmittance * (1.0 - tail.a) * tail.rgb / max(opacities, 1e-30);
  transmittance *= tail.a;
#endif
#if PEEL_METHOD == PEEL_DUAL
  vec4 back = fetchTarget(backLayers, pixel);
  color += transmittance * back.rgb;
  transmittance *= 1.0 - back.a;
#endif
  return transmittance < 1.0;
}

#include "Common/Composite.glsl"
