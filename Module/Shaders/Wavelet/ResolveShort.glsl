// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Wavelet/ResolveShort.glsl: the variable-memory form for short lists, see Absorbance/ResolveShort.glsl.
//
// Needs: WAVELET_RANK, and what that file needs.
#include "Wavelet/Haar.glsl"
#include "Absorbance/ResolveShort.glsl"
