// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// RecordNumbers.glsl: what techniques keep in the words of a pixel's record: floats, packed colours, and sums over
// fragments that found no room.
//
// Needs: PIXEL_WORDS, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: Common/Pixels.glsl; recordFloat, recordVector,
// recordChannels, recordColor and the same with set before them; Tail, loadTail, storeTail; sampleRecord.
#ifndef RecordNumbers_glsl
#define RecordNumbers_glsl
#include "Common/Channels.glsl"
#include "Common/Pixels.glsl"

float recordFloat(PixelRecord record, int word)
{
  return uintBitsToFloat(recordWord(record, word));
}

void setRecordFloat(PixelRecord record, int word, float number)
{
  setRecordWord(record, word, floatBitsToUint(number));
}

vec3 recordVector(PixelRecord record, int word)
{
  return vec3(recordFloat(record, word), recordFloat(record, word + 1), recordFloat(record, word + 2));
}

void setRecordVector(PixelRecord record, int word, vec3 numbers)
{
  setRecordFloat(record, word, numbers.x);
  setRecordFloat(record, word + 1, numbers.y);
  setRecordFloat(record, word + 2, numbers.z);
}

#if TRANSMITTANCE_CHANNELS == 3
#define recordChannels recordVector
#define setRecordChannels setRecordVector
#else
#define recordChannels recordFloat
#define setRecordChannels setRecordFloat
#endif

PackedColor recordColor(PixelRecord record, int word)
{
  PackedColor color;
  color.x = recordWord(record, word);
  color.y = recordWord(record, word + 1);
#if TRANSMITTANCE_CHANNELS == 3
  color.z = recordWord(record, word + 2);
#endif
  return color;
}

void setRecordColor(PixelRecord record, int word, PackedColor color)
{
  setRecordWord(record, word, color.x);
  setRecordWord(record, word + 1, color.y);
#if TRANSMITTANCE_CHANNELS == 3
  setRecordWord(record, word + 2, color.z);
#endif
}

struct Tail
{
  vec3 color; // sums: opacity times colour,
  Channels opacity;
  Channels transmittance; // and the product of 1 - opacity
};

Tail loadTail(PixelRecord record, int word)
{
  return Tail(recordVector(record, word), recordChannels(record, word + 3),
    recordChannels(record, word + 3 + TRANSMITTANCE_CHANNELS));
}

void storeTail(PixelRecord record, int word, Tail tail)
{
  setRecordVector(record, word, tail.color);
  setRecordChannels(record, word + 3, tail.opacity);
  setRecordChannels(record, word + 3 + TRANSMITTANCE_CHANNELS, tail.transmittance);
}

// Of the sample that a shader of the screen runs for.
PixelRecord sampleRecord()
{
#if SAMPLES > 1
  return pixelRecord(ivec2(gl_FragCoord.xy), gl_SampleID);
#else
  return pixelRecord(ivec2(gl_FragCoord.xy), 0);
#endif
}

#endif
