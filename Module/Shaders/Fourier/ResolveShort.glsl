// Fourier/ResolveShort.glsl: the variable-memory form for short lists, see Absorbance/ResolveShort.glsl.
//
// Needs: FOURIER_COEFFICIENTS, and what that file needs.
#include "Fourier/Series.glsl"
#include "Absorbance/ResolveShort.glsl"
