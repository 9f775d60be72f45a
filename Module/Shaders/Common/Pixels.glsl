// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pixels.glsl: a record of bounded size for each sample of each pixel, that fragments change one after the other.
//
// PIXEL_WORDS words a record, beside a count. Pixels lie in blocks of 8 x 4, and in a block all first words come first,
// then all second ones: the lanes of a vector, which are neighbours in the picture, find each word in one or two cache
// lines.
//
// Counts are 0 in the beginning; the words are what was there before.
//
// With RECORD_TARGETS above 0 they lie in that many colours instead, have no count, and PixelTargets.glsl gives what
// there is.
//
// Needs: PIXEL_WORDS, SAMPLES, RECORD_TARGETS.  Gives: pixelIndex, PixelRecord, pixelRecord, recordCount,
// setRecordCount, recordWord, setRecordWord.
#ifndef Pixels_glsl
#define Pixels_glsl
#ifndef RECORD_TARGETS
#error "Pixels.glsl needs RECORD_TARGETS"
#endif
#if RECORD_TARGETS
#include "Common/PixelTargets.glsl"
#else
#include "Common/Bindings.glsl"
#include "Common/Frame.glsl"
#include "CriticalSection/Selected.glsl"
#ifndef PIXEL_WORDS
#error "Pixels.glsl needs PIXEL_WORDS"
#endif
#ifndef SAMPLES
#error "Pixels.glsl needs SAMPLES"
#endif

layout(std430, binding = STORAGE_BINDING_TABLE) CRITICAL_MEMORY buffer PixelCounts
{
  uint pixelCounts[];
};

layout(std430, binding = STORAGE_BINDING_FRAGMENTS) CRITICAL_MEMORY buffer PixelRecords
{
  uint pixelRecords[];
};

#define PIXELS_OF_BLOCK uint(PIXEL_BLOCK_WIDTH * PIXEL_BLOCK_HEIGHT)

uint pixelIndex(ivec2 pixel)
{
  uvec2 at = uvec2(pixel - frameTile.xy);
  uvec2 size = uvec2(PIXEL_BLOCK_WIDTH, PIXEL_BLOCK_HEIGHT);
  uvec2 block = at / size;
  uvec2 inside = at % size;
  uint blocksAcross = (uint(frameTile.z) + size.x - 1u) / size.x;
  return (block.y * blocksAcross + block.x) * PIXELS_OF_BLOCK + inside.y * size.x + inside.x;
}

// Where the record of a sample lies: its count, and its first word. The others follow a block of pixels apart.
struct PixelRecord
{
  uint counter;
  uint words;
};

PixelRecord pixelRecord(ivec2 pixel, int index)
{
  uint at = pixelIndex(pixel);
  uint lane = at % PIXELS_OF_BLOCK;
  uint first = (at - lane) * uint(SAMPLES) + uint(index) * PIXELS_OF_BLOCK;
  return PixelRecord(first + lane, first * uint(PIXEL_WORDS) + lane);
}

uint recordCount(PixelRecord record)
{
  return pixelCounts[record.counter];
}

void setRecordCount(PixelRecord record, uint count)
{
  pixelCounts[record.counter] = count;
}

uint recordWord(PixelRecord record, int word)
{
  return pixelRecords[record.words + uint(word) * PIXELS_OF_BLOCK];
}

void setRecordWord(PixelRecord record, int word, uint value)
{
  pixelRecords[record.words + uint(word) * PIXELS_OF_BLOCK] = value;
}

#endif
#endif
