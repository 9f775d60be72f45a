// Sorted/Resolve.glsl: what the under operator has gathered, front to back, over what lies behind:
//     colour += transmittance * opacity * colour of the fragment, then transmittance *= 1 - opacity
//
// Needs: TARGET_SAMPLES.
#include "Common/Target.glsl"

uniform Target sortedLayers;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 layers = fetchTarget(sortedLayers, pixel);
  color = layers.rgb;
  transmittance = layers.a;
  return transmittance < 1.0;
}

#include "Common/Composite.glsl"
