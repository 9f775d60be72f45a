// OpacityShadowMap/ResolveShort.glsl: the variable-memory form for short lists, see Absorbance/ResolveShort.glsl.
//
// Needs: SLICES, and what that file needs.
#include "OpacityShadowMap/Slices.glsl"
#include "Absorbance/ResolveShort.glsl"
