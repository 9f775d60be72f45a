// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// LinearDepth.glsl: where a fragment lies between the clipping planes, in units of their distance: 0 at the near one, 1
// at the far one.
//
// Needs: nothing.  Gives: linearDepth.
#ifndef LinearDepth_glsl
#define LinearDepth_glsl
#include "Common/Frame.glsl"

// A perspective maps the distance z between near and far to the window depth f (z - n) / (z (f - n)).
float linearDepth(float depth)
{
  float near = frameClipping.x;
  float far = frameClipping.y;
  return depth * near / (far - depth * (far - near));
}

#endif
