// CompositeSamples.glsl: the samples of which the colours wait in sampleColors, each in an invocation of its own.
//
// Needs: SAMPLES.
#include "Common/SampleColors.glsl"
#include "Common/Samples.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 taken = takeSample(pixel, gl_SampleID);
  color = taken.rgb;
  transmittance = 1.0 - taken.a;
  return taken != vec4(0.0);
}

#include "Common/Resolve.glsl"
