// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/GatherBuckets.glsl: a fragment goes to the layer of its depth in the bucket of its depth (Buckets.glsl).
//
// Why nothing is lost: a bucket that is full keeps its nearest depths. When a depth finds no room in it, or has to
// leave, all that are in the bucket then, and stay, are nearer; so none of that depth's fragments will get into it
// again, and the limit is not behind it. Turned round, a depth in front of the limit has had its place from its first
// fragment on, and the layer holds all of them. Which of them that is does not depend on the order in which depths
// come; fragments of one depth are put over each other as they come.
//
// The limit only goes down while fragments come. So rejectsFragment may read it without the critical section: an older
// value is behind the newer one, and rejects nothing that the newer one would take. begin doesn't change.
// What is discarded there doesn't come to the critical section (CriticalSection/Spinlock.glsl).
//
// Needs: BUCKETS, BUCKET_SIZE, PEEL_TAIL (whether what is left is averaged), SAMPLES, TRANSMITTANCE_CHANNELS.  Gives:
// rejectsFragment, gatherFragment.
#ifndef PEEL_TAIL
#error "Peel/GatherBuckets.glsl needs PEEL_TAIL"
#endif
#include "Common/Coverage.glsl"
#include "Common/Opacity.glsl"
#include "Peel/Buckets.glsl"

// Not a number is in front of nothing, and behind nothing.
bool isLeft(PixelRecord record, float depth)
{
  return depth >= recordFloat(record, BEGIN_WORD) && depth < recordFloat(record, LIMIT_WORD);
}

// What has been peeled, or has to wait.
bool rejectsFragment(float depth)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool left = false;
  if (inTile(pixel))
  {
    uint coverage = coveredSamples();
    for (int index = 0; index < SAMPLES; ++index)
    {
      left = left || (((coverage >> uint(index)) & 1u) != 0u && isLeft(pixelRecord(pixel, index), depth));
    }
  }
  return !left;
}

#if PEEL_TAIL
void addToTail(PixelRecord record, Content layer)
{
  Tail tail = loadTail(record, LAYERS_WORD);
  tail.color += layer.color;
  tail.opacity += layer.opacity;
  tail.transmittance *= 1.0 - layer.opacity;
  storeTail(record, LAYERS_WORD, tail);
}
#endif

void addToBucket(PixelRecord record, Content layer, float depth, uint count)
{
  float inside = (depth - max(recordFloat(record, BEGIN_WORD), 0.0)) * recordFloat(record, BUCKETS_WORD);
  int bucket = int(clamp(inside, 0.0, float(BUCKETS - 1)));
  int taken = int(bucketCount(count, bucket));
  float farthest = -NO_DEPTH;
  int word = 0; // of its own layer, if there is one, or of the farthest one
  bool found = false;
  for (int place = 0; place < taken; ++place)
  {
    int candidate = layerWord(bucket, place);
    float other = recordFloat(record, candidate);
    if (!found && (other == depth || other > farthest))
    {
      found = other == depth;
      farthest = other;
      word = candidate;
    }
  }
  bool room = taken < BUCKET_SIZE;
  if (found)
  {
    Content behind = loadContent(record, word);
    layer = Content(layer.color + (1.0 - layer.opacity) * behind.color,
      layer.opacity + (1.0 - layer.opacity) * behind.opacity);
  }
  else if (room)
  {
    word = layerWord(bucket, taken);
    setRecordCount(record, count + (1u << uint(bucket * BUCKET_BITS)));
  }
  else
  {
    setRecordFloat(record, LIMIT_WORD, min(recordFloat(record, LIMIT_WORD), max(depth, farthest)));
  }
  if (found || room || depth < farthest)
  {
    setRecordFloat(record, word, depth);
    storeContent(record, word, layer);
  }
}

void updatePixel(PixelRecord record, vec4 color, float depth)
{
  Content layer = Content(color.a * color.rgb, opacityOf(color));
  if (isLeft(record, depth))
  {
    uint count = recordCount(record);
#if PEEL_TAIL
    if (count == GATHERS_TAIL)
    {
      addToTail(record, layer);
    }
    else
#endif
    {
      addToBucket(record, layer, depth, count);
    }
  }
}

#include "Common/GatherPixels.glsl"
