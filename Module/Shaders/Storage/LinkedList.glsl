// LinkedList.glsl: one linked list of fragments a pixel, the last drawn first (Yang et al. 2010).
//
// A new node comes from the range of nodes that its cell of pixels owns; vtkLinkedListStorage.h says why. A cell's counter
// begins at the range's first node. Counting goes on when the range is used up, into the next cell's nodes or past the last one,
// so that the application knows what was needed: it then draws again. Node n is called n + 1, so that 0 ends a list.
//
// Writes need no memory barrier among each other: each node is written by the one invocation that was given it, and only the
// atomic operations meet. The barrier between writing and reading is the application's.
//
// With several samples a pixel, a link is the distance to the next node in 24 bits (0: none), so that the coverage finds room beside
// it, and the upper bits of a head count the samples that are resolved.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: storeFragment, firstFragment, nextFragment, dropFragments, squareFragments, and where
// lists are changed: insertFragment, loadNode, linkNode, setFirstFragment.
#ifndef LinkedList_glsl
#define LinkedList_glsl
#include "Common/Bindings.glsl"
#include "Common/Fragment.glsl"
#include "Common/Frame.glsl"
#include "Common/MergeSamples.glsl"
#include "Common/Samples.glsl"
#include "Storage/LinkedListLayout.glsl"

layout(std140, binding = UNIFORM_BINDING_STORAGE) uniform ListLayout
{
  uint listCellShift;
  uint listCellsPerRow;
  uint listNodeCount;
};

layout(std430, binding = STORAGE_BINDING_COUNTERS) buffer ListCounters
{
  uint listCounters[]; // the next node of each cell, LIST_COUNTER_STRIDE apart; behind it, the first one and the end of the range
};

layout(std430, binding = STORAGE_BINDING_TABLE) buffer ListHeads
{
  uint listHeads[];
};

// A node is next, depth, and the words of the colour that are in use.
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8 && TRANSMITTANCE_CHANNELS == 1
#define NODE_WORDS 3
#elif COLOR_FORMAT == COLOR_FORMAT_RGBA8 || TRANSMITTANCE_CHANNELS == 1
#define NODE_WORDS 4
#else
#define NODE_WORDS 5
#endif

layout(std430, binding = STORAGE_BINDING_FRAGMENTS) buffer ListNodes
{
#if NODE_WORDS == 4
  uvec4 listNodes[];
#else
  uint listNodes[];
#endif
};

uint headIndex(ivec2 pixel)
{
  ivec2 at = pixel - frameTile.xy;
  return uint(at.y * frameTile.z + at.x);
}

// The first word of a node.
uint packLink(uint node, uint next, uint coverage)
{
#if SAMPLES > 1
  uint distance = next == 0u ? 0u : (next - node) & LIST_DISTANCE_MASK;
  return coverage << LIST_DISTANCE_BITS | distance;
#else
  return next;
#endif
}

uint unpackNext(uint node, uint link)
{
#if SAMPLES > 1
  int distance = int(link << (32u - LIST_DISTANCE_BITS)) >> (32u - LIST_DISTANCE_BITS);
  return distance == 0 ? 0u : uint(int(node) + distance);
#else
  return link;
#endif
}

uint unpackCoverage(uint link)
{
#if SAMPLES > 1
  return link >> LIST_DISTANCE_BITS;
#else
  return ALL_SAMPLES;
#endif
}

void writeNode(uint index, uint next, Fragment fragment)
{
  uint link = packLink(index + 1u, next, fragment.coverage);
#if NODE_WORDS == 4
  listNodes[index] = uvec4(link, floatBitsToUint(fragment.depth), fragment.color.xy);
#else
  uint word = index * uint(NODE_WORDS);
  listNodes[word] = link;
  listNodes[word + 1u] = floatBitsToUint(fragment.depth);
  listNodes[word + 2u] = fragment.color.x;
#if NODE_WORDS == 5
  listNodes[word + 3u] = fragment.color.y;
  listNodes[word + 4u] = fragment.color.z;
#endif
#endif
}

uint counterOf(ivec2 pixel)
{
  uvec2 cell = uvec2(pixel - frameTile.xy) >> listCellShift;
  return (cell.y * listCellsPerRow + cell.x) * LIST_COUNTER_STRIDE;
}

// About as many fragments as a pixel of the square that begins at this one holds: the mean of its cell, rounded up. 0 only if no
// pixel of the square holds a fragment; a cell is a whole number of squares.
uint squareFragments(ivec2 pixel)
{
  uint counter = counterOf(pixel);
  uint held = listCounters[counter] - listCounters[counter + 1u];
  uint pixels = 1u << (2u * listCellShift);
  return (held + pixels - 1u) / pixels;
}

