// LinkedList.glsl: one linked list of fragments a pixel, the last drawn first (Yang et al. 2010).
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, FRAGMENT_ORDER, COUNT_ACCESSES.
// Gives: what Shaders/README.md asks of a storage.
#ifndef LinkedList_glsl
#define LinkedList_glsl
#define READS_COUNT 1
#define TABLE_COUNTS 1
#include "Storage/Nodes.glsl"

// Where fragments of a pixel are drawn in order, nobody else is at the pixel's head: a plain exchange, which takes less time.
uint exchangeHead(uint at, uint node)
{
#if FRAGMENT_ORDER == FRAGMENT_ORDER_DRAWN
  uint last = heads[at];
  heads[at] = node;
  return last;
#else
  return atomicExchange(heads[at], node);
#endif
}

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
#if MERGES_SAMPLES
  uint last = heads[headIndex(pixel)];
  if (mergeIntoNode(last, fragment, depthExtent))
  {
    return;
  }
#endif
  uint counter = counterOf(pixel);
  uint index = takeUnit(counter);
  COUNT_STORE(counter);
  if (index < cellUnits)
  {
    uint next = exchangeHead(headIndex(pixel), index + 1u);
    writeNode(index, next, fragment);
  }
}

#endif
