// Absorbance/Correct.glsl: weights that add up to what is hidden.
//
// With exact visibilities, the weights vis(z) * opacity of a pixel's fragments add up to 1 - total transmittance. ALPHA_CORRECTION 1 scales the colour
// so that those of approximate ones do, too (the alpha correction of Enderton et al. 2010, section 3.3).
//
// Needs: ALPHA_CORRECTION.  Gives: correctedColor.
#ifndef Correct_glsl
#define Correct_glsl
#ifndef ALPHA_CORRECTION
#error "Absorbance/Correct.glsl needs ALPHA_CORRECTION"
#endif

vec3 correctedColor(vec3 color, float weights, float transmittance)
{
#if ALPHA_CORRECTION
  return weights > 0.0 ? color * ((1.0 - transmittance) / weights) : color;
#else
  return color;
#endif
}

#endif
