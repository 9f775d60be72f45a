// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SectionPlaces.glsl: fragments in sections of SECTION_LENGTH, which lie one behind the other: the T-buffer, and with
// OWN_SECTIONS 1 the M-buffer; where they are, and how they are read.
//
// T-buffer: a pixel that holds nothing has no section, only an entry in the start-section table. M-buffer: each pixel
// has a section of its own, of its own number, and its entry is the pointer memory's. Both take another section when
// one is full; nextSections (the next-section table, the pointer memory) then tells which one was filled before. A
// pixel's entry names the section that is being filled, so that fragments are read in the reverse order of drawing, as
// from linked lists: the papers' chains begin with the oldest section; entries and accesses are as many.
//
// An entry is the section's number, counted from 1, and how many places in it are free; 0 is a pixel that holds
// nothing. Fragments are called by their place + 1: going back one place takes no access, and only from a section's
// first place the next section is looked up.
//
// Links. Sorting and volumes change the order of a pixel's fragments: those that have been moved have a link of their
// own, which the cursor's highest bit tells. NODE_LINKS is 0 where there are none, 1 where lists are moved that have
// not been before, 2 where some have been.
//
// Needs: SECTION_LENGTH, SECTION_FREE_BITS (the bits of what may be free), OWN_SECTIONS, NODE_LINKS, COLOR_FORMAT,
// SAMPLES, TRANSMITTANCE_CHANNELS, FRAGMENT_ORDER.
// Gives: placeRoom, readPlace, writePlace, lastOf, claimFrom, countPixel, and of what Shaders/README.md asks of a
// storage all but storeFragment.
#ifndef SectionPlaces_glsl
#define SectionPlaces_glsl
#ifndef SECTION_LENGTH
#error "Storage/SectionPlaces.glsl needs SECTION_LENGTH"
#endif
#ifndef SECTION_FREE_BITS
#error "Storage/SectionPlaces.glsl needs SECTION_FREE_BITS"
#endif
#ifndef OWN_SECTIONS
#error "Storage/SectionPlaces.glsl needs OWN_SECTIONS"
#endif
#ifndef NODE_LINKS
#error "Storage/SectionPlaces.glsl needs NODE_LINKS"
#endif
#define READS_COUNT 1
#if OWN_SECTIONS
#define TABLE_COUNTS 0 // pointers are read at the same time as fragments
#else
#define TABLE_COUNTS 1
#endif
#define UNIT_LENGTH SECTION_LENGTH
#include "Common/Fragment.glsl"
#include "Common/Order.glsl"
#include "Storage/Heads.glsl"

// A fragment is its depth, the words of the colour that are in use, and its coverage where that is not of all samples.
#if COLOR_FORMAT == COLOR_FORMAT_RGBA8 && TRANSMITTANCE_CHANNELS == 1
#define COLOR_WORDS 1
#elif COLOR_FORMAT == COLOR_FORMAT_RGBA8 || TRANSMITTANCE_CHANNELS == 1
#define COLOR_WORDS 2
#else
#define COLOR_WORDS 3
#endif
#if SAMPLES > 1
#define PLACE_WORDS (COLOR_WORDS + 2)
#define ENTRY_BITS HEAD_BITS
#else
#define PLACE_WORDS (COLOR_WORDS + 1)
#define ENTRY_BITS 32
#endif
#define LINKED (1u << uint(ENTRY_BITS - 1))

#define SECTION_WORDS (SECTION_LENGTH * PLACE_WORDS)
layout(std430, binding = STORAGE_BINDING_FRAGMENTS) buffer Places
{
#if PLACE_WORDS == 4
  uvec4 places[];
#else
  uint places[]; // words: fragments of a section are written by several invocations, and a vector may hold some of two
#endif
};

layout(std430, binding = STORAGE_BINDING_NEXT) buffer NextSections
{
  uint nextSections[];
};

#if FRAGMENTS_READ_ONLY
uniform usamplerBuffer fragmentTexels; // four words each
uniform usamplerBuffer nextTexels;
#define NEXT_SECTION(section) texelFetch(nextTexels, int(section)).x
#else
#define NEXT_SECTION(section) nextSections[section]
#endif

