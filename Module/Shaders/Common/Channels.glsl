// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Channels.glsl: opacities and transmittances as they are told apart: one for all colours, or one for each of red,
// green and blue.
//
// A surface of opacity a and transmission colour t hides a * (1 - t) of what lies behind it and lets through the rest:
// a is how much of the pixel the surface covers, and t what the surface itself lets through (the coverage and
// transmission of McGuire and Mara 2017, "Phenomenological transparency"). Where no prop has a transmission colour, or
// the technique keeps one number, there is one channel, and nothing costs more.
//
// Valid C++, too.
//
// Needs: TRANSMITTANCE_CHANNELS (1 or 3), COLOR_FORMAT where fragments are packed.  Gives: Channels, a float or a vec3,
// meanOf, PackedColor, COLOR_FORMAT_HALF_FLOAT, COLOR_FORMAT_RGBA8.
#ifndef Channels_glsl
#define Channels_glsl
#ifndef TRANSMITTANCE_CHANNELS
#error "Channels.glsl needs TRANSMITTANCE_CHANNELS"
#endif

#if TRANSMITTANCE_CHANNELS == 3
#define Channels vec3
#else
#define Channels float
#endif

#if TRANSMITTANCE_CHANNELS == 3
float meanOf(vec3 channels)
{
  return dot(channels, vec3(1.0f / 3.0f));
}
#else
float meanOf(float channel)
{
  return channel;
}
#endif

#define COLOR_FORMAT_HALF_FLOAT 0
#define COLOR_FORMAT_RGBA8 1

// A fragment's colour and opacities as Common/Fragment.glsl packs them; 0 is a transparent one.
#if TRANSMITTANCE_CHANNELS == 3
#define PackedColor uvec3
#else
#define PackedColor uvec2
#endif

#endif
