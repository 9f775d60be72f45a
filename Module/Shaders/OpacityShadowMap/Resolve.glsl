// OpacityShadowMap/Resolve.glsl: the variable-memory form, see Absorbance/Resolve.glsl.
//
// Needs: SLICES, and what that file needs.
#include "OpacityShadowMap/Slices.glsl"
#include "Absorbance/Resolve.glsl"
