// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorb.glsl: gives each fragment of a sorted list what bodies absorb between the one before and itself.
//
// A medium of absorption s a unit of length lets through exp(-s d) over the distance d (Beer-Lambert). What lies before
// a fragment is put into it: its colour is multiplied with that, and so is its transmittance. So the list draws the
// same picture as surfaces with media between them, whoever draws it. Media behind the last fragment are put into that:
// only the opaque surface is behind it.
//
// The first walk finds what the viewer is inside of: media that are left more often than they are entered. Which comes
// first does not tell: at a body's outline, where both faces are at one depth, either may. Between faces in the wrong
// order nothing is absorbed.
//
// Each sample of a pixel has faces of its own. A fragment that covers several is given their mean.
//
// Needs: what the storage needs, COLOR_FORMAT, SAMPLES.
#include "Absorption/Medium.glsl"
#include "Common/Fragment.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

#define FRAGMENTS_A_ROUND 8 // drivers may limit the rounds of a loop

uniform vec4 absorptionOf[MOST_MEDIA + 1];
uniform vec4 unprojectPicture;   // window pixels to -1 to 1: scale x, y, offset x, y
uniform vec4 unprojectColumn[4]; // of the matrix from there to world coordinates
uniform sampler2D translucencyOpaqueDepth;

// Along the ray of one sample.
struct Path
{
  vec3 absorption; // here
  float travelled; // from the near plane to the fragment before,
  uint last;       // which is this
};

vec3 placeAt(ivec2 pixel, float depth)
{
  vec2 at = (vec2(pixel) + 0.5) * unprojectPicture.xy + unprojectPicture.zw;
  vec4 place = unprojectColumn[0] * at.x + unprojectColumn[1] * at.y + unprojectColumn[2] * (2.0 * depth - 1.0) +
    unprojectColumn[3];
  return place.xyz / place.w;
}

int numberOf(uint medium)
{
  return int(medium) & MOST_MEDIA;
}

bool isEntry(uint medium)
{
  return (medium & uint(MEDIUM_FRONT)) != 0u;
}

bool covers(Fragment fragment, int index)
{
  return ((fragment.coverage >> uint(index)) & 1u) != 0u;
}

// Eight bytes, of which each is 1 where a sample is covered.
uvec2 bytesOf(uint coverage)
{
  return (uvec2(coverage, coverage >> 4u) & 0xfu) * 0x204081u & 0x1010101u;
}

// What is around the viewer, and whether the pixel's fragments bound any medium.
bool findMedia(ivec2 pixel, inout Path paths[SAMPLES])
{
  const uint none = 0x80808080u;
  uvec2 left[MOST_MEDIA + 1]; // how much oftener than entered, of each sample, in bytes
  for (int i = 0; i <= MOST_MEDIA; ++i)
  {
    left[i] = uvec2(none);
  }
  bool any = false;
  uint cursor = firstFragment(pixel);
  while (cursor != 0u)
  {
    for (int round = 0; round < FRAGMENTS_A_ROUND; ++round)
    {
      Fragment fragment;
      if (nextFragment(cursor, fragment))
      {
        uint medium = mediumOf(fragment.color);
        uvec2 covered = bytesOf(fragment.coverage);
        left[numberOf(medium)] += isEntry(medium) ? 0u - covered : covered;
        any = any || medium != 0u;
      }
    }
  }
  recordUnfinished(cursor);
  for (int i = 1; i <= MOST_MEDIA; ++i)
  {
    for (int index = 0; index < SAMPLES && left[i] != uvec2(none); ++index)
    {
      int times = int((left[i][index >> 2] >> uint(8 * (index & 3))) & 0xffu) - 0x80;
      paths[index].absorption += float(max(times, 0)) * absorptionOf[i].rgb;
    }
  }
  return any;
}

// What a sample's path lets through from the fragment before on.
vec3 transmit(Path path, float travelled)
{
  return exp(-max(path.absorption, 0.0) * (travelled - path.travelled));
}

// A fragment behind what lets that much through.
PackedColor absorbed(PackedColor words, vec3 passes)
{
  Surface surface = unpackColor(withoutMedium(words));
  vec3 opacity = 1.0 - passes * (1.0 - surface.opacity);
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  vec4 color = unpackUnorm4x8(words.x);
  return uvec3(packUnorm4x8(vec4(passes * color.rgb, color.a)), packUnorm4x8(vec4(opacity, 0.0)), 0u);
#else
  return packColorHalves(passes * surface.color, opacity);
#endif
}

// Goes to the next fragment, and puts what was absorbed before it into its color.
void advance(uint node, Fragment fragment, float travelled, inout Path paths[SAMPLES])
{
  uint medium = mediumOf(fragment.color);
  float entries = isEntry(medium) ? 1.0 : -1.0;
  vec3 passes = vec3(0.0);
  for (int index = 0; index < SAMPLES; ++index)
  {
    if (covers(fragment, index))
    {
      passes += transmit(paths[index], travelled);
      paths[index].absorption += entries * absorptionOf[numberOf(medium)].rgb;
      paths[index].travelled = travelled;
      paths[index].last = node;
    }
  }
  storeColor(node, absorbed(fragment.color, passes / float(bitCount(fragment.coverage))));
}

// Puts what is absorbed up to the opaque surface into each sample's last fragment.
void finish(float travelled, Path paths[SAMPLES])
{
  for (int index = 0; index < SAMPLES; ++index)
  {
    uint node = paths[index].last;
    if (node != 0u)
    {
      uint next;
      Fragment fragment = loadNode(node, next);
      vec3 stops = vec3(0.0);
      for (int other = index; other < SAMPLES; ++other) // of those before it, it is not the last
      {
        if (paths[other].last == node)
        {
          stops += 1.0 - transmit(paths[other], travelled);
          paths[other].last = 0u;
        }
      }
      storeColor(node, absorbed(fragment.color, 1.0 - stops / float(bitCount(fragment.coverage))));
    }
  }
}

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  Path paths[SAMPLES];
  for (int index = 0; index < SAMPLES; ++index)
  {
    paths[index] = Path(vec3(0.0), 0.0, 0u);
  }
  if (!findMedia(pixel, paths))
  {
    return false;
  }
  vec3 near = placeAt(pixel, 0.0);
  uint cursor = firstFragment(pixel);
  while (cursor != 0u)
  {
    for (int round = 0; round < FRAGMENTS_A_ROUND; ++round)
    {
      uint node = cursor;
      Fragment fragment;
      if (nextFragment(cursor, fragment))
      {
        advance(node, fragment, distance(near, placeAt(pixel, fragment.depth)), paths);
      }
    }
  }
  recordUnfinished(cursor);
  float opaque = texelFetch(translucencyOpaqueDepth, pixel, 0).r;
  if (opaque < 1.0)
  {
    finish(distance(near, placeAt(pixel, opaque)), paths);
  }
  return false;
}

#include "Common/Resolve.glsl"
