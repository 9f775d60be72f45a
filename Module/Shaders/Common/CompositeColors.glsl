// CompositeColors.glsl: the colours and the total transmittance that blending has added up and multiplied, over the opaque picture.
//
// Needs: TARGET_SAMPLES, TRANSMITTANCE_CHANNELS.
#include "Common/Channels.glsl"
#include "Common/Target.glsl"

uniform Target gatheredColors; // rgb: colour; a: total transmittance, of three channels that of red
#if TRANSMITTANCE_CHANNELS == 3
uniform Target gatheredGreens; // a: that of green
uniform Target gatheredBlues;
#endif

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  vec4 gathered = fetchTarget(gatheredColors, pixel);
  color = gathered.rgb;
#if TRANSMITTANCE_CHANNELS == 3
  transmittance = vec3(gathered.a, fetchTarget(gatheredGreens, pixel).a, fetchTarget(gatheredBlues, pixel).a);
#else
  transmittance = gathered.a;
#endif
  return color != vec3(0.0) || transmittance != Channels(1.0);
}

#include "Common/Composite.glsl"
