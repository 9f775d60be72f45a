// MultiLayer/Layers.glsl: the layers of a pixel as its record holds them, front to back.
//
// Three words a layer: depth, and as half floats the colour, multiplied by its opacity, with what the layer lets through. What becomes of
// fragments that find no room is the TAIL:
// - TAIL_MERGE: they are blended into the last layer (multi-layer alpha blending, Salvi and Vaidyanathan 2014).
// - TAIL_DROP: they are left out (k-buffer, Bavoil et al. 2007).
// - TAIL_AVERAGE: sums behind the layers, as five floats: opacity times colour, opacity, and the product of 1 - opacity (hybrid
//   transparency, Maule et al. 2013). A record's count is then LAYERS + 1.
//
// Needs: LAYERS, TAIL, SAMPLES.  Gives: Layer, loadLayer, storeLayer, and with TAIL_AVERAGE Tail, loadTail, storeTail.
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

#define LAYER_WORDS 3
#define TAIL_WORD (LAYERS * LAYER_WORDS)
#if TAIL == TAIL_AVERAGE
#define PIXEL_WORDS (TAIL_WORD + 5)
#else
#define PIXEL_WORDS TAIL_WORD
#endif
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

#if TAIL == TAIL_AVERAGE
struct Tail
{
  vec4 sums; // opacity times colour, opacity
  float transmittance;
};

Tail loadTail(PixelRecord record)
{
  Tail tail;
  for (int i = 0; i < 4; ++i)
  {
    tail.sums[i] = uintBitsToFloat(recordWord(record, TAIL_WORD + i));
  }
  tail.transmittance = uintBitsToFloat(recordWord(record, TAIL_WORD + 4));
  return tail;
}

void storeTail(PixelRecord record, Tail tail)
{
  for (int i = 0; i < 4; ++i)
  {
    setRecordWord(record, TAIL_WORD + i, floatBitsToUint(tail.sums[i]));
  }
  setRecordWord(record, TAIL_WORD + 4, floatBitsToUint(tail.transmittance));
}
#endif

#endif
