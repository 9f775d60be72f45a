// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Shade.glsl: what a material does to a fragment that VTK has shaded (vtkTranslucencyMaterial): light that it gives
// off, and opacity by the angle at which it is seen.
//
// It stands in mappers' shaders, before the fragment is gathered. Props without a material have uniforms that change
// nothing.
//
// Needs: nothing.  Gives: shadeSurface, surfaceTransmission.
#ifndef Shade_glsl
#define Shade_glsl
#include "Common/Frame.glsl"

uniform vec3 gatherTransmission; // of the prop
uniform vec4 surfaceEmission;
uniform vec4 surfaceAngles; // opacity at grazing angles, the exponent to it, reflectance, 1 if there is any

// What the fragment transmits.
vec3 surfaceTransmission;

// Reflectance by angle (Schlick 1994, "An inexpensive BRDF model for physically-based rendering", Eq. 15).
float reflectanceAt(float cosine)
{
  float grazing = 1.0 - cosine;
  float square = grazing * grazing;
  return surfaceAngles.w * mix(square * square * grazing, 1.0, surfaceAngles.z);
}

// normal is of length 1, in eye coordinates; 0 where there is none: the surface then faces the viewer.
vec4 shadeSurface(vec4 color, vec3 normal)
{
  vec3 ray = normalize(vec3(gl_FragCoord.xy * frameRays.xy + frameRays.zw, -1.0));
  float cosine = normal == vec3(0.0) ? 1.0 : clamp(abs(dot(normal, ray)), 1e-6, 1.0);
  float opacity = mix(surfaceAngles.x, color.a, pow(cosine, surfaceAngles.y));
  float reflects = reflectanceAt(cosine);
  float whole = reflects + (1.0 - reflects) * opacity;
  // What is reflected is not transmitted.
  surfaceTransmission = gatherTransmission * ((1.0 - reflects) * opacity / max(whole, 1e-6));
  return vec4(color.rgb + surfaceEmission.rgb, whole);
}

#endif
