// Resolve.glsl: the main function of every resolve; the technique's file includes it last.
//
// What it writes is blended over the opaque picture: colour + (1 - alpha) * opaque, where alpha is 1 - total transmittance.
//
// Needs: resolvePixel(pixel, color, transmittance), false where a pixel holds nothing.  Gives: main.
#include "Common/Samples.glsl"
#include "Common/Statistics.glsl"

out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  bool drawn = inTile(pixel) && resolvePixel(pixel, color, transmittance);
  if (!samplesAgree())
  {
    leaveToLevel(pixel, LEVEL_SAMPLES);
    drawn = false;
  }
  if (!drawn)
  {
    discard;
  }
  fragOutput0 = vec4(color, 1.0 - transmittance);
}
