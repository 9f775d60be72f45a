// Gather.glsl: what the mappers' shaders call for each translucent fragment.
//
// It stands where VTK has its depth peeling declarations; the call stands where VTK has shaded the fragment and discarded it
// if its opacity is 0.
//
// Needs: what the storage needs.  Gives: gatherFragment.
#ifndef Gather_glsl
#define Gather_glsl
#include "Common/Fragment.glsl"
#include "Common/Samples.glsl"
#include "Storage/Selected.glsl"

// The samples that the primitive covers and that pass the depth test.
uint coveredSamples()
{
#if SAMPLES > 1
  return uint(gl_SampleMaskIn[0]) & ALL_SAMPLES;
#else
  return ALL_SAMPLES;
#endif
}

void gatherFragment(vec4 color, float depth)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depthExtent = fwidth(depth);
  if (inTile(pixel))
  {
    storeFragment(pixel, Fragment(depth, packColor(color), coveredSamples()), depthExtent);
  }
}

#endif
