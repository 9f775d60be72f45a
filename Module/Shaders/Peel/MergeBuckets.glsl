// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/MergeBuckets.glsl: puts the layers in front of the limit behind those that have been peeled, and makes the
// buckets ready for what is left from the limit on.
//
// Depths that are far closer to each other than the buckets are long get no more than a bucket's room in a drawing. So
// the next buckets are as long as two of the layers just peeled were deep, half of a bucket's room: of 16 layers with
// depths at random then most come in a drawing.
//
// Fragments that it leaves tell that something is left.
//
// Needs: BUCKETS, BUCKET_SIZE, PEEL_LAYERS (the most to peel, 0 for all), PEEL_TAIL, SAMPLES, TRANSMITTANCE_CHANNELS.
// Gives: main.
#ifndef PEEL_LAYERS
#error "Peel/MergeBuckets.glsl needs PEEL_LAYERS"
#endif
#ifndef PEEL_TAIL
#error "Peel/MergeBuckets.glsl needs PEEL_TAIL"
#endif
#include "Common/MeanColor.glsl"
#include "Common/Tile.glsl"
#include "Peel/Buckets.glsl"

out vec4 fragOutput0;

// The nearest layer of a bucket behind a depth: the first of its words, or 0 if there is none.
int nextLayer(PixelRecord record, int bucket, int taken, float before)
{
  float nearest = NO_DEPTH;
  int word = 0;
  for (int place = 0; place < taken; ++place)
  {
    int candidate = layerWord(bucket, place);
    float depth = recordFloat(record, candidate);
    if (depth > before && depth < nearest)
    {
      nearest = depth;
      word = candidate;
    }
  }
  return word;
}

// Returns whether something is left.
bool mergeLayers(PixelRecord record, uint count)
{
  Front front = loadFront(record);
  float limit = recordFloat(record, LIMIT_WORD);
  float begin = NO_DEPTH;
  uint before = recordWord(record, PEELED_WORD);
  uint peeled = before;
  for (uint left = count; left != 0u;)
  {
    int bucket = findLSB(left) / BUCKET_BITS;
    left &= ~(BUCKET_MASK << uint(bucket * BUCKET_BITS));
    float last = -NO_DEPTH;
    for (int taken = int(bucketCount(count, bucket)); taken != 0;)
    {
      int word = nextLayer(record, bucket, int(bucketCount(count, bucket)), last);
      last = word == 0 ? NO_DEPTH : recordFloat(record, word);
      taken = last < limit ? taken - 1 : 0;
      if (PEEL_LAYERS > 0 && peeled == uint(PEEL_LAYERS))
      {
        limit = min(limit, last);
      }
      if (last < limit)
      {
        Content layer = loadContent(record, word);
        front.color += front.transmittance * layer.color;
        front.transmittance *= 1.0 - layer.opacity;
        begin = min(begin, last);
        ++peeled;
      }
    }
  }
  storeFront(record, front);
  setRecordWord(record, PEELED_WORD, peeled);
  setRecordFloat(record, LIMIT_WORD, NO_DEPTH);
  setRecordFloat(record, BUCKETS_WORD, float(peeled - before) / (2.0 * max(limit - begin, 1e-30)));
  bool all = PEEL_LAYERS > 0 && peeled == uint(PEEL_LAYERS);
#if PEEL_TAIL
  if (all)
  {
    storeTail(record, LAYERS_WORD, Tail(vec3(0.0), Channels(0.0), Channels(1.0)));
  }
  setRecordCount(record, all ? GATHERS_TAIL : 0u);
#else
  setRecordCount(record, 0u);
  limit = all ? NO_DEPTH : limit;
#endif
  setRecordFloat(record, BEGIN_WORD, limit);
  return limit < NO_DEPTH;
}

#if PEEL_TAIL
void mergeTail(PixelRecord record)
{
  Front front = loadFront(record);
  Tail tail = loadTail(record, LAYERS_WORD);
  front.color += front.transmittance * meanColor(tail.color, tail.opacity, tail.transmittance);
  front.transmittance *= tail.transmittance;
  storeFront(record, front);
  setRecordCount(record, 0u);
  setRecordFloat(record, BEGIN_WORD, NO_DEPTH);
}
#endif

void main()
{
  fragOutput0 = vec4(0.0);
  bool left = false;
  if (inTile(ivec2(gl_FragCoord.xy)))
  {
    PixelRecord record = sampleRecord();
    uint count = recordCount(record);
#if PEEL_TAIL
    if (count == GATHERS_TAIL)
    {
      mergeTail(record);
    }
    else
#endif
    if (count != 0u)
    {
      left = mergeLayers(record, count);
    }
  }
  if (!left)
  {
    discard;
  }
}
