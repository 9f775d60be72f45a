// Peel/Buckets.glsl: what a sample's record holds while its layers are peeled by bucket sort (Liu, Huang, Liu and Wu 2009).
//
// From the nearest depth that is left on, BUCKETS intervals of one length share the depths; whatever lies farther goes to the last of them. A
// bucket has room for the layers of BUCKET_SIZE depths, in any order, the nearest ones that have come to it; each is a depth and as half
// floats the colour, multiplied by its opacity, with the opacity. A depth that finds no room, or has to make room, lowers the limit: in front of it
// all layers are in their buckets, with all of their fragments. From it on they wait for the next drawing.
//
// The words:
// - begin: fragments in front of it have been peeled; NO_DEPTH when nothing is left to do
// - limit: the nearest depth that has found no room; NO_DEPTH if all have
// - buckets: how many of them a unit of depth has
// - peeled: how many layers have been
// - front: four floats: colour of what has been peeled, and how much it lets through
// - layers; or in their place, where what is left is averaged, the tail: five floats: sums of opacity * colour and of opacity, and the product
//   of 1 - opacity
// A record's count tells how many layers there are in each bucket, BUCKET_BITS each, and whether it is the TAIL that is gathered.
//
// Needs: BUCKETS, BUCKET_SIZE, SAMPLES.  Gives: those words, recordFloat, setRecordFloat, recordVector, setRecordVector, sampleRecord, layerWord,
// bucketCount.
#ifndef Buckets_glsl
#define Buckets_glsl
#ifndef BUCKETS
#error "Peel/Buckets.glsl needs BUCKETS"
#endif
#ifndef BUCKET_SIZE
#error "Peel/Buckets.glsl needs BUCKET_SIZE"
#endif

#define BEGIN_WORD 0
#define LIMIT_WORD 1
#define BUCKETS_WORD 2
#define PEELED_WORD 3
#define FRONT_WORD 4
#define LAYERS_WORD 8
#define LAYER_WORDS 3
#define TAIL_WORD LAYERS_WORD
#define PIXEL_WORDS (LAYERS_WORD + BUCKETS * BUCKET_SIZE * LAYER_WORDS)

#define BUCKET_BITS 3
#define BUCKET_MASK 7u
#define TAIL 0x80000000u

#define NO_DEPTH 1e30

#include "Common/HalfFloat.glsl"
#include "Common/Pixels.glsl"

float recordFloat(PixelRecord record, int word)
{
  return uintBitsToFloat(recordWord(record, word));
}

void setRecordFloat(PixelRecord record, int word, float number)
{
  setRecordWord(record, word, floatBitsToUint(number));
}

vec4 recordVector(PixelRecord record, int word)
{
  return vec4(recordFloat(record, word), recordFloat(record, word + 1), recordFloat(record, word + 2), recordFloat(record, word + 3));
}

void setRecordVector(PixelRecord record, int word, vec4 numbers)
{
  setRecordFloat(record, word, numbers.x);
  setRecordFloat(record, word + 1, numbers.y);
  setRecordFloat(record, word + 2, numbers.z);
  setRecordFloat(record, word + 3, numbers.w);
}

int layerWord(int bucket, int place)
{
  return LAYERS_WORD + (bucket * BUCKET_SIZE + place) * LAYER_WORDS;
}

// Of a layer, from the word behind its depth on.
vec4 layerColor(PixelRecord record, int word)
{
  return unpackHalves(uvec2(recordWord(record, word + 1), recordWord(record, word + 2)));
}

uint bucketCount(uint count, int bucket)
{
  return (count >> uint(bucket * BUCKET_BITS)) & BUCKET_MASK;
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
