// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// GatherVolume.glsl: what VTK's ray caster calls: a ray is cast from fragment to fragment of its pixel, and what each
// segment gathers is stored as a fragment between the two.
//
// The pixel's list is in front-to-back order and stays so: a segment is put behind the fragment at which it begins. The
// ray's samples lie where they lie without surfaces, and each belongs to one segment: surfaces of opacity 0 would not
// change the picture.
//
// Nobody else may be at the list. Between volumes, and between the blocks of one, the application waits
// (vtkTranslucencyVolumes). Of the front faces of one box, no two cover the same sample, but with several samples a
// pixel two triangles share the pixels along an edge, each with a ray for the samples that it covers. Where fragments
// of a pixel come in any order the volume is drawn once for each sample: a fragment casts its ray in the round of the
// first sample that it covers, which is another one for each fragment of the pixel. A lock would have to be held around
// the whole ray, and an interlock is not everywhere.
//
// Needs: what the storage needs; RAY_FINDS_VALUES (1: isosurfaces, found between a sample and the one before it),
// RAY_MEETS_PLANE (1: the ray has one sample, on a plane); the ray caster's declarations.
// Gives: startSegments, SET_RAY_END (where the ray caster knows its ray), nextSegment(front, back),
// START_RAY(front, back), storeSegment(color).
#ifndef GatherVolume_glsl
#define GatherVolume_glsl
#include "Common/Gather.glsl"
#include "Common/Order.glsl"

#define NO_FRAGMENT 0u

uniform int gathersVolume; // 0 where the ray caster does not draw into the picture: pixels are others there
#if SAMPLES > 1 && FRAGMENT_ORDER != FRAGMENT_ORDER_DRAWN
uniform int gatherRound;
#endif

vec4 WindowToNDC(const float xCoord, const float yCoord, const float zCoord); // the ray caster's

bool segmentsLeft;
uint segmentAfter; // the fragment at which it begins,
uint segmentBefore; // at which it ends,
uint segmentRest; // and the first one behind that
float segmentFront;
float segmentBack;
float rayEnd; // in samples from the first one

// Of the ray caster's own number, so that a sample that lies at the end, to rounding, is one here if it is one there.
#define SET_RAY_END() rayEnd = g_terminatePointMax

bool isOfRound()
{
#if SAMPLES > 1 && FRAGMENT_ORDER != FRAGMENT_ORDER_DRAWN
  return findLSB(coveredSamples()) == gatherRound;
#else
  return true;
#endif
}

void startSegments()
{
  segmentsLeft = gathersVolume != 0 && isOfRound() && inTile(ivec2(gl_FragCoord.xy));
  segmentBefore = NO_FRAGMENT;
  segmentRest = segmentsLeft ? firstFragment(ivec2(gl_FragCoord.xy)) : NO_FRAGMENT;
  segmentBack = gl_FragCoord.z; // where the ray enters the volume
}

// The next part of the ray: between which window depths it lies. False if there is none.
bool nextSegment(out float front, out float back)
{
  bool found = false;
  segmentFront = segmentBack;
  while (segmentsLeft && !found)
  {
    segmentAfter = segmentBefore;
    segmentBefore = segmentRest;
    segmentsLeft = segmentRest != NO_FRAGMENT;
    float depth = 1.0;
    if (segmentsLeft)
    {
      depth = loadNode(segmentRest, segmentRest).depth;
    }
    found = depth > segmentFront;
    segmentBack = max(depth, segmentFront);
  }
  front = segmentFront;
  back = segmentBack;
  return found;
}

// Where the ray caster takes the first sample and the last one, or the only one, and how far two lie apart. It has them
// in globals, which it sets in functions of its own, further down: who reads them up here draws a compiler's warning.
struct SampledRay
{
  vec3 first;
  vec3 step;
  vec3 last;
};

#if RAY_MEETS_PLANE
#define SAMPLED_RAY SampledRay(g_rayOrigin, g_dirStep, g_intersection)
#else
#define SAMPLED_RAY SampledRay(g_rayOrigin, g_dirStep, g_rayTermination)
#endif

// How far along the ray a position lies, in samples from the first one.
float samplesTo(SampledRay ray, vec3 position)
{
  return dot(position - ray.first, ray.step) / dot(ray.step, ray.step);
}

// The same of a window depth.
float samplesBefore(SampledRay ray, float depth)
{
  vec4 point = ip_inverseTextureDataAdjusted * in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix *
    in_inverseProjectionMatrix *
    WindowToNDC(gl_FragCoord.x, gl_FragCoord.y, depth);
  return samplesTo(ray, point.xyz / point.w);
}

// Puts the ray caster at the first sample of a segment. False if no sample lies in it.
#define START_RAY(front, back) startRay(SAMPLED_RAY, front, back)
bool startRay(SampledRay ray, float front, float back)
{
  float first = front <= gl_FragCoord.z ? 0.0 : max(0.0, ceil(samplesBefore(ray, front)));
#if RAY_FINDS_VALUES
  first = max(0.0, first - 1.0);
#endif
  g_fragColor = vec4(0.0);
  g_exit = false;
  g_dataPos = ray.first + first * ray.step;
  g_currentT = 0.0;
#if RAY_MEETS_PLANE
  float plane = samplesTo(ray, ray.last);
  return plane >= first && (segmentBefore == NO_FRAGMENT || plane < ceil(samplesBefore(ray, back)));
#else
  // Of the ray's last segment the ray caster knows the end: what is opaque, a clipping plane, or the volume's far side.
  float toEnd = rayEnd - first;
  float samples = segmentBefore == NO_FRAGMENT ? toEnd + 1.0 : min(ceil(samplesBefore(ray, back)) - first, toEnd + 1.0);
  g_terminatePointMax = samples - 1.0; // it takes a sample before it looks
  // The ray caster takes the first sample of a ray without looking, too.
  bool outside = any(greaterThan(max(ray.step, vec3(0.0)) * (g_dataPos - in_texMax[0]), vec3(0.0))) ||
    any(greaterThan(min(ray.step, vec3(0.0)) * (g_dataPos - in_texMin[0]), vec3(0.0)));
  return samples > 0.0 && (first == 0.0 || !outside);
#endif
}

// Puts a fragment behind another one of the pixel, or before all. Nobody else is at the list.
void insertFragment(ivec2 pixel, uint after, Fragment fragment)
{
  uint counter = counterOf(pixel);
  uint place = takePlace(counter);
  COUNT_STORE(counter);
  if (place != NO_PLACE)
  {
    if (after == NO_FRAGMENT)
    {
      setFirstFragment(pixel, storeLinked(place, firstFragment(pixel), fragment));
    }
    else
    {
      uint next;
      loadNode(after, next);
      linkNode(after, storeLinked(place, next, fragment));
    }
  }
}

// color is multiplied by its opacity. Volumes have no transmission colour.
void storeSegment(vec4 color)
{
  if (color.a > 0.0)
  {
    vec4 straight = vec4(color.rgb / color.a, min(color.a, 1.0));
    insertFragment(ivec2(gl_FragCoord.xy), segmentAfter,
      Fragment(0.5 * (segmentFront + segmentBack), packColor(straight), coveredSamples()));
  }
}

#endif
