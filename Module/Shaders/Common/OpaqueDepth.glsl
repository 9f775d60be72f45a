// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpaqueDepth.glsl: the depth test of shaders that set gl_FragDepth.
//
// Their fragments can't be tested before they are shaded, and a later test would come after the fragment was stored.
//
// Needs: nothing.  Gives: behindOpaque.
#ifndef OpaqueDepth_glsl
#define OpaqueDepth_glsl
uniform sampler2D translucencyOpaqueDepth;

// Passes equal depths, as VTK's GL_LEQUAL does; the depth buffer holds depths rounded to 24 bits or finer.
bool behindOpaque(float depth)
{
  const float halfStep = 0.5 / 16777215.0;
  return depth > texelFetch(translucencyOpaqueDepth, ivec2(gl_FragCoord.xy), 0).r + halfStep;
}

#endif
