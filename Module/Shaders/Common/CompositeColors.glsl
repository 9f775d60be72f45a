// CompositeColors.glsl: the colours and the total transmittance that blending has added up and multiplied, over the opaque picture.
//
// Needs: TARGET_SAMPLES.
#include "Common/Target.glsl"

uniform Target gatheredColors; // rgb: colour; a: total transmittance

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 gathered = fetchTarget(gatheredColors, pixel);
  color = gathered.rgb;
  transmittance = gathered.a;
  return gathered != vec4(0.0, 0.0, 0.0, 1.0);
}

#include "Common/Composite.glsl"