#if NODE_LINKS
layout(std430, binding = STORAGE_BINDING_LINKS) buffer Links
{
  uint links[];
};
#endif

uint ownSections()
{
#if OWN_SECTIONS
  return uint(frameTile.z * frameTile.w);
#else
  return 0u;
#endif
}

void writePlace(uint place, Fragment fragment)
{
#if PLACE_WORDS == 4 && SAMPLES > 1
  places[place] = uvec4(floatBitsToUint(fragment.depth), fragment.color.xy, fragment.coverage);
#elif PLACE_WORDS == 4
  places[place] = uvec4(floatBitsToUint(fragment.depth), fragment.color);
#else
  uint word = place * uint(PLACE_WORDS);
  places[word] = floatBitsToUint(fragment.depth);
  places[word + 1u] = fragment.color.x;
#if COLOR_WORDS > 1
  places[word + 2u] = fragment.color.y;
#endif
#if COLOR_WORDS > 2
  places[word + 3u] = fragment.color.z;
#endif
#if SAMPLES > 1
  places[word + uint(PLACE_WORDS - 1)] = fragment.coverage;
#endif
#endif
}

// A fragment of words, read by WORD(index).
#if COLOR_WORDS == 1
#define COLOR_OF(WORD) PackedColor(uvec3(WORD(1), 0u, 0u))
#elif COLOR_WORDS == 2
#define COLOR_OF(WORD) PackedColor(uvec3(WORD(1), WORD(2), 0u))
#else
#define COLOR_OF(WORD) PackedColor(uvec3(WORD(1), WORD(2), WORD(3)))
#endif
#if SAMPLES > 1
#define COVERAGE_OF(WORD) WORD(PLACE_WORDS - 1)
#else
#define COVERAGE_OF(WORD) ALL_SAMPLES
#endif
#define FRAGMENT_OF(WORD) Fragment(uintBitsToFloat(WORD(0)), COLOR_OF(WORD), COVERAGE_OF(WORD))

Fragment readPlace(uint place)
{
#if PLACE_WORDS == 4
#if FRAGMENTS_READ_ONLY
  uvec4 words = texelFetch(fragmentTexels, int(place));
#else
  uvec4 words = places[place];
#endif
#define WORD_OF_VECTOR(index) words[index]
  return FRAGMENT_OF(WORD_OF_VECTOR);
#else
  uint first = place * uint(PLACE_WORDS);
#define WORD_OF_PLACE(index) places[first + uint(index)]
  return FRAGMENT_OF(WORD_OF_PLACE);
#endif
}

void storeColor(uint node, PackedColor color)
{
  Fragment fragment = readPlace((node & ~LINKED) - 1u);
  fragment.color = color;
  writePlace((node & ~LINKED) - 1u, fragment);
}

uint sectionOf(uint entry)
{
  return entry >> SECTION_FREE_BITS;
}

uint freeOf(uint entry)
{
  return entry & ((1u << SECTION_FREE_BITS) - 1u);
}

// The fragment that was drawn last, of an entry in which no fragments are linked.
uint lastOf(uint entry)
{
  return entry == 0u ? 0u : sectionOf(entry) * uint(SECTION_LENGTH) - freeOf(entry);
}

// The one drawn before it.
uint beforeInSections(uint node)
{
  uint place = node - 1u;
  uint section = place / uint(SECTION_LENGTH);
  if (place != section * uint(SECTION_LENGTH))
  {
    return place;
  }
#if OWN_SECTIONS
  return section < ownSections() ? 0u : NEXT_SECTION(section - ownSections()) * uint(SECTION_LENGTH);
#else
  return NEXT_SECTION(section) * uint(SECTION_LENGTH);
#endif
}

Fragment loadNode(uint node, out uint next)
{
  COUNT_READ();
#if NODE_LINKS == 2
  uint number = node & ~LINKED;
  next = node != number ? links[number - 1u] : beforeInSections(number);
  return readPlace(number - 1u);
#else
  next = beforeInSections(node);
  return readPlace(node - 1u);
#endif
}

