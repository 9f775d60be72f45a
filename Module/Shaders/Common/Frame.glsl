// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Frame.glsl: what holds for the whole tile that is being drawn.
//
// They are plain uniforms: a block wants either a binding in its text or one for each program, which mappers make. VTK
// gives programs no vectors of integers.
//
// Gives: frameTile, the rectangle that is drawn now, in window pixels (x, y, width, height): the viewport, or a part of
// it when the viewport does not fit into the memory limit; frameClipping, the distances of the near and the far plane,
// or 1 and 1 where the projection is parallel; frameRays: in eye coordinates, the ray through a window pixel (x, y)
// goes into the direction (frameRays.x x + frameRays.z, frameRays.y y + frameRays.w, -1).
#ifndef Frame_glsl
#define Frame_glsl

uniform vec4 frameTileNumbers;
uniform vec4 frameClipping;
uniform vec4 frameRays;

#define frameTile ivec4(frameTileNumbers)

#endif
