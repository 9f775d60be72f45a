// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Weighted/Methods.glsl: the values of WEIGHTED_METHOD.
#ifndef Methods_glsl
#define Methods_glsl

#define WEIGHTED_SUM 0
#define WEIGHTED_AVERAGE 1
#define WEIGHTED_BLENDED 2

#endif
