// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// EachCell.glsl: the vertex shader of what runs once for each cell of a storage: a point as large as a pixel, from
// gl_VertexID alone. OpenGL's viewport has as many pixels as there are cells.
//
// Points, not a triangle that covers the viewport: a driver may cut that in two, and in a multi-sampled window shade a
// pixel along the edge between them for each. Multi-sampling is off, but zink can't turn it off.
//
// Needs: nothing.  Gives: main.
#include "Storage/CellGrid.glsl"

void main()
{
  ivec2 cells = ((frameTile.zw - 1) >> int(cellShift)) + 1;
  vec2 middle = vec2(gl_VertexID % cells.x, gl_VertexID / cells.x) + 0.5;
  gl_Position = vec4(2.0 * middle / vec2(cells) - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
