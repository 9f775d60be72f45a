// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Trace/Resolve.glsl: copies the fragments of all pixels for the application to read, and draws nothing.
//
// A list is walked twice: once for its length, by which the pixel gets a range of its own, and once to fill that from
// its end, since lists give the last drawn first. Ranges behind traceRoom are counted only: the application compares
// the count with what was stored. Loops take several fragments a round: drivers may limit the rounds.
//
// Needs: COLOR_FORMAT, TRANSMITTANCE_CHANNELS (1).
#define FRAGMENTS_READ_ONLY 1
#include "Common/Bindings.glsl"
#include "Common/Fragment.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"
#if TRANSMITTANCE_CHANNELS != 1
#error "Trace/Resolve.glsl needs TRANSMITTANCE_CHANNELS 1"
#endif

#define TRACE_WORDS 6u // of a fragment: its pixel, its depth, red, green, blue and the opacity

layout(std430, binding = STORAGE_BINDING_READ_BACK) buffer Trace
{
  uint traceCount; // fragments, of all pixels
  uint traceWords[];
};

uniform int traceRoom; // fragments

vec4 colorOf(PackedColor words)
{
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
  return unpackUnorm4x8(words.x);
#else
  return unpackHalves(words);
#endif
}

void writeTraced(uint index, ivec2 pixel, Fragment fragment)
{
  uint word = index * TRACE_WORDS;
  vec4 color = colorOf(fragment.color);
  traceWords[word] = uint(pixel.y) << 16 | uint(pixel.x);
  traceWords[word + 1u] = floatBitsToUint(fragment.depth);
  traceWords[word + 2u] = floatBitsToUint(color.r);
  traceWords[word + 3u] = floatBitsToUint(color.g);
  traceWords[word + 4u] = floatBitsToUint(color.b);
  traceWords[word + 5u] = floatBitsToUint(color.a);
}

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  uint count = 0u;
  uint cursor = firstFragment(pixel);
  while (cursor != 0u)
  {
    for (int i = 0; i < 8; ++i)
    {
      Fragment fragment;
      count += nextFragment(cursor, fragment) ? 1u : 0u;
    }
  }
  recordUnfinished(cursor);
  if (count == 0u)
  {
    return false;
  }
  uint first = atomicAdd(traceCount, count);
  if (first + count <= uint(traceRoom))
  {
    uint index = first + count;
    cursor = firstFragment(pixel);
    while (cursor != 0u)
    {
      for (int i = 0; i < 8; ++i)
      {
        Fragment fragment;
        if (nextFragment(cursor, fragment))
        {
          --index;
          writeTraced(index, pixel, fragment);
        }
      }
    }
    recordUnfinished(cursor);
  }
  return false;
}

#include "Common/Resolve.glsl"
