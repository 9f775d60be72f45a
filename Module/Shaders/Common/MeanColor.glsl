// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// MeanColor.glsl: the mean of colours, weighted by their opacities, as opaque as all of them together: (1 -
// transmittance) * sum of opacity * colour / sum of opacities
//
// Where surfaces transmit colours they may add light to a channel and hide nothing of it. With the sum of opacities, (1
// - transmittance) / sum tends to 1: below SMALL_OPACITIES that is taken, off by less than half of that, since the
// difference of 1 and a transmittance is rounded.
//
// Needs: TRANSMITTANCE_CHANNELS.  Gives: meanColor.
#ifndef MeanColor_glsl
#define MeanColor_glsl
#include "Common/Channels.glsl"

#define SMALL_OPACITIES (1.0 / 1024.0)

// sum is that of opacity * colour.
vec3 meanColor(vec3 sum, Channels opacities, Channels transmittance)
{
#if TRANSMITTANCE_CHANNELS == 3
  return mix((1.0 - transmittance) * sum / max(opacities, SMALL_OPACITIES), sum,
    lessThan(opacities, vec3(SMALL_OPACITIES)));
#else
  return (1.0 - transmittance) * sum / max(opacities, 1e-30);
#endif
}

#endif
