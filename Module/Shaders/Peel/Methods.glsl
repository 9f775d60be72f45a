// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/Methods.glsl: the values of PEEL_METHOD and of gatherStage, and what a pixel knows of the layers that are
// peeled.
//
// A pixel's bounds are the depths of the layers that are being peeled: (-nearest, farthest), of which peeling from the
// front alone has only the first. Both are the largest of their kind among the fragments that are left, so that one
// blending, GL_MAX, finds both (Bavoil and Myers 2008).
//
// Gives: PEEL_FRONT_TO_BACK, PEEL_DUAL, PEEL_STAGE_TAIL, NO_BOUNDS.
#ifndef Methods_glsl
#define Methods_glsl

#define PEEL_FRONT_TO_BACK 0
#define PEEL_DUAL 1

#define PEEL_STAGE_TAIL 1 // the stage that draws what was not peeled; 0 peels

// Where no fragment is left: nearest behind every depth, farthest in front. Shaders that set gl_FragDepth may pass 0
// and 1.
#define NO_BOUNDS vec4(-1e30, -1e30, 0.0, 0.0)

#endif
