// ABuffer/Blend.glsl: one fragment behind those already blended (Salvi 2011, Eq. 3, turned round: from front to back it is the
// same sum and gives the total transmittance too).
//
// Needs: COLOR_FORMAT.  Gives: blendBehind.
#ifndef Blend_glsl
#define Blend_glsl
#include "Common/Fragment.glsl"

void blendBehind(inout vec3 color, inout float transmittance, vec4 fragment)
{
  color += transmittance * fragment.a * fragment.rgb;
  transmittance *= 1.0 - fragment.a;
}

void blendBehind(inout vec3 color, inout float transmittance, uvec2 words)
{
  blendBehind(color, transmittance, unpackColor(words));
}

#endif
