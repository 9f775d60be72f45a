// MultiLayer/Layers.glsl: the layers of a pixel as its record holds them, front to back.
//
// Three words a layer: depth, and as half floats the colour, multiplied by its opacity, with what the layer lets through; four with three
// channels of that (Common/Channels.glsl). What becomes of fragments that find no room is the TAIL:
// - TAIL_MERGE: they are blended into the last layer (multi-layer alpha blending, Salvi and Vaidyanathan 2014).
// - TAIL_DROP: they are left out (k-buffer, Bavoil et al. 2007).
// - TAIL_AVERAGE: sums behind the layers, as five floats: opacity times colour, opacity, and the product of 1 - opacity (hybrid
//   transparency, Maule et al. 2013); nine with three channels. A record's count is then LAYERS + 1.
//
// Needs: LAYERS, TAIL, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: Layer, layerDepth, loadColor, storeColor, loadLayer, storeLayer, Content, packContent, unpackContent, and with
// TAIL_AVERAGE Tail, loadTail, storeTail.
#ifndef Layers_glsl
#define Layers_glsl
#ifndef LAYERS
#error "MultiLayer/Layers.glsl needs LAYERS"
#endif
#ifndef TAIL
#error "MultiLayer/Layers.glsl needs TAIL"
#endif

#define TAIL_MERGE 0
#define TAIL_DROP 1
#define TAIL_AVERAGE 2

#if TRANSMITTANCE_CHANNELS == 3
#define LAYER_WORDS 4
#else
#define LAYER_WORDS 3
#endif
#define TAIL_WORD (LAYERS * LAYER_WORDS)
#if TAIL == TAIL_AVERAGE
#define PIXEL_WORDS (TAIL_WORD + 3 + 2 * TRANSMITTANCE_CHANNELS)
#else
#define PIXEL_WORDS TAIL_WORD
#endif
#include "Common/ColorHalves.glsl"
#include "Common/Pixels.glsl"

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

float layerDepth(PixelRecord record, int index)
{
  return uintBitsToFloat(recordWord(record, index * LAYER_WORDS));
}

PackedColor loadColor(PixelRecord record, int index)
{
  int word = index * LAYER_WORDS;
  PackedColor color;
  color.x = recordWord(record, word + 1);
  color.y = recordWord(record, word + 2);
#if TRANSMITTANCE_CHANNELS == 3
  color.z = recordWord(record, word + 3);
#endif
  return color;
}

void storeColor(PixelRecord record, int index, PackedColor color)
{
  int word = index * LAYER_WORDS;
  setRecordWord(record, word + 1, color.x);
  setRecordWord(record, word + 2, color.y);
#if TRANSMITTANCE_CHANNELS == 3
  setRecordWord(record, word + 3, color.z);
#endif
}

Layer loadLayer(PixelRecord record, int index)
{
  return Layer(layerDepth(record, index), loadColor(record, index));
}

void storeLayer(PixelRecord record, int index, Layer layer)
{
  setRecordWord(record, index * LAYER_WORDS, floatBitsToUint(layer.depth));
  storeColor(record, index, layer.color);
}

#if TAIL == TAIL_AVERAGE
struct Tail
{
  vec3 color; // sums: opacity times colour,
  Channels opacity;
  Channels transmittance; // and the product of 1 - opacity
};

float loadNumber(PixelRecord record, int index)
{
  return uintBitsToFloat(recordWord(record, TAIL_WORD + index));
}

void storeNumber(PixelRecord record, int index, float number)
{
  setRecordWord(record, TAIL_WORD + index, floatBitsToUint(number));
}

vec3 loadNumbers(PixelRecord record, int index)
{
  return vec3(loadNumber(record, index), loadNumber(record, index + 1), loadNumber(record, index + 2));
}

void storeNumbers(PixelRecord record, int index, vec3 numbers)
{
  storeNumber(record, index, numbers.x);
  storeNumber(record, index + 1, numbers.y);
  storeNumber(record, index + 2, numbers.z);
}

Tail loadTail(PixelRecord record)
{
#if TRANSMITTANCE_CHANNELS == 3
  return Tail(loadNumbers(record, 0), loadNumbers(record, 3), loadNumbers(record, 6));
#else
  return Tail(loadNumbers(record, 0), loadNumber(record, 3), loadNumber(record, 4));
#endif
}

void storeTail(PixelRecord record, Tail tail)
{
  storeNumbers(record, 0, tail.color);
#if TRANSMITTANCE_CHANNELS == 3
  storeNumbers(record, 3, tail.opacity);
  storeNumbers(record, 6, tail.transmittance);
#else
  storeNumber(record, 3, tail.opacity);
  storeNumber(record, 4, tail.transmittance);
#endif
}
#endif

#endif
