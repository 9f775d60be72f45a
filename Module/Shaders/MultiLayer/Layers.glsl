// MultiLayer/Layers.glsl: the layers of a pixel as its record holds them, front to back.
//
// Three words a layer: depth, and as half floats the colour, multiplied by its opacity, with what the layer lets through; four with three
// channels of that (Common/Channels.glsl). What becomes of fragments that find no room is the TAIL:
// - TAIL_MERGE: they are blended into the last layer (multi-layer alpha blending, Salvi and Vaidyanathan 2014).
// - TAIL_DROP: they are left out (k-buffer, Bavoil et al. 2007).
// - TAIL_AVERAGE: sums behind the layers, as five floats: opacity times colour, opacity, and the product of 1 - opacity (hybrid
//   transparency, Maule et al. 2013); nine with three channels. A record's count is then LAYERS + 1.
//
// Needs: LAYERS, TAIL, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: what Common/RecordNumbers.glsl gives, Layer, layerDepth,
// loadLayer, storeLayer, Content, packContent, unpackContent.
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
  return recordFloat(record, index * LAYER_WORDS);
}

Layer loadLayer(PixelRecord record, int index)
{
  return Layer(layerDepth(record, index), recordColor(record, index * LAYER_WORDS + 1));
}

void storeLayer(PixelRecord record, int index, Layer layer)
{
  setRecordFloat(record, index * LAYER_WORDS, layer.depth);
  setRecordColor(record, index * LAYER_WORDS + 1, layer.color);
}

#endif
