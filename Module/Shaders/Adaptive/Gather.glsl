// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/Gather.glsl: adaptive transparency in fixed memory (Salvi 2011, section 4): the visibility function of a
// pixel lies in its record, NODE_COUNT nodes of a depth and a transmittance (Record.glsl).
//
// Stage 0 inserts each fragment into it. Stage 1 draws the geometry again and weights each fragment with what the
// function lets through before it (Eq. 2); blending adds that up and multiplies the total transmittance, with three
// channels in the alphas of three targets, whose colours are what Common/AlphaCorrection.glsl takes. Weights are added
// where nodes were removed only: elsewhere nothing is to be corrected. Where records lie in colours, they hold the
// sums, too.
//
// Coincident fragments each have a node of their depth; the one drawn first has the last of them, and is hidden by the
// others. When it has been weighted its node moves just behind that depth, so that the next fragment finds its own.
// That takes the same order in both stages, and the record is written only where several nodes have the depth.
//
// In a multi-sampled window the shader runs once for each sample, whose function it changes.
//
// Needs: NODE_COUNT, NODE_REMOVAL, ESTIMATE_ERROR, ALPHA_CORRECTION, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives:
// gatherFragment, GATHER_OUTPUTS.
#ifndef ALPHA_CORRECTION
#error "Adaptive/Gather.glsl needs ALPHA_CORRECTION"
#endif
#define INSERTED_AS_DRAWN 1
#include "Adaptive/Record.glsl"
#include "Adaptive/Weigh.glsl"
#include "Common/Opacity.glsl"
#include "Common/Tile.glsl"

uniform int gatherStage;

#if RECORD_TARGETS
#define GATHER_OUTPUTS 0
#elif TRANSMITTANCE_CHANNELS == 3
#define GATHER_OUTPUTS 3
#else
#define GATHER_OUTPUTS (1 + ALPHA_CORRECTION)
#endif

void loadDepths(PixelRecord record, uint count, inout Visibility visibility)
{
#define LOAD_DEPTH(k) \
  if (uint(k) < count) \
  { \
    visibility.z[k] = recordFloat(record, RECORD_DEPTH + (k)); \
  }
  EACH_NODE(LOAD_DEPTH)
}

void loadTransmittances(PixelRecord record, uint count, inout Visibility visibility)
{
  Channels last = Channels(1.0); // of nodes that are not in use, the total transmittance
  vec2 pair = vec2(1.0);
  EACH_NODE(LOAD_TRANSMITTANCE)
  visibility.t[NODE_COUNT] = last;
#if ESTIMATE_ERROR
  if (count > 0u)
  {
    visibility.lost = recordFloat(record, RECORD_LOST);
    visibility.nearest = recordFloat(record, RECORD_NEAREST);
    visibility.farthest = recordFloat(record, RECORD_FARTHEST);
  }
#endif
}

void storeVisibility(PixelRecord record, uint count, Visibility visibility)
{
#define STORE(k) \
  if (uint(k) < count) \
  { \
    setRecordFloat(record, RECORD_DEPTH + (k), visibility.z[k]); \
  } \
  STORE_TRANSMITTANCE(k)
  EACH_NODE(STORE)
#if ESTIMATE_ERROR
  setRecordFloat(record, RECORD_LOST, visibility.lost);
  setRecordFloat(record, RECORD_NEAREST, visibility.nearest);
  setRecordFloat(record, RECORD_FARTHEST, visibility.farthest);
#endif
  setFragmentCount(record, count);
}

// What a fragment finds at its depth.
struct Lookup
{
  int before;     // how many nodes are in front of it
  int coincident; // how many have its depth; the last of them is its own
};

// Of the nodes' depths alone.
Lookup lookUp(Visibility visibility, float depth)
{
  Lookup found = Lookup(0, 0);
#define LOOK_UP(k) \
  found.before += visibility.z[k] < depth ? 1 : 0; \
  found.coincident += visibility.z[k] == depth ? 1 : 0;
  EACH_NODE(LOOK_UP)
  found.before += max(found.coincident - 1, 0);
  return found;
}

