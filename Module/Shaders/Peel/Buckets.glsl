// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/Buckets.glsl: what a sample's record holds while its layers are peeled by bucket sort (Liu, Huang, Liu and Wu
// 2009).
//
// From the nearest depth that is left on, BUCKETS intervals of one length share the depths; whatever lies farther goes
// to the last of them. A bucket has room for the layers of BUCKET_SIZE depths, in any order, the nearest ones that have
// come to it; each is a depth and as half floats the colour, multiplied by its opacity, with the opacity, or with three
// of them (Common/Channels.glsl). A depth that finds no room, or has to make room, lowers the limit: in front of it all
// layers are in their buckets, with all of their fragments. From it on they wait for the next drawing.
//
// The words:
// - begin: fragments in front of it have been peeled; NO_DEPTH when nothing is left to do
// - limit: the nearest depth that has found no room; NO_DEPTH if all have
// - buckets: how many of them a unit of depth has
// - peeled: how many layers have been
// - front: colour of what has been peeled, and how much it lets through, in floats
// - layers; or in their place, where what is left is averaged, the tail: sums of opacity * colour and of opacity, and
//   the product of 1 - opacity, in floats A record's count tells how many layers there are in each bucket, BUCKET_BITS
//   each, and whether it is the tail that is gathered.
//
// Needs: BUCKETS, BUCKET_SIZE, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: those words, what Common/RecordNumbers.glsl
// gives, Content, loadContent, storeContent, Front, loadFront, storeFront, layerWord, bucketCount.
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
#define LAYERS_WORD (FRONT_WORD + 3 + TRANSMITTANCE_CHANNELS)
#if TRANSMITTANCE_CHANNELS == 3
#define LAYER_WORDS 4
#else
#define LAYER_WORDS 3
#endif
#define PIXEL_WORDS (LAYERS_WORD + BUCKETS * BUCKET_SIZE * LAYER_WORDS)

#define BUCKET_BITS 3
#define BUCKET_MASK 7u
#define GATHERS_TAIL 0x80000000u

#define NO_DEPTH 1e30

#include "Common/ColorHalves.glsl"
#include "Common/RecordNumbers.glsl"

// What has been peeled.
struct Front
{
  vec3 color;
  Channels transmittance;
};

Front loadFront(PixelRecord record)
{
  return Front(recordVector(record, FRONT_WORD), recordChannels(record, FRONT_WORD + 3));
}

void storeFront(PixelRecord record, Front front)
{
  setRecordVector(record, FRONT_WORD, front.color);
  setRecordChannels(record, FRONT_WORD + 3, front.transmittance);
}

int layerWord(int bucket, int place)
{
  return LAYERS_WORD + (bucket * BUCKET_SIZE + place) * LAYER_WORDS;
}

// Of a layer, in the words behind its depth.
struct Content
{
  vec3 color; // multiplied by its opacity
  Channels opacity;
};

Content loadContent(PixelRecord record, int word)
{
  Content content;
  unpackColorHalves(recordColor(record, word + 1), content.color, content.opacity);
  return content;
}

void storeContent(PixelRecord record, int word, Content content)
{
  setRecordColor(record, word + 1, packColorHalves(content.color, content.opacity));
}

uint bucketCount(uint count, int bucket)
{
  return (count >> uint(bucket * BUCKET_BITS)) & BUCKET_MASK;
}

#endif
