// Gather.glsl: what the mappers' shaders call for each translucent fragment.
//
// It stands where VTK has its depth peeling declarations; the call stands where VTK has shaded the fragment and discarded it
// if its opacity is 0.
//
// Needs: what the storage needs.  Gives: gatherFragment.
#ifndef Gather_glsl
#define Gather_glsl
#include "Common/Fragment.glsl"
#include "Storage/Selected.glsl"

void gatherFragment(vec4 color, float depth)
{
  storeFragment(ivec2(gl_FragCoord.xy), Fragment(depth, packColor(color)));
}

#endif
