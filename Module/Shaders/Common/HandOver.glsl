// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// HandOver.glsl: gives the fragments of one layer, drawn by shaders of others (vtkTranslucencyLayers), to what stands
// in mappers' shaders.
//
// It has the marks that VTK's mappers have in their shaders, and the same text goes there. The layer is a target like
// any other.
//
// Needs: TARGET_SAMPLES, SHADES_SAMPLES.  Gives: main.
#include "Common/Target.glsl"

uniform Target layerColors;
uniform Target layerDepths;

//VTK::Output::Dec
//VTK::DepthPeeling::Dec

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 color = fetchTarget(layerColors, pixel);
  if (color.a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = fetchTarget(layerDepths, pixel).r;
  //VTK::DepthPeeling::PreColor
  gl_FragData[0] = color;
  //VTK::DepthPeeling::Impl
}
