// MultiLayer/Layers.glsl: the layers of a pixel as its record holds them, front to back.
//
// Three words a layer: depth, and as half floats the colour, multiplied by its opacity, with what the layer lets through.
//
// Needs: LAYERS, SAMPLES.  Gives: Layer, loadLayer, storeLayer.
#ifndef Layers_glsl
#define Layers_glsl
#ifndef LAYERS
#error "MultiLayer/Layers.glsl needs LAYERS"
#endif
#define LAYER_WORDS 3
#define PIXEL_WORDS (LAYERS * LAYER_WORDS)
#include "Common/HalfFloat.glsl"
#include "Common/Pixels.glsl"

struct Layer
{
  float depth;
  uvec2 color;
};

Layer loadLayer(PixelRecord record, int index)
{
  int word = index * LAYER_WORDS;
  return Layer(uintBitsToFloat(recordWord(record, word)),
    uvec2(recordWord(record, word + 1), recordWord(record, word + 2)));
}

void storeLayer(PixelRecord record, int index, Layer layer)
{
  int word = index * LAYER_WORDS;
  setRecordWord(record, word, floatBitsToUint(layer.depth));
  setRecordWord(record, word + 1, layer.color.x);
  setRecordWord(record, word + 2, layer.color.y);
}

#endif
