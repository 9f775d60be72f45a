// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Frame.glsl: what holds for the whole tile that is being drawn.
//
// Gives: frameTile, the rectangle that is drawn now, in window pixels (x, y, width, height): the viewport, or a part of
// it when the viewport does not fit into the memory limit; frameClipping, the distances of the near and the far plane,
// or 1 and 1 where the projection is parallel.
#ifndef Frame_glsl
#define Frame_glsl
#include "Common/Bindings.glsl"

layout(std140, binding = UNIFORM_BINDING_FRAME) uniform TranslucencyFrame
{
  ivec4 frameTile;
  vec4 frameClipping;
};

#endif
