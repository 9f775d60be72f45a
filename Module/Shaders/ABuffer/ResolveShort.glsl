// ABuffer/ResolveShort.glsl: pixels of up to BLOCK_SIZE fragments, which never leave the registers.
//
// Longer lists are left to the next level.
//
// Needs: BLOCK_SIZE, NEXT_LEVEL, COLOR_FORMAT, FRAGMENT_ORDER.
#ifndef NEXT_LEVEL
#error "ABuffer/ResolveShort.glsl needs NEXT_LEVEL"
#endif
#include "ABuffer/Blend.glsl"
#include "Common/Fragment.glsl"
#include "Common/SortBlock.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  Block block;
  emptyBlock(block);
  uint cursor = firstFragment(pixel);
  uint count = 0u;
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    Fragment fragment;
    if (nextFragment(cursor, fragment))
    {
      block.depth[i] = fragment.depth;
      block.color[i] = fragment.color;
      ++count;
    }
  }
  if (cursor != 0u)
  {
    leaveToLevel(pixel, NEXT_LEVEL);
    return false;
  }
  sortBlock(block);
  for (int i = 0; i < BLOCK_SIZE; ++i)
  {
    blendBehind(color, transmittance, block.color[i]); // an empty element is transparent
  }
  recordFragments(count);
  dropFragments(pixel);
  return count > 0u;
}

#include "Common/Resolve.glsl"
