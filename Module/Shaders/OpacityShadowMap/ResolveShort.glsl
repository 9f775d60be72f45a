// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpacityShadowMap/ResolveShort.glsl: the variable-memory form for short lists, see Absorbance/ResolveShort.glsl.
//
// Needs: SLICES, and what that file needs.
#include "OpacityShadowMap/Slices.glsl"
#include "Absorbance/ResolveShort.glsl"
