// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fragment.glsl: one translucent fragment, as the mappers shade it, the storage keeps it and the techniques read it.
//
// depth is the window depth, 0 at the near plane and 1 at the far plane. Half floats keep opacities far below 1/255 and
// colours above 1; bytes take half the room:
// - one channel, half floats or bytes: the colour, not multiplied by the opacity, and the opacity;
// - three channels, half floats: the colour, multiplied by the opacity, and the three opacities (Channels.glsl);
// - three channels, bytes: the colour, not multiplied by the opacity, the opacity, and the three opacities; the third
//   word is 0.
//
// Needs: COLOR_FORMAT (COLOR_FORMAT_HALF_FLOAT or COLOR_FORMAT_RGBA8), TRANSMITTANCE_CHANNELS.  Gives: Fragment,
// EMPTY_FRAGMENT, Surface, packColor, unpackColor.
#ifndef Fragment_glsl
#define Fragment_glsl
#include "Common/Channels.glsl"
#include "Common/ColorHalves.glsl"
#include "Common/Opacity.glsl"
#ifndef COLOR_FORMAT
#error "Fragment.glsl needs COLOR_FORMAT"
#endif

struct Fragment
{
  float depth;
  PackedColor color;
  uint coverage; // one bit a sample of the pixel
};

#define EMPTY_FRAGMENT(depth) Fragment(depth, PackedColor(0u), 0u)

// What a fragment adds to its pixel where nothing hides it, and what it hides.
struct Surface
{
  vec3 color; // multiplied by its opacity
  Channels opacity;
};

// color is as a mapper has shaded it.
PackedColor packColor(vec4 color)
{
#if TRANSMITTANCE_CHANNELS == 3
  vec3 opacity = opacityOf(color);
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  return uvec3(packUnorm4x8(color), packUnorm4x8(vec4(opacity, 0.0)), 0u);
#else
  return packColorHalves(color.a * color.rgb, opacity);
#endif
#elif COLOR_FORMAT == COLOR_FORMAT_RGBA8
  return uvec2(packUnorm4x8(color), 0u);
#else
  return packHalves(color);
#endif
}

Surface unpackColor(PackedColor words)
{
#if TRANSMITTANCE_CHANNELS == 3
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  vec4 color = unpackUnorm4x8(words.x);
  return Surface(color.a * color.rgb, unpackUnorm4x8(words.y).rgb);
#else
  Surface surface;
  unpackColorHalves(words, surface.color, surface.opacity);
  return surface;
#endif
#else
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  vec4 color = unpackUnorm4x8(words.x);
#else
  vec4 color = unpackHalves(words);
#endif
  return Surface(color.a * color.rgb, color.a);
#endif
}

#endif
