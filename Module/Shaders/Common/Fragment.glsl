// Fragment.glsl: one translucent fragment, as the mappers shade it, the storage keeps it and the techniques read it.
//
// depth is the window depth, 0 at the near plane and 1 at the far plane. The colour is packed, not multiplied by its
// opacity: half floats keep opacities far below 1/255 and colours above 1; RGBA8 takes half the room.
//
// Needs: COLOR_FORMAT (COLOR_FORMAT_HALF_FLOAT or COLOR_FORMAT_RGBA8).  Gives: Fragment, EMPTY_FRAGMENT, packColor, unpackColor.
#ifndef Fragment_glsl
#define Fragment_glsl
#include "Common/HalfFloat.glsl"
#ifndef COLOR_FORMAT
#error "Fragment.glsl needs COLOR_FORMAT"
#endif

#define COLOR_FORMAT_HALF_FLOAT 0
#define COLOR_FORMAT_RGBA8 1

struct Fragment
{
  float depth;
  uvec2 color;
  uint coverage; // one bit a sample of the pixel
};

#define EMPTY_FRAGMENT(depth) Fragment(depth, uvec2(0u), 0u)

uvec2 packColor(vec4 color)
{
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  return uvec2(packUnorm4x8(color), 0u);
#else
  return packHalves(color);
#endif
}

vec4 unpackColor(uvec2 words)
{
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  return unpackUnorm4x8(words.x);
#else
  return unpackHalves(words);
#endif
}

#endif
