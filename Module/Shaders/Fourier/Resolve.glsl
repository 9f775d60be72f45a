// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fourier/Resolve.glsl: the variable-memory form, see Absorbance/Resolve.glsl.
//
// Needs: FOURIER_COEFFICIENTS, and what that file needs.
#include "Fourier/Series.glsl"
#include "Absorbance/Resolve.glsl"
