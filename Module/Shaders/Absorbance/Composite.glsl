// Absorbance/Composite.glsl: a pixel's colour from the sums of weighted fragments (Gather.glsl, stage 2), and its exact total transmittance.
//
// Needs: ALPHA_CORRECTION, TARGET_SAMPLES.
#include "Absorbance/Correct.glsl"
#include "Common/Target.glsl"

uniform Target weightedColors;
uniform Target weightSums;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 sums = fetchTarget(weightedColors, pixel);
  transmittance = sums.a;
  color = correctedColor(sums.rgb, fetchTarget(weightSums, pixel).r, transmittance);
  return transmittance < 1.0;
}

#include "Common/Composite.glsl"
