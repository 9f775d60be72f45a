// Adaptive/ShowFixed.glsl: a pixel, or a sample of it, by its record in fixed memory.
//
// Needs: SHOW, NODE_COUNT, NODE_REMOVAL, ESTIMATE_ERROR, SAMPLES.
#include "Adaptive/Record.glsl"
#include "Adaptive/Show.glsl"
#include "Adaptive/Visibility.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
#if SAMPLES > 1
  PixelRecord record = pixelRecord(pixel, gl_SampleID);
#else
  PixelRecord record = pixelRecord(pixel, 0);
#endif
  int count = int(recordCount(record));
  float error = 0.0;
#if ESTIMATE_ERROR
  error = estimateError(uintBitsToFloat(recordWord(record, RECORD_LOST)), uintBitsToFloat(recordWord(record, RECORD_NEAREST)),
    uintBitsToFloat(recordWord(record, RECORD_FARTHEST)));
#endif
  showPixel(error, count, color, transmittance);
  return count > 0;
}

#include "Common/Composite.glsl"
