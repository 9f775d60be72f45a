// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Gather.glsl: what the mappers' shaders call for each translucent fragment.
//
// It stands where VTK has its depth peeling declarations; the call stands where VTK has shaded the fragment and
// discarded it if its opacity is 0.
//
// Needs: MEDIA (1 where fragments carry what fills bodies), what the storage needs.  Gives: gatherFragment.
#ifndef Gather_glsl
#define Gather_glsl
#include "Common/Coverage.glsl"
#include "Common/Fragment.glsl"
#include "Common/Samples.glsl"
#include "Storage/Selected.glsl"
#if MEDIA
#include "Absorption/Medium.glsl"

uniform int gatherMedium; // vtkTranslucencyMedia::GetNumber

PackedColor packFragment(vec4 color)
{
  uint front = gl_FrontFacing ? uint(MEDIUM_FRONT) : 0u;
  uint medium = gatherMedium == 0 ? 0u : uint(gatherMedium) ^ front;
  return packColor(color) | mediumWords(medium);
}
#else
#define packFragment packColor
#endif

void gatherFragment(vec4 color, float depth)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depthExtent = fwidth(depth);
  // An invocation that covers nothing, since all its samples are hidden, must not get to what reads and writes there: a
  // driver may let it run without that, and undefined values spread to its neighbours (Documentation/Drivers.md).
  uint coverage = coveredSamples();
  if (inTile(pixel) && coverage != 0u)
  {
    storeFragment(pixel, Fragment(depth, packFragment(color), coverage), depthExtent);
  }
}

#endif
