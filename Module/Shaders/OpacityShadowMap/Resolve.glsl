// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpacityShadowMap/Resolve.glsl: the variable-memory form, see Absorbance/Resolve.glsl.
//
// Needs: SLICES, and what that file needs.
#include "OpacityShadowMap/Slices.glsl"
#include "Absorbance/Resolve.glsl"
