// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Wavelet/Resolve.glsl: the variable-memory form, see Absorbance/Resolve.glsl.
//
// Needs: WAVELET_RANK, and what that file needs.
#include "Wavelet/Haar.glsl"
#include "Absorbance/Resolve.glsl"
