// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/Gather.glsl: takes the layers off whose depths the drawing before has found, and finds the depths of the next
// ones.
//
// One drawing does both, as in dual depth peeling (Bavoil and Myers 2008). Of the fragments between the bounds, those
// that are as near as the nearest give their colours to the front layer, and those as far as the farthest to the back
// layer; all others are left for the next drawings, and the nearest and the farthest of them become the bounds of the
// next. Fragments in front of the bounds or behind them have been peeled. All fragments of a layer's depth belong to
// it: blending puts them over each other, in the order of drawing.
//
// The tail is all that is between the bounds after the last layer: the sums of opacity * colour and of opacity, and the
// product of 1 - opacity, in any order.
//
// Needs: PEEL_METHOD, TARGET_SAMPLES.  Gives: rejectsFragment, gatherFragment; outputs 0: bounds, or in the tail the
// opacity, 1: front layer, or the tail's colour, 2: back layer.
#ifndef PEEL_METHOD
#error "Peel/Gather.glsl needs PEEL_METHOD"
#endif
#include "Common/Target.glsl"
#include "Peel/Methods.glsl"

#if PEEL_METHOD == PEEL_DUAL
#define PEEL_OUTPUTS 3
#else
#define PEEL_OUTPUTS 2
#endif

uniform int gatherStage;
uniform Target peelBounds;

// What has been peeled, or has no depth (not a number).
bool rejectsFragment(float depth)
{
  vec2 bounds = fetchTarget(peelBounds, ivec2(gl_FragCoord.xy)).rg;
  bool left = depth >= -bounds.x;
#if PEEL_METHOD == PEEL_DUAL
  left = left && depth <= bounds.y;
#endif
  return !left;
}

void gatherFragment(vec4 color, float depth, out vec4 outputs[PEEL_OUTPUTS])
{
  vec2 bounds = fetchTarget(peelBounds, ivec2(gl_FragCoord.xy)).rg;
  bool tail = gatherStage == PEEL_STAGE_TAIL;
  bool nearest = depth == -bounds.x;
#if PEEL_METHOD == PEEL_DUAL
  bool farthest = depth == bounds.y && !nearest;
#else
  bool farthest = false;
#endif
  vec4 layer = vec4(color.a * color.rgb, color.a);
  outputs[0] = tail ? vec4(color.a) : nearest || farthest ? NO_BOUNDS : vec4(-depth, depth, 0.0, 0.0);
  outputs[1] = tail || nearest ? layer : vec4(0.0);
#if PEEL_METHOD == PEEL_DUAL
  outputs[2] = farthest && !tail ? layer : vec4(0.0);
#endif
}