Fragment loadNode(uint node, out uint next)
{
  uint last = 0u;
#if NODE_WORDS == 4
  uvec4 words = listNodes[node - 1u];
#else
  uint word = (node - 1u) * uint(NODE_WORDS);
  uvec4 words = uvec4(listNodes[word], listNodes[word + 1u], listNodes[word + 2u], 0u);
#if NODE_WORDS == 5
  words.w = listNodes[word + 3u];
  last = listNodes[word + 4u];
#endif
#endif
  next = unpackNext(node, words.x);
  return Fragment(uintBitsToFloat(words.y), PackedColor(uvec3(words.zw, last)), unpackCoverage(words.x));
}

// Where fragments of a pixel are drawn in order, nobody else is at the pixel's head: a plain exchange, which takes less time.
uint exchangeHead(uint at, uint node)
{
#if FRAGMENT_ORDER == FRAGMENT_ORDER_DRAWN
  uint last = listHeads[at];
  listHeads[at] = node;
  return last;
#else
  return atomicExchange(listHeads[at], node);
#endif
}

// depthExtent is how far the fragment's depth reaches within the pixel.
void storeFragment(ivec2 pixel, Fragment fragment, float depthExtent)
{
#if MERGES_SAMPLES
  uint last = listHeads[headIndex(pixel)];
  if (last != 0u)
  {
    uint next;
    Fragment stored = loadNode(last, next);
    if (mayMerge(stored, fragment, depthExtent))
    {
      writeNode(last - 1u, next, mergeFragments(stored, fragment));
      return;
    }
  }
#endif
  uint index = atomicAdd(listCounters[counterOf(pixel)], 1u);
  if (index < listNodeCount)
  {
    uint next = exchangeHead(headIndex(pixel), index + 1u);
    writeNode(index, next, fragment);
  }
}

void linkNode(uint node, uint next)
{
#if NODE_WORDS == 4
#define LINK_OF(node) listNodes[node - 1u].x
#else
#define LINK_OF(node) listNodes[(node - 1u) * uint(NODE_WORDS)]
#endif
#if SAMPLES > 1
  LINK_OF(node) = packLink(node, next, unpackCoverage(LINK_OF(node)));
#else
  LINK_OF(node) = next;
#endif
}

// Puts a fragment behind another one of its pixel, or before all, in a list that nobody else is at. The list is read again before
// anything is drawn again: it must not reach into the next cell's nodes.
void insertFragment(ivec2 pixel, uint after, Fragment fragment)
{
  uint counter = counterOf(pixel);
  uint index = atomicAdd(listCounters[counter], 1u);
  if (index < listCounters[counter + 2u])
  {
    uint next = listHeads[headIndex(pixel)];
    if (after == 0u)
    {
      listHeads[headIndex(pixel)] = index + 1u;
    }
    else
    {
      loadNode(after, next);
      linkNode(after, index + 1u);
    }
    writeNode(index, next, fragment);
  }
}

uint firstFragment(ivec2 pixel)
{
  uint head = listHeads[headIndex(pixel)];
#if SAMPLES > 1
  bool resolved = int(head >> LIST_HEAD_BITS) > resolveSample && resolveSample >= 0;
  return resolved ? 0u : head & LIST_HEAD_MASK;
#else
  return head;
#endif
}

void setFirstFragment(ivec2 pixel, uint node)
{
#if SAMPLES > 1
  node |= listHeads[headIndex(pixel)] & ~LIST_HEAD_MASK;
#endif
  listHeads[headIndex(pixel)] = node;
}

// The pixel, or the sample of it that is being resolved, is done: whoever asks next finds no fragments.
void dropFragments(ivec2 pixel)
{
#if SAMPLES > 1
  uint head = listHeads[headIndex(pixel)] & LIST_HEAD_MASK;
  bool last = resolveSample < 0 || resolveSample == SAMPLES - 1;
  listHeads[headIndex(pixel)] = last ? 0u : uint(resolveSample + 1) << LIST_HEAD_BITS | head;
#else
  listHeads[headIndex(pixel)] = 0u;
#endif
}

bool nextFragment(inout uint cursor, out Fragment fragment)
{
  if (cursor == 0u)
  {
    return false;
  }
  fragment = atSample(loadNode(cursor, cursor));
  return true;
}

#endif
