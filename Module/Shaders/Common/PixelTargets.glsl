// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// PixelTargets.glsl: the records of Pixels.glsl in colours of 32-bit words, four in each, of which a fragment fetches
// what earlier ones have drawn (GL_EXT_shader_framebuffer_fetch). The driver keeps the fragments of a pixel apart and
// in the order of drawing.
//
// All words of a record are fetched at once, changed in registers, and drawn. So words are to be numbered by constants,
// in mappers' shaders after the preprocessor (Adaptive/EachNode.glsl).
//
// In the beginning some of the first words are EMPTY_NUMBER, as the technique has asked
// (vtkTranslucencyFrame::UsePixels); the others are what was there before. A technique takes from them what recordCount
// tells of records in buffers.
//
// Needs: RECORD_TARGETS (1 to 8), RECORDS_READ_ONLY (1: a shader of the screen, which reads them as textures).
// Gives: PixelRecord, pixelRecord, recordWord, setRecordWord, and where they are not read only drawRecord, and
// gatheredColors, which takes the place of gl_FragData in a mapper's shader.
#ifndef PixelTargets_glsl
#define PixelTargets_glsl
#include "Common/Bindings.glsl"
#include "CriticalSection/Selected.glsl" // None
#ifndef RECORD_TARGETS
#error "PixelTargets.glsl needs RECORD_TARGETS"
#endif
#ifndef RECORDS_READ_ONLY
#define RECORDS_READ_ONLY 0
#endif
#define VECTOR_COUNT RECORD_TARGETS
#include "Common/EachVector.glsl"

uvec4 recordWords[RECORD_TARGETS];

#if RECORDS_READ_ONLY
#define DECLARE_TARGET(i) uniform usampler2D recordTarget##i;
#define FETCH_TARGET(i) recordWords[i] = texelFetch(recordTarget##i, pixel, 0);
#else
#define DECLARE_TARGET(i) layout(location = i) inout uvec4 recordTarget##i;
#define FETCH_TARGET(i) recordWords[i] = recordTarget##i;
#define DRAW_TARGET(i) recordTarget##i = recordWords[i];

vec4 gatheredColors[gl_MaxDrawBuffers];
#endif

EACH_VECTOR(DECLARE_TARGET)

// There is one at a time, that of the shader's own pixel.
struct PixelRecord
{
  ivec2 pixel;
};

PixelRecord pixelRecord(ivec2 pixel, int index)
{
  EACH_VECTOR(FETCH_TARGET)
  return PixelRecord(pixel);
}

uint recordWord(PixelRecord record, int word)
{
  return recordWords[word / 4][word % 4];
}

void setRecordWord(PixelRecord record, int word, uint value)
{
  recordWords[word / 4][word % 4] = value;
}

#if !RECORDS_READ_ONLY
void drawRecord()
{
  EACH_VECTOR(DRAW_TARGET)
}
#endif

#endif
