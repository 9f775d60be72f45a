// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Background/Gather.glsl: how far a surface displaces and blurs what is seen behind it, in pixels. Blending sums it up
// over a pixel's surfaces, in any order (McGuire and Mara 2017, "Phenomenological transparency"; Aizenshtein et al.
// 2021, "Wavelet transparency", section 3).
//
// The ray is bent by Snell's law at the normal and goes on to the plane in which the opaque surface of the pixel lies.
// Where it leaves a body, it is bent back by as much as it would have been where it had entered at that normal: the two
// faces of a slab displace by what the ray is bent times the slab's thickness, and those of a ball focus. A pane
// displaces by its own thickness.
//
// Needs: nothing.  Gives: gatherFragment.
#include "Common/Frame.glsl"

uniform vec4 backgroundScale; // pixels a unit of length, or of slope in perspective: x, y; 1 where it is parallel
uniform vec4 backgroundRange; // distances of the near and the far plane
uniform vec4 gatherBend;      // index of refraction, thickness of a pane or 0, diffusion, dispersion
uniform float gatherEntry;    // 1 where front faces are entries, -1 where back faces are
uniform sampler2D translucencyOpaqueDepth;

const float steepest = 0.1; // of the bent ray, against the direction of view

float distanceAt(float depth)
{
  float near = backgroundRange.x;
  float far = backgroundRange.y;
  return backgroundScale.z == 1.0 ? mix(near, far, depth) : near * far / (far - depth * (far - near));
}

// How much the slope of a ray changes, to the side a unit of depth.
vec2 bendAt(vec3 ray, vec3 normal, float index)
{
  vec3 direction = normalize(ray);
  vec3 bent = refract(direction, faceforward(normal, direction, normal), 1.0 / index);
  return bent.xy / max(-bent.z, steepest) - ray.xy;
}

// normal is of length 1, in eye coordinates; 0 where there is none: nothing is bent then.
void gatherFragment(vec4 color, float depth, vec3 normal, out vec4 outputs[2])
{
  float behind = distanceAt(texelFetch(translucencyOpaqueDepth, ivec2(gl_FragCoord.xy), 0).r);
  float reach = max(behind - distanceAt(depth), 0.0);
  vec2 scale = backgroundScale.xy / (backgroundScale.z == 1.0 ? 1.0 : behind);
  vec2 shift = vec2(0.0);
  if (gatherBend.x > 1.0 && normal != vec3(0.0))
  {
    vec2 bend = bendAt(vec3(gl_FragCoord.xy * frameRays.xy + frameRays.zw, -1.0), normal, gatherBend.x);
    float entry = gl_FrontFacing ? gatherEntry : -gatherEntry;
    shift = bend * scale * (gatherBend.y > 0.0 ? gatherBend.y : entry * reach);
  }
  float blur = gatherBend.z * reach * sqrt(scale.x * scale.y);
  outputs[0] = vec4(shift, blur * blur, gatherBend.w * length(shift));
  outputs[1] = vec4(depth);
}
