// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/MergeLists.glsl: puts the listed layers behind those that have been peeled from the front, and in front of those
// from the back, as far as no fragment lies between that was not listed; and lists the next ones (LayerLists.glsl).
//
// Why nothing is lost: the nearest depth that was not listed is in the buckets. Listed layers in front of it are all
// that is left in front of it. The others stay among those that can be listed, as do all depths in the buckets.
//
// Needs: PEEL_SIDES, PEEL_LAYERS (the most to peel, 0 for all), TARGET_SAMPLES.  Gives: main.
#ifndef PEEL_LAYERS
#error "Peel/MergeLists.glsl needs PEEL_LAYERS"
#endif
#include "Common/Target.glsl"
#include "Peel/LayerLists.glsl"

uniform Target firstBuckets;
uniform Target secondBuckets;
uniform Target listed0; // the layers, as they are listed
uniform Target listed1;
uniform Target listed2;
uniform Target listed3;
uniform Target listed4;
uniform Target listed5;
uniform Target firstList; // the state before
uniform Target secondList;
uniform Target frontLayers;
uniform Target backLayers;
layout(location = 0) out vec4 fragOutput0; // the state afterwards: front layers
layout(location = 1) out vec4 fragOutput1; // back layers
layout(location = 2) out vec4 fragOutput2; // the first list
layout(location = 3) out vec4 fragOutput3; // the second list

vec4 front;
vec4 back;
float peeled;
float nearestUnlisted;
float farthestUnlisted;

// Of the depths that are left: the nearest ones, nearest first; and the farthest ones, negative, farthest first.
vec3 nearest;
vec3 next; // behind the nearest: the last three of six with PEEL_SIDES 1
vec3 farthest;
float end; // the farthest of all

// Puts a number into an ascending list of three, unless it is in it. What falls out of it becomes the number.
void insert(inout vec3 list, inout float number)
{
  bool known = any(equal(list, vec3(number)));
  float given = known ? NO_DEPTH : number;
  vec3 larger = max(list, vec3(given));
  number = larger.z;
  list = vec3(min(list.x, given), min(list.y, max(list.x, given)), min(list.z, max(list.y, given)));
}

void leave(float depth)
{
  if (depth < NO_DEPTH)
  {
    float other = depth;
    insert(nearest, other);
#if PEEL_SIDES == 2
    other = -depth;
    insert(farthest, other);
#else
    insert(next, other);
#endif
    end = max(end, depth);
  }
}

void mergeFront(float depth, vec4 layer)
{
  bool more = PEEL_LAYERS == 0 || peeled < float(PEEL_LAYERS);
  if (depth < nearestUnlisted && more)
  {
    front = vec4(front.rgb + front.a * layer.rgb, front.a * (1.0 - layer.a));
    peeled += 1.0;
  }
  else
  {
    leave(depth);
  }
}

void mergeBack(float depth, vec4 layer)
{
  if (depth > farthestUnlisted && depth < NO_DEPTH)
  {
    back = layer + (1.0 - layer.a) * back;
  }
  else
  {
    leave(depth);
  }
}

// Of a bucket: minus its nearest depth.
void leaveNearest(float negative)
{
  leave(negative > -NO_DEPTH ? -negative : NO_DEPTH);
}

// Of a bucket: its farthest depth.
void leaveFarthest(float depth)
{
  leave(depth > -NO_DEPTH ? depth : NO_DEPTH);
}

void leaveBuckets(vec4 held)
{
  leaveNearest(held.x);
  leaveNearest(held.z);
#if PEEL_SIDES == 2
  leaveFarthest(held.y);
  leaveFarthest(held.w);
#else
  leaveNearest(held.y);
  leaveNearest(held.w);
#endif
}

float largest(vec2 numbers)
{
  return max(numbers.x, numbers.y);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 buckets = fetchTarget(firstBuckets, pixel);
  vec4 more = fetchTarget(secondBuckets, pixel);
  vec4 first = fetchTarget(firstList, pixel);
  vec4 second = fetchTarget(secondList, pixel);
  if (first.a >= DONE_TWICE)
  {
    discard;
  }
  front = fetchTarget(frontLayers, pixel);
  back = fetchTarget(backLayers, pixel);
  peeled = PEEL_SIDES == 2 ? 0.0 : second.a;
  nearest = vec3(NO_DEPTH);
  next = vec3(NO_DEPTH);
  farthest = vec3(NO_DEPTH);
  end = -NO_DEPTH;

#if PEEL_SIDES == 2
  nearestUnlisted = -largest(max(buckets.xz, more.xz));
  farthestUnlisted = largest(max(buckets.yw, more.yw));
#else
  vec4 most = max(buckets, more);
  nearestUnlisted = -largest(max(most.xy, most.zw));
#endif
  mergeFront(first.x, fetchTarget(listed0, pixel));
  mergeFront(first.y, fetchTarget(listed1, pixel));
  mergeFront(first.z, fetchTarget(listed2, pixel));
#if PEEL_SIDES == 2
  mergeBack(second.x, fetchTarget(listed3, pixel));
  mergeBack(second.y, fetchTarget(listed4, pixel));
  mergeBack(second.z, fetchTarget(listed5, pixel));
  leaveBuckets(buckets);
  leaveBuckets(more);
  // What is in both lists is the first one's.
  vec3 depths = -farthest;
  next = mix(vec3(NO_DEPTH), depths, greaterThan(depths, vec3(nearest.z)));
  fragOutput3 = vec4(next, end);
#else
  mergeFront(second.x, fetchTarget(listed3, pixel));
  mergeFront(second.y, fetchTarget(listed4, pixel));
  mergeFront(second.z, fetchTarget(listed5, pixel));
  leaveBuckets(buckets);
  leaveBuckets(more);
  fragOutput3 = vec4(next, peeled);
#endif
  fragOutput0 = front;
  fragOutput1 = back;
  // What is done is written once more, to the other state, and then left alone.
  fragOutput2 = vec4(nearest, first.a >= NO_DEPTH ? DONE_TWICE : nearest.x);
}
