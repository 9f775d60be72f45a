// Resolve.glsl: the main function of every resolve; the technique's file includes it last.
//
// What it writes is blended over the opaque picture: colour + (1 - alpha) * opaque, where alpha is 1 - total transmittance.
//
// Needs: resolvePixel(pixel, color, transmittance), false where a pixel holds nothing.  Gives: main.

out vec4 fragOutput0;

void main()
{
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  if (!resolvePixel(ivec2(gl_FragCoord.xy), color, transmittance))
  {
    discard;
  }
  fragOutput0 = vec4(color, 1.0 - transmittance);
}
