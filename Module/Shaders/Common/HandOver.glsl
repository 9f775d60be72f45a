// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// HandOver.glsl: gives the fragments of one layer, drawn by shaders of others (vtkTranslucencyLayers), to what stands
// in mappers' shaders.
//
// It has the marks that VTK's mappers have in their shaders, and the same text goes there. Where the window is
// multi-sampled it runs once for each sample.
//
// Needs: HAND_OVER_SAMPLES, of a pixel of the layer.  Gives: main.
#ifndef HAND_OVER_SAMPLES
#error "HandOver.glsl needs HAND_OVER_SAMPLES"
#endif

#if HAND_OVER_SAMPLES > 1
uniform sampler2DMS layerColors;
uniform sampler2DMS layerDepths;
#define fetchLayer(layer) texelFetch(layer, ivec2(gl_FragCoord.xy), gl_SampleID)
#else
uniform sampler2D layerColors;
uniform sampler2D layerDepths;
#define fetchLayer(layer) texelFetch(layer, ivec2(gl_FragCoord.xy), 0)
#endif

//VTK::Output::Dec
//VTK::DepthPeeling::Dec

void main()
{
  vec4 color = fetchLayer(layerColors);
  if (color.a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = fetchLayer(layerDepths).r;
  //VTK::DepthPeeling::PreColor
  gl_FragData[0] = color;
  //VTK::DepthPeeling::Impl
}
