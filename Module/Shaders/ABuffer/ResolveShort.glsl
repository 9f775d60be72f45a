// ABuffer/ResolveShort.glsl: pixels of up to BLOCK_SIZE fragments, which never leave the registers.
//
// Longer lists are left to LONGER_LEVEL, and with EQUAL_DEPTHS 0 those with fragments of equal depth to EQUAL_DEPTHS_LEVEL, which
// is this shader with EQUAL_DEPTHS 1.
//
// Needs: BLOCK_SIZE, EQUAL_DEPTHS, LONGER_LEVEL, EQUAL_DEPTHS_LEVEL, COLOR_FORMAT, FRAGMENT_ORDER.
#ifndef LONGER_LEVEL
#error "ABuffer/ResolveShort.glsl needs LONGER_LEVEL"
#endif
#ifndef EQUAL_DEPTHS_LEVEL
#error "ABuffer/ResolveShort.glsl needs EQUAL_DEPTHS_LEVEL"
#endif
#include "ABuffer/Blend.glsl"
#include "ABuffer/LoadBlock.glsl"
#include "Common/FinishPixel.glsl"
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
  sortBlock(block);
#if !EQUAL_DEPTHS
  if (hasEqualDepths(block))
  {
    leaveToLevel(pixel, EQUAL_DEPTHS_LEVEL);
    return false;
  }
#endif
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    blendBehind(color, transmittance, block.color[i]); // an empty element is transparent
  }
  finishPixel(pixel, count);
  return count > 0u;
}

#include "Common/Resolve.glsl"
