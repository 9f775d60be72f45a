// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Fourier/Gather.glsl: the fixed-memory form, see Absorbance/Gather.glsl.
//
// Needs: FOURIER_COEFFICIENTS, and what that file needs.  Gives: gatherFragment.
#include "Fourier/Series.glsl"
#include "Absorbance/Gather.glsl"
