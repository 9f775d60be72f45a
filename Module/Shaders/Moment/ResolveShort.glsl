// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/ResolveShort.glsl: the variable-memory form for short lists, see Absorbance/ResolveShort.glsl.
//
// Needs: MOMENT_BASIS, and what that file needs.
#include "Moment/Moments.glsl"
#include "Absorbance/ResolveShort.glsl"
