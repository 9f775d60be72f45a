// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/Resolve.glsl: the variable-memory form, see Absorbance/Resolve.glsl.
//
// Needs: MOMENT_BASIS, and what that file needs.
#include "Moment/Moments.glsl"
#include "Absorbance/Resolve.glsl"
