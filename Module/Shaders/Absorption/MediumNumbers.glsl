// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// MediumNumbers.glsl: the bits of what a fragment carries of a body, shared by the shaders and vtkTranslucencyMedia.
#ifndef MediumNumbers_glsl
#define MediumNumbers_glsl

#define MOST_MEDIA 31     // numbers 1 to 31
#define MEDIUM_FRONT 32   // a front face: where a ray enters the body

#endif