// Behind any node, before the first at -1.
Channels transmittanceBehind(PixelRecord record, int node)
{
  Channels behind = Channels(1.0);
#if RECORD_TARGETS
#define FIND_NODE(k) behind = node == (k) ? nodeTransmittance(record, k) : behind;
  EACH_NODE(FIND_NODE)
#else
  if (node >= 0)
  {
    behind = nodeTransmittance(record, node);
  }
#endif
  return behind;
}

void moveNode(PixelRecord record, int node, float depth)
{
#if RECORD_TARGETS
#define MOVE_NODE(k) \
  setRecordFloat(record, RECORD_DEPTH + (k), node == (k) ? depth : recordFloat(record, RECORD_DEPTH + (k)));
  EACH_NODE(MOVE_NODE)
#else
  setRecordFloat(record, RECORD_DEPTH + node, depth);
#endif
}

// What a fragment is weighted with, and what of that counts as a weight.
struct Weight
{
  Channels visibility;
  float corrected; // 1, or 0
};

Weight visitPixel(PixelRecord record, Channels opacity, float depth)
{
  uint count = fragmentCount(record);
  Visibility visibility;
  clearVisibility(visibility);
  loadDepths(record, count, visibility);
  if (gatherStage == 0)
  {
    loadTransmittances(record, count, visibility);
    insertFragment(visibility, depth, opacity, int(count));
    storeVisibility(record, min(count + 1u, uint(NODE_COUNT + 1)), visibility);
    return Weight(Channels(0.0), 0.0);
  }
  Lookup found = lookUp(visibility, depth);
  if (found.coincident > 1)
  {
    moveNode(record, found.before, uintBitsToFloat(floatBitsToUint(depth) + 1u));
  }
  bool removed = count > uint(NODE_COUNT);
  Channels behind = transmittanceBehind(record, found.before - 1);
  if (WEIGHS_BY_MEANS && removed && found.coincident == 0)
  {
    behind = visibilityBetween(transmittanceBehind(record, found.before - 2), behind, opacity);
  }
  return Weight(behind, removed ? 1.0 : 0.0);
}

#if RECORD_TARGETS
void gatherFragment(vec4 color, float depth)
{
  PixelRecord record = pixelRecord(ivec2(gl_FragCoord.xy), 0);
  Channels opacity = opacityOf(color);
  if (gatherStage == 0 && fragmentCount(record) == 0u)
  {
    storeTail(record, RECORD_SUMS, Tail(vec3(0.0), Channels(0.0), Channels(1.0)));
  }
  Weight weight = visitPixel(record, opacity, depth);
  if (gatherStage != 0)
  {
    Tail sums = loadTail(record, RECORD_SUMS);
    sums.color += weight.visibility * color.a * color.rgb;
    sums.opacity += weight.corrected * weight.visibility * opacity;
    sums.transmittance *= 1.0 - opacity;
    storeTail(record, RECORD_SUMS, sums);
  }
  drawRecord();
}
#else
void gatherFragment(vec4 color, float depth, out vec4 outputs[GATHER_OUTPUTS])
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#if SAMPLES > 1
  int index = gl_SampleID;
#else
  int index = 0;
#endif
  Channels opacity = opacityOf(color);
  Weight weight = Weight(Channels(0.0), 0.0);
  if (inTile(pixel))
  {
    CRITICAL_SECTION(pixel, weight = visitPixel(pixelRecord(pixel, index), opacity, depth))
  }
  vec3 light = color.a * color.rgb;
  Channels corrected = weight.corrected * weight.visibility * opacity;
#if TRANSMITTANCE_CHANNELS == 3
  outputs[0] = vec4(weight.visibility * light, opacity.r);
  outputs[1] = vec4(corrected, opacity.g);
  outputs[2] = vec4(light, opacity.b);
#else
  outputs[0] = vec4(weight.visibility * light, opacity);
#if ALPHA_CORRECTION
  outputs[1] = vec4(corrected);
#endif
#endif
}
#endif
