// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpacityShadowMap/Gather.glsl: the fixed-memory form, see Absorbance/Gather.glsl.
//
// Needs: SLICES, and what that file needs.  Gives: gatherFragment.
#include "OpacityShadowMap/Slices.glsl"
#include "Absorbance/Gather.glsl"
