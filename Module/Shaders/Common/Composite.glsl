// Composite.glsl: the main function of the last stage of techniques without lists; the technique's file includes it last.
//
// It runs once a pixel, or a sample where the window has several. What it writes is blended over the opaque picture:
// colour + (1 - alpha) * opaque, where alpha is 1 - total transmittance.
//
// Needs: resolvePixel(pixel, color, transmittance), false where nothing is to be drawn.  Gives: main.

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
