// CompositeSamples.glsl: one sample of what ABuffer/ResolveSamples.glsl has resolved.
//
// Needs: SAMPLES.
#include "Common/SampleColors.glsl"
#include "Common/Samples.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 taken = takeSample(pixel, resolveSample);
  color = taken.rgb;
  transmittance = 1.0 - taken.a;
  return taken != vec4(0.0);
}

#include "Common/Resolve.glsl"
