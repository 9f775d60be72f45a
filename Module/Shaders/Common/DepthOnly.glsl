// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// DepthOnly.glsl: a fragment shader for draws of which only the depth test counts.
//
// Needs: nothing.  Gives: main.

void main()
{
}
