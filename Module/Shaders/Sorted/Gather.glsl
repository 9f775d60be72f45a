// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sorted/Gather.glsl: a fragment's colour, multiplied by its opacity, as the over and under operators blend it.
//
// Where an object's back faces are drawn before its front faces, gatherPart is 1 for these, 2 for those and else 0
// (vtkTranslucencyFrame::Faces). Polygons are culled; lines and points, which can't be, count as front faces.
//
// The under operator multiplies with the alpha that is there: with three transmittances each channel has a target of
// its own.
//
// Needs: SORTED_TARGETS (1, or 3: one a channel), TRANSMITTANCE_CHANNELS.  Gives: gatherFragment.
#ifndef SORTED_TARGETS
#error "Sorted/Gather.glsl needs SORTED_TARGETS"
#endif
#include "Common/Opacity.glsl"
#if SORTED_TARGETS == 1
#include "Common/Over.glsl"
#endif

uniform int gatherPart;

void gatherFragment(vec4 color, float depth, out vec4 outputs[SORTED_TARGETS])
{
  if (gatherPart == (gl_FrontFacing ? 1 : 2))
  {
    discard;
  }
#if SORTED_TARGETS == 3
  vec3 opacity = opacityOf(color);
  outputs[0] = vec4(color.a * color.r, 0.0, 0.0, opacity.r);
  outputs[1] = vec4(color.a * color.g, 0.0, 0.0, opacity.g);
  outputs[2] = vec4(color.a * color.b, 0.0, 0.0, opacity.b);
#else
  outputs[0] = overOutput(color.a * color.rgb, opacityOf(color));
#endif
}
