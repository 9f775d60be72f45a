// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Order.glsl: which of two fragments is in front.
//
// The nearer one. Of two at the same depth, the one drawn later, as blending in drawing order would have it, where the
// driver keeps that order; elsewhere the order in which fragments arrive changes from run to run, and their contents
// decide: equal contents may be exchanged without a difference.
//
// Needs: FRAGMENT_ORDER (FRAGMENT_ORDER_DRAWN or FRAGMENT_ORDER_CONTENT), TRANSMITTANCE_CHANNELS.  Gives: inFront.
#ifndef Order_glsl
#define Order_glsl
#include "Common/Channels.glsl"
#ifndef FRAGMENT_ORDER
#error "Order.glsl needs FRAGMENT_ORDER"
#endif

#define BLOCK_EMPTY 2.0f // the depth of no fragment: behind every window depth

#define FRAGMENT_ORDER_DRAWN 0
#define FRAGMENT_ORDER_CONTENT 1

// age counts back from the fragment that was drawn last.
bool inFront(float depthA, PackedColor colorA, uint ageA, float depthB, PackedColor colorB, uint ageB)
{
#if FRAGMENT_ORDER == FRAGMENT_ORDER_DRAWN
  return depthA < depthB || (depthA == depthB && ageA < ageB);
#else
#if TRANSMITTANCE_CHANNELS == 3
  bool last = colorA.y == colorB.y && colorA.z < colorB.z;
#else
  bool last = false;
#endif
  bool content = colorA.x < colorB.x || (colorA.x == colorB.x && (colorA.y < colorB.y || last));
  return depthA < depthB || (depthA == depthB && content);
#endif
}

#endif
