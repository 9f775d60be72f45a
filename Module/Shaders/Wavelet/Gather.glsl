// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Wavelet/Gather.glsl: the fixed-memory form, see Absorbance/Gather.glsl.
//
// Needs: WAVELET_RANK, and what that file needs.  Gives: gatherFragment.
#include "Wavelet/Haar.glsl"
#include "Absorbance/Gather.glsl"
