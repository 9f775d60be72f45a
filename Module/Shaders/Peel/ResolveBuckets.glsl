// Peel/ResolveBuckets.glsl: a pixel's colour, or that of a sample of it: all that has been peeled.
//
// Needs: BUCKETS, BUCKET_SIZE, SAMPLES.
#include "Common/Tile.glsl"
#include "Peel/Buckets.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 front = recordVector(sampleRecord(), FRONT_WORD);
  color = front.rgb;
  transmittance = front.a;
  return inTile(pixel) && transmittance < 1.0; // beside the tile there are no records
}

#include "Common/Composite.glsl"
