// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Opacity.glsl: what a fragment hides, from the colour that a mapper has shaded and the prop's transmission colour
// (Channels.glsl).
//
// Needs: TRANSMITTANCE_CHANNELS, SHADES_SURFACES.  Gives: opacityOf.
#ifndef Opacity_glsl
#define Opacity_glsl
#include "Common/Channels.glsl"

#if TRANSMITTANCE_CHANNELS == 3
#if SHADES_SURFACES
#include "Surface/Shade.glsl"
#define gatheredTransmission surfaceTransmission
#else
uniform vec3 gatherTransmission;
#define gatheredTransmission gatherTransmission
#endif

Channels opacityOf(vec4 color)
{
  return color.a * (1.0 - gatheredTransmission);
}
#else
Channels opacityOf(vec4 color)
{
  return color.a;
}
#endif

#endif
