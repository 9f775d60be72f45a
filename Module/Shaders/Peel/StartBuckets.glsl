// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/StartBuckets.glsl: records as they are before the first drawing: nothing has been peeled, and the buckets share
// all depths.
//
// Needs: BUCKETS, BUCKET_SIZE, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: main.
#include "Common/Tile.glsl"
#include "Peel/Buckets.glsl"

void main()
{
  if (inTile(ivec2(gl_FragCoord.xy)))
  {
    PixelRecord record = sampleRecord();
    setRecordFloat(record, BEGIN_WORD, -NO_DEPTH);
    setRecordFloat(record, LIMIT_WORD, NO_DEPTH);
    setRecordFloat(record, BUCKETS_WORD, float(BUCKETS));
    setRecordWord(record, PEELED_WORD, 0u);
    storeFront(record, Front(vec3(0.0), Channels(1.0)));
  }
  discard;
}
