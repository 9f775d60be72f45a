// Absorbance/Correct.glsl: weights that add up to what is hidden.
//
// With exact visibilities, the weights vis(z) * opacity of a pixel's fragments add up to 1 - total transmittance. ALPHA_CORRECTION 1 scales the colour
// so that those of approximate ones do, too (the alpha correction of Enderton et al. 2010, section 3.3). Where nothing is hidden nothing is scaled.
//
// Needs: ALPHA_CORRECTION, TRANSMITTANCE_CHANNELS.  Gives: correctedColor.
#ifndef Correct_glsl
#define Correct_glsl
#ifndef ALPHA_CORRECTION
#error "Absorbance/Correct.glsl needs ALPHA_CORRECTION"
#endif
#include "Common/Channels.glsl"

float correctionOf(float weights, float transmittance)
{
  return weights > 0.0 ? (1.0 - transmittance) / weights : 1.0;
}

#if TRANSMITTANCE_CHANNELS == 3
vec3 correctionOf(vec3 weights, vec3 transmittance)
{
  return vec3(correctionOf(weights.r, transmittance.r), correctionOf(weights.g, transmittance.g), correctionOf(weights.b, transmittance.b));
}
#endif

vec3 correctedColor(vec3 color, Channels weights, Channels transmittance)
{
#if ALPHA_CORRECTION
  return color * correctionOf(weights, transmittance);
#else
  return color;
#endif
}

#endif
