// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Heads.glsl: an entry for each pixel, from which its fragments are found; 0 if there are none.
//
// With several samples a pixel, the upper bits count the samples that are resolved.
//
// Needs: SAMPLES.  Gives: heads, headOf, setHead, dropFragments.
#ifndef Heads_glsl
#define Heads_glsl
#include "Common/Samples.glsl"
#include "Storage/Cells.glsl"

layout(std430, binding = STORAGE_BINDING_TABLE) buffer Heads
{
  uint heads[];
};

// 0, too, where the sample that is being resolved is done.
uint headOf(ivec2 pixel)
{
  uint head = heads[headIndex(pixel)];
  COUNT_TABLE(head);
#if SAMPLES > 1
  bool resolved = int(head >> HEAD_BITS) > resolveSample && resolveSample >= 0;
  return resolved ? 0u : head & HEAD_MASK;
#else
  return head;
#endif
}

void setHead(ivec2 pixel, uint head)
{
#if SAMPLES > 1
  head |= heads[headIndex(pixel)] & ~HEAD_MASK;
#endif
  heads[headIndex(pixel)] = head;
}

// The pixel, or the sample of it that is being resolved, is done: whoever asks next finds no fragments.
void dropFragments(ivec2 pixel)
{
#if SAMPLES > 1
  uint head = heads[headIndex(pixel)] & HEAD_MASK;
  bool last = resolveSample < 0 || resolveSample == SAMPLES - 1;
  heads[headIndex(pixel)] = last ? 0u : uint(resolveSample + 1) << HEAD_BITS | head;
#else
  heads[headIndex(pixel)] = 0u;
#endif
}

#endif
