// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/Show.glsl: what is drawn in place of the translucent colours: how well a pixel is drawn, or what that took.
// Grey, and opaque.
//
// Needs: SHOW, NODE_COUNT, TRANSMITTANCE_CHANNELS.  Gives: showPixel.
#ifndef Show_glsl
#define Show_glsl
#include "Common/Channels.glsl"
#ifndef SHOW
#error "Adaptive/Show.glsl needs SHOW"
#endif
#define SHOW_PICTURE 0
#define SHOW_ERROR 1
#define SHOW_NODES 2

#if SHOW == SHOW_ERROR
uniform float errorWhite; // the estimate that is white
#endif

// Of a pixel with that estimate and that many nodes in use.
void showPixel(float error, int nodes, out vec3 color, out Channels transmittance)
{
#if SHOW == SHOW_ERROR
  color = vec3(min(error / errorWhite, 1.0));
#else
  color = vec3(float(nodes) / 64.0);
#endif
  transmittance = Channels(0.0);
}

#endif
