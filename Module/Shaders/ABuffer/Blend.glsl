// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ABuffer/Blend.glsl: one fragment behind those already blended (Salvi 2011, Eq. 3, turned round: from front to back it
// is the same sum and gives the total transmittance too).
//
// Needs: COLOR_FORMAT, TRANSMITTANCE_CHANNELS.  Gives: blendBehind.
#ifndef Blend_glsl
#define Blend_glsl
#include "Common/Fragment.glsl"

void blendBehind(inout vec3 color, inout Channels transmittance, Surface surface)
{
  color += transmittance * surface.color;
  transmittance *= 1.0 - surface.opacity;
}

void blendBehind(inout vec3 color, inout Channels transmittance, PackedColor words)
{
  blendBehind(color, transmittance, unpackColor(words));
}

#endif
