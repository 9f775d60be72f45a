// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/GatherLists.glsl: a fragment's colour goes to the target of its layer, if that is listed, and its depth into the
// buckets if not (LayerLists.glsl). Fragments of one depth are put over each other by blending, in the order of
// drawing.
//
// The tail is all that is left of a pixel that has given PEEL_LAYERS layers: the sums of opacity * colour and of
// opacity, and the product of 1 - opacity, in any order.
//
// Needs: PEEL_SIDES, PEEL_LAYERS (the most to peel, 0 for all), TARGET_SAMPLES.  Gives: rejectsFragment,
// gatherFragment; outputs 0 and 1: buckets, or in the tail the opacity; 2 to 7: listed layers, of which 2 is the
// tail's colour.
#ifndef PEEL_LAYERS
#error "Peel/GatherLists.glsl needs PEEL_LAYERS"
#endif
#include "Common/Target.glsl"
#include "Peel/LayerLists.glsl"
#include "Peel/Methods.glsl"

uniform int gatherStage;
uniform int peelDrawing;
uniform Target firstList;
uniform Target secondList;

// What has been peeled, or has no depth (not a number).
bool rejectsFragment(float depth)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool left = depth >= fetchTarget(firstList, pixel).a;
#if PEEL_SIDES == 2
  left = left && depth <= fetchTarget(secondList, pixel).a;
#elif PEEL_LAYERS > 0
  bool all = fetchTarget(secondList, pixel).a >= float(PEEL_LAYERS);
  left = left && all == (gatherStage == PEEL_STAGE_TAIL);
#endif
  return !left;
}

void gatherFragment(vec4 color, float depth, out vec4 outputs[PEEL_OUTPUTS])
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 layer = vec4(color.a * color.rgb, color.a);
  vec3 first = vec3(equal(fetchTarget(firstList, pixel).xyz, vec3(depth)));
  vec3 second = vec3(equal(fetchTarget(secondList, pixel).xyz, vec3(depth)));
  outputs[2] = first.x * layer;
  outputs[3] = first.y * layer;
  outputs[4] = first.z * layer;
  outputs[5] = second.x * layer;
  outputs[6] = second.y * layer;
  outputs[7] = second.z * layer;
  bucketsOf(depth, peelDrawing, outputs[0], outputs[1]);
  if (first + second != vec3(0.0))
  {
    outputs[0] = NOTHING;
    outputs[1] = NOTHING;
  }
  if (gatherStage == PEEL_STAGE_TAIL)
  {
    outputs[0] = vec4(color.a);
    outputs[2] = layer;
  }
}
