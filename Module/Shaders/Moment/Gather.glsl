// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/Gather.glsl: the fixed-memory form, see Absorbance/Gather.glsl.
//
// Needs: MOMENT_BASIS, and what that file needs.  Gives: gatherFragment.
#include "Moment/Moments.glsl"
#include "Absorbance/Gather.glsl"
