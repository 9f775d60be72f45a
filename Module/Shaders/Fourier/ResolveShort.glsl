// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fourier/ResolveShort.glsl: the variable-memory form for short lists, see Absorbance/ResolveShort.glsl.
//
// Needs: FOURIER_COEFFICIENTS, and what that file needs.
#include "Fourier/Series.glsl"
#include "Absorbance/ResolveShort.glsl"
