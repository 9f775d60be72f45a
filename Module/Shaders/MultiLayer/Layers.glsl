// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// MultiLayer/Layers.glsl: the layers of a pixel as its record holds them, front to back.
//
// First the depths of all, then the tail, then of each layer the colour with what the layer lets through
// (Common/Channels.glsl):
// - half floats: the colour, multiplied by its opacity, and what is let through: two words, or three with three
//   channels;
// - bytes: the colour, not multiplied by the opacity, and the opacity: one word; with three channels the colour over
//   its greatest component, that, and three opacities: two words.
//
// What becomes of fragments that find no room is the TAIL:
// - TAIL_MERGE: they are blended into the last layer (multi-layer alpha blending, Salvi and Vaidyanathan 2014).
// - TAIL_DROP: they are left out (k-buffer, Bavoil et al. 2007).
// - TAIL_AVERAGE: sums behind the layers, as five floats: opacity times colour, opacity, and the product of 1 - opacity
//   (hybrid transparency, Maule et al. 2013); nine with three channels.
//
// In buffers, a record's count is that of its layers, and LAYERS + 1 if its tail is in use. In colours, the depths and
// the first word of the tail are EMPTY_NUMBER in the beginning.
//
// Needs: LAYERS, TAIL, COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: what Common/RecordNumbers.glsl gives,
// Layer, layerDepth, loadColor, storeColor, loadLayer, storeLayer, countLayers, Content, packContent, unpackContent.
#ifndef Layers_glsl
#define Layers_glsl
#ifndef LAYERS
#error "MultiLayer/Layers.glsl needs LAYERS"
#endif
#ifndef TAIL
#error "MultiLayer/Layers.glsl needs TAIL"
#endif

#ifndef COLOR_FORMAT
#error "MultiLayer/Layers.glsl needs COLOR_FORMAT"
#endif
#include "Common/ColorHalves.glsl"

#define TAIL_MERGE 0
#define TAIL_DROP 1
#define TAIL_AVERAGE 2

#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
#define COLOR_WORDS (TRANSMITTANCE_CHANNELS == 3 ? 2 : 1)
#else
#define COLOR_WORDS (TRANSMITTANCE_CHANNELS == 3 ? 3 : 2)
#endif
#if TAIL == TAIL_AVERAGE
#define TAIL_WORDS (3 + 2 * TRANSMITTANCE_CHANNELS)
#else
#define TAIL_WORDS 0
#endif
#define TAIL_WORD LAYERS
#define COLOR_WORD(index) (LAYERS + TAIL_WORDS + (index) * COLOR_WORDS)
#define PIXEL_WORDS COLOR_WORD(LAYERS)
#include "Common/RecordNumbers.glsl"

struct Layer
{
  float depth;
  PackedColor color;
};

// What a layer adds to its pixel where nothing hides it, and what it lets through.
struct Content
{
  vec3 color; // multiplied by its opacity
  Channels transmittance;
};

#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
PackedColor packContent(Content content)
{
  PackedColor words = PackedColor(0u);
#if TRANSMITTANCE_CHANNELS == 3
  float scale = max(max(content.color.r, content.color.g), content.color.b);
  words.y = packUnorm4x8(vec4(1.0 - content.transmittance, 0.0));
#else
  float scale = 1.0 - content.transmittance;
#endif
  words.x = packUnorm4x8(vec4(content.color / max(scale, 1e-30), scale));
  return words;
}

Content unpackContent(PackedColor words)
{
  vec4 color = unpackUnorm4x8(words.x);
#if TRANSMITTANCE_CHANNELS == 3
  return Content(color.a * color.rgb, 1.0 - unpackUnorm4x8(words.y).rgb);
#else
  return Content(color.a * color.rgb, 1.0 - color.a);
#endif
}

PackedColor loadColor(PixelRecord record, int index)
{
  PackedColor words = PackedColor(0u);
  words.x = recordWord(record, COLOR_WORD(index));
#if TRANSMITTANCE_CHANNELS == 3
  words.y = recordWord(record, COLOR_WORD(index) + 1);
#endif
  return words;
}

void storeColor(PixelRecord record, int index, PackedColor words)
{
  setRecordWord(record, COLOR_WORD(index), words.x);
#if TRANSMITTANCE_CHANNELS == 3
  setRecordWord(record, COLOR_WORD(index) + 1, words.y);
#endif
}
#else
PackedColor packContent(Content content)
{
  return packColorHalves(content.color, content.transmittance);
}

Content unpackContent(PackedColor words)
{
  Content content;
  unpackColorHalves(words, content.color, content.transmittance);
  return content;
}

PackedColor loadColor(PixelRecord record, int index)
{
  return recordColor(record, COLOR_WORD(index));
}

void storeColor(PixelRecord record, int index, PackedColor words)
{
  setRecordColor(record, COLOR_WORD(index), words);
}
#endif

float layerDepth(PixelRecord record, int index)
{
  return recordFloat(record, index);
}

Layer loadLayer(PixelRecord record, int index)
{
  return Layer(layerDepth(record, index), loadColor(record, index));
}

void storeLayer(PixelRecord record, int index, Layer layer)
{
  setRecordFloat(record, index, layer.depth);
  storeColor(record, index, layer.color);
}

// How many layers are there; LAYERS + 1 if the tail is in use, too.
uint countLayers(PixelRecord record)
{
#if RECORD_TARGETS
  uint count = 0u;
  for (int i = 0; i < LAYERS + (TAIL == TAIL_AVERAGE ? 1 : 0); ++i)
  {
    count += recordFloat(record, i) == EMPTY_NUMBER ? 0u : 1u;
  }
  return count;
#else
  return recordCount(record);
#endif
}

#endif
