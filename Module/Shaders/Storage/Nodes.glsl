// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Nodes.glsl: fragments with a link to another one of their pixel, or to the next one of a queue.
//
// Node n is called n + 1, so that 0 ends a list. With several samples a pixel, a link is the distance to the next node
// in 24 bits (0: none), so that the coverage finds room beside it.
//
// Needs: COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS, NODE_LINKS, UNIT_LENGTH (nodes that a pixel
// takes at a time), and may have NODE_PAIRS (Storage/NodesInOrder.glsl).
// Gives: nodeRoom, writeNode, and of what Shaders/README.md asks of a storage all but storeFragment and READ_GROUP.
#ifndef Nodes_glsl
#define Nodes_glsl
#ifndef NODE_LINKS
#error "Storage/Nodes.glsl needs NODE_LINKS"
#endif
#include "Common/Fragment.glsl"
#include "Storage/Heads.glsl"

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

#define FETCH_NODES (FRAGMENTS_READ_ONLY && NODE_WORDS <= MOST_TEXEL_WORDS)
#if FETCH_NODES
uniform usamplerBuffer fragmentTexels;
#endif

// Nodes that the buffer has room for.
uint nodeRoom()
{
#if NODE_WORDS == 4
  return uint(listNodes.length());
#else
  return uint(listNodes.length()) / uint(NODE_WORDS);
#endif
}

// The first word of a node.
uint packLink(uint node, uint next, uint coverage)
{
#if SAMPLES > 1
  uint distance = next == 0u ? 0u : (next - node) & LINK_MASK;
  return coverage << LINK_BITS | distance;
#else
  return next;
#endif
}

uint unpackNext(uint node, uint link)
{
#if SAMPLES > 1
  int distance = int(link << (32u - LINK_BITS)) >> (32u - LINK_BITS);
  return distance == 0 ? 0u : uint(int(node) + distance);
#else
  return link;
#endif
}

uint unpackCoverage(uint link)
{
#if SAMPLES > 1
  return link >> LINK_BITS;
#else
  return ALL_SAMPLES;
#endif
}

void writeNode(uint index, uint next, Fragment fragment)
{
  uint link = packLink(index + 1u, next, fragment.coverage);
#if defined(NODE_PAIRS) && NODE_WORDS == 4
  nodePairs[index] =
    u64vec2(packUint2x32(uvec2(link, floatBitsToUint(fragment.depth))), packUint2x32(fragment.color.xy));
#elif NODE_WORDS == 4
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

Fragment loadNode(uint node, out uint next)
{
  COUNT_READ();
  uint last = 0u;
#if FETCH_NODES
  uvec4 words = texelFetch(fragmentTexels, int(node) - 1);
#elif NODE_WORDS == 4
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

void storeColor(uint node, PackedColor color)
{
#if NODE_WORDS == 4
  listNodes[node - 1u].zw = color.xy;
#else
  uint word = (node - 1u) * uint(NODE_WORDS);
  listNodes[word + 2u] = color.x;
#if NODE_WORDS == 5
  listNodes[word + 3u] = color.y;
  listNodes[word + 4u] = color.z;
#endif
#endif
}

void linkNode(uint node, uint next)
{
#if NODE_WORDS == 4
#define LINK_OF(node) listNodes[(node) - 1u].x
#else
#define LINK_OF(node) listNodes[((node) - 1u) * uint(NODE_WORDS)]
#endif
#if SAMPLES > 1
  LINK_OF(node) = packLink(node, next, unpackCoverage(LINK_OF(node)));
#else
  LINK_OF(node) = next;
#endif
}

// What the sorting has to call a node whose link it changes.
uint linkedNode(uint node)
{
  return node;
}

Fragment loadLinked(uint node, out uint next)
{
  return loadNode(node, next);
}

uint firstFragment(ivec2 pixel)
{
  return headOf(pixel);
}

void setFirstFragment(ivec2 pixel, uint node)
{
  setHead(pixel, node);
}

// A fragment in a place of its own, before another one. Gives what it is called.
uint storeLinked(uint place, uint next, Fragment fragment)
{
  writeNode(place, next, fragment);
  return place + 1u;
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
