// Resolve.glsl: the main function of every resolve; the technique's file includes it last.
//
// What it writes is blended over the opaque picture: colour + (1 - alpha) * opaque, where alpha is 1 - total transmittance.
//
// A shader can't write different colours to the samples of a pixel: where they differ, they wait in sampleColors for
// Common/CompositeSamples.glsl.
//
// Needs: resolvePixel(pixel, color, transmittance), false where a pixel holds nothing.  Gives: main.
#include "Common/SampleColors.glsl"
#include "Common/Samples.glsl"
#include "Common/Statistics.glsl"

out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  bool drawn = inTile(pixel) && resolvePixel(pixel, color, transmittance);
#if SAMPLES > 1
  if (drawn && resolveSample >= 0)
  {
    storeSample(pixel, resolveSample, vec4(color, 1.0 - transmittance));
    leaveToLevel(pixel, LEVEL_SAMPLES);
    drawn = false;
  }
#endif
  if (!drawn || !samplesAgree())
  {
    discard;
  }
  fragOutput0 = vec4(color, 1.0 - transmittance);
}
