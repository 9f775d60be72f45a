// Peel/StartBuckets.glsl: records as they are before the first drawing: nothing has been peeled, and the buckets share all depths.
//
// Needs: BUCKETS, BUCKET_SIZE, SAMPLES.  Gives: main.
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
    setRecordVector(record, FRONT_WORD, vec4(0.0, 0.0, 0.0, 1.0));
  }
  discard;
}