// A place of a pixel with that entry; gives the entry as it is afterwards. taken is a section that was taken from the
// cell, 0 if none was yet.
uint claimFrom(uint entry, uint at, uint counter, inout uint taken, out uint place)
{
  uint section = sectionOf(entry);
  uint left = freeOf(entry);
#if OWN_SECTIONS
  section = entry == 0u ? at + 1u : section;
  left = entry == 0u ? uint(SECTION_LENGTH) : left;
#endif
  if (left == 0u)
  {
    uint unit = taken == 0u ? takeUnit(counter) : taken - ownSections() - 1u;
    if (unit < cellUnits)
    {
      nextSections[unit] = section;
    }
    taken = unit + ownSections() + 1u;
    section = taken;
    left = uint(SECTION_LENGTH);
  }
  place = section * uint(SECTION_LENGTH) - left;
  return section << SECTION_FREE_BITS | (left - 1u);
}

// After a fragment has got a place: its pixel held none before if the entry was 0.
void countPixel(uint entry, uint counter)
{
#if OWN_SECTIONS
  if (entry == 0u)
  {
    atomicAdd(cells[counter + CELL_PIXELS], 1u);
  }
#endif
}

// The places of all sections.
uint placeRoom()
{
  return (cellUnits + ownSections()) * uint(SECTION_LENGTH);
}

uint firstFragment(ivec2 pixel)
{
  uint head = headOf(pixel);
#if NODE_LINKS == 2
  return (head & LINKED) != 0u ? head : lastOf(head);
#else
  return lastOf(head);
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

// As many fragments as are read together: a section, where blocks of 8 are whole sections and none has been moved.
// Those that are not there are empty. Gives the number of those that are.
#if NODE_LINKS < 2 && (SECTION_LENGTH == 2 || SECTION_LENGTH == 4 || SECTION_LENGTH == 8)
#define READ_GROUP SECTION_LENGTH

#if FRAGMENTS_READ_ONLY
uint nextGroup(inout uint cursor, out Fragment group[READ_GROUP])
{
  for (int i = 0; i < READ_GROUP; ++i)
  {
    group[i] = EMPTY_FRAGMENT(BLOCK_EMPTY);
  }
  uint count = 0u;
  if (cursor != 0u)
  {
    uint section = (cursor - 1u) / uint(SECTION_LENGTH);
    count = cursor - section * uint(SECTION_LENGTH);
    uint words[SECTION_WORDS];
#if SECTION_WORDS % 4 == 0
    for (int i = 0; i < SECTION_WORDS; i += 4)
    {
      uvec4 four = texelFetch(fragmentTexels, int(section) * (SECTION_WORDS / 4) + i / 4);
      words[i] = four.x;
      words[i + 1] = four.y;
      words[i + 2] = four.z;
      words[i + 3] = four.w;
    }
#else
    for (int i = 0; i < SECTION_WORDS; ++i)
    {
      words[i] = places[section * uint(SECTION_WORDS) + uint(i)];
    }
#endif
    for (int i = 0; i < READ_GROUP; ++i)
    {
      int place = READ_GROUP - 1 - i;
#define WORD_OF_SECTION(index) words[place * PLACE_WORDS + (index)]
      if (uint(place) < count)
      {
        group[i] = atSample(FRAGMENT_OF(WORD_OF_SECTION));
      }
    }
    cursor = beforeInSections(section * uint(SECTION_LENGTH) + 1u);
  }
  return count;
}
#endif
#else
#define READ_GROUP 1
#endif

#if NODE_LINKS
// What the sorting has to call a node whose link it changes.
uint linkedNode(uint node)
{
  return node | LINKED;
}

// The same as loadNode, of a node that has been moved.
Fragment loadLinked(uint node, out uint next)
{
  uint number = node & ~LINKED;
  next = links[number - 1u];
  return readPlace(number - 1u);
}

void linkNode(uint node, uint next)
{
  links[(node & ~LINKED) - 1u] = next;
}

void setFirstFragment(ivec2 pixel, uint node)
{
  setHead(pixel, node);
}

// A fragment in a place of its own, before another one. Gives what it is called.
uint storeLinked(uint place, uint next, Fragment fragment)
{
  uint node = place + ownSections() * uint(SECTION_LENGTH) + 1u;
  writePlace(node - 1u, fragment);
  linkNode(node, next);
  return linkedNode(node);
}
#endif

#endif
