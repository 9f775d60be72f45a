// ABuffer/ResolveSamples.glsl: all samples of pixels of up to BLOCK_SIZE fragments, of which some cover only some samples.
//
// The list is read and sorted once; the fragments are then blended once a sample. What comes out waits in sampleColors, since a
// shader can't write different colours to the samples of a pixel, for Common/CompositeSamples.glsl. Longer lists are left to LONGER_LEVEL.
//
// Needs: BLOCK_SIZE, EQUAL_DEPTHS 1, LONGER_LEVEL, COLOR_FORMAT, FRAGMENT_ORDER, SAMPLES.
#ifndef LONGER_LEVEL
#error "ABuffer/ResolveSamples.glsl needs LONGER_LEVEL"
#endif
#include "ABuffer/Blend.glsl"
#include "ABuffer/LoadBlock.glsl"
#include "Common/SampleColors.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  Block block;
  uint count;
  uint unread;
  loadBlock(pixel, block, count, unread);
  if (unread != 0u)
  {
    leaveToLevel(pixel, LONGER_LEVEL);
    return false;
  }
  if (count == 0u)
  {
    return false;
  }
  sortBlock(block);
  for (int index = 0; index < SAMPLES; ++index)
  {
    vec3 sampleColor = vec3(0.0);
    float sampleTransmittance = 1.0;
    for (int i = 0; i < BLOCK_SIZE; ++i)
    {
      bool covers = ((block.carried[i] >> uint(index)) & 1u) != 0u;
      blendBehind(sampleColor, sampleTransmittance, covers ? block.color[i] : uvec2(0u));
    }
    storeSample(pixel, index, vec4(sampleColor, 1.0 - sampleTransmittance));
  }
  recordFragments(count);
  dropFragments(pixel);
  return false;
}

#include "Common/Resolve.glsl"
