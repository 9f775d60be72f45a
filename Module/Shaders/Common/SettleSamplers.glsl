// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SettleSamplers.glsl: a fragment shader of which no fragment is drawn, for what its samplers leave behind: see
// vtkTranslucencySamplers.h. No resolve has more texel buffers.
//
// Needs: nothing.  Gives: main.
uniform sampler2D settledFirst;
uniform sampler2D settledSecond;

out vec4 settledColor;

void main()
{
  settledColor = texelFetch(settledFirst, ivec2(0), 0) + texelFetch(settledSecond, ivec2(0), 0);
}
