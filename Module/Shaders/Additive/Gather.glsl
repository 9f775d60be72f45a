// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Additive/Gather.glsl: what a fragment adds to its pixel: opacity * colour. Blending sums it up, in any order.
//
// Gives: gatherFragment.

void gatherFragment(vec4 color, float depth, out vec4 outputs[1])
{
  outputs[0] = vec4(color.a * color.rgb, color.a);
}
