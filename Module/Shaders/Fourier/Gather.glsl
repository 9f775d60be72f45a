// Fourier/Gather.glsl: the fixed-memory form, see Absorbance/Gather.glsl.
//
// Needs: FOURIER_COEFFICIENTS, and what that file needs.  Gives: gatherFragment.
#include "Fourier/Series.glsl"
#include "Absorbance/Gather.glsl"
