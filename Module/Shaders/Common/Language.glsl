// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Language.glsl: what GLSL and C++ with GLM spell differently, so that the mathematics can be compiled as either.
//
// INOUT(type) name is a parameter that the function changes, OUT(type) name one that it sets.
#ifndef Language_glsl
#define Language_glsl

#ifdef __cplusplus
#define INOUT(type) type&
#define OUT(type) type&
#else
#define INOUT(type) inout type
#define OUT(type) out type
#endif

#endif
