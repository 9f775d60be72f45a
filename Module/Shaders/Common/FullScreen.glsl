// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// FullScreen.glsl: a vertex shader: one triangle that covers the viewport, at the far plane.
//
// Needs: nothing.  Gives: main; three vertices, from gl_VertexID alone.

void main()
{
  vec2 corner = vec2((gl_VertexID & 1) * 2, (gl_VertexID >> 1) * 2);
  gl_Position = vec4(2.0 * corner - 1.0, 1.0, 1.0);
}
