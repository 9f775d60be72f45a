// SampleColors.glsl: the resolved colours of a pixel's samples, on their way into the framebuffer.
//
// Four half floats each, multiplied by the opacity; all 0, which changes nothing when it is blended, until a resolve has written them
// and again after Common/CompositeSamples.glsl has taken them.
//
// Needs: SAMPLES.  Gives: storeSample, takeSample.
#ifndef SampleColors_glsl
#define SampleColors_glsl
#include "Common/Bindings.glsl"
#include "Common/Frame.glsl"
#include "Common/HalfFloat.glsl"

layout(std430, binding = STORAGE_BINDING_SAMPLES) buffer SampleColors
{
  uvec2 sampleColors[];
};

uint sampleIndex(ivec2 pixel, int index)
{
  ivec2 at = pixel - frameTile.xy;
  return uint((at.y * frameTile.z + at.x) * SAMPLES + index);
}

#if SAMPLES > 1
void storeSample(ivec2 pixel, int index, vec4 color)
{
  sampleColors[sampleIndex(pixel, index)] = packHalves(color);
}

vec4 takeSample(ivec2 pixel, int index)
{
  uint at = sampleIndex(pixel, index);
  vec4 color = unpackHalves(sampleColors[at]);
  sampleColors[at] = uvec2(0u);
  return color;
}
#endif

#endif
