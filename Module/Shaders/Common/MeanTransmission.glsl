// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// MeanTransmission.glsl: the transmission colour of a prop, for techniques that keep one transmittance.
//
// The fragment hides what it hides on average of red, green and blue, and adds the light that it adds. The opacity
// stays above 0, where an emitting fragment could not be told from none: 1/1024 of the opacity is hidden at least.
//
// Needs: SHADES_SURFACES.  Gives: meanTransmission.
#ifndef MeanTransmission_glsl
#define MeanTransmission_glsl

#if SHADES_SURFACES
#include "Surface/Shade.glsl"
#define meanOfTransmission surfaceTransmission
#else
uniform vec3 gatherTransmission;
#define meanOfTransmission gatherTransmission
#endif

vec4 meanTransmission(vec4 color)
{
  float hides = max(1.0 - dot(meanOfTransmission, vec3(1.0 / 3.0)), 1.0 / 1024.0);
  return vec4(color.rgb / hides, color.a * hides);
}

#endif
