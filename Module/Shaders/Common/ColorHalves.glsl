// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ColorHalves.glsl: a colour, and one number more of each channel, as half floats.
//
// Needs: TRANSMITTANCE_CHANNELS.  Gives: packColorHalves, unpackColorHalves.
#ifndef ColorHalves_glsl
#define ColorHalves_glsl
#include "Common/Channels.glsl"
#include "Common/HalfFloat.glsl"

PackedColor packColorHalves(vec3 color, Channels channels)
{
#if TRANSMITTANCE_CHANNELS == 3
  return uvec3(packHalves(vec4(color, channels.r)), packHalves(vec4(channels.gb, 0.0, 0.0)).x);
#else
  return packHalves(vec4(color, channels));
#endif
}

void unpackColorHalves(PackedColor words, out vec3 color, out Channels channels)
{
  vec4 first = unpackHalves(words.xy);
  color = first.rgb;
#if TRANSMITTANCE_CHANNELS == 3
  channels = vec3(first.a, unpackHalves(uvec2(words.z, 0u)).xy);
#else
  channels = first.a;
#endif
}

#endif
