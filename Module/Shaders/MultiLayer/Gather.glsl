// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// MultiLayer/Gather.glsl: a fragment goes to its place among the layers of its pixel; if there is then one too many,
// the farthest goes to the tail (Layers.glsl).
//
// Of equal depths, the fragment that comes later is put in front, as in linked lists.
//
// Needs: LAYERS, TAIL, COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: gatherFragment.
#include "Common/Opacity.glsl"
#include "MultiLayer/Layers.glsl"
#define NODE_COUNT LAYERS
#include "Adaptive/EachNode.glsl" // also of layers

#if TAIL == TAIL_MERGE
// The farther one behind the nearer one: the over operator of colours that are multiplied by their opacity.
PackedColor mergeLayers(PackedColor nearer, PackedColor farther)
{
  Content front = unpackContent(nearer);
  Content back = unpackContent(farther);
  return packContent(Content(front.color + front.transmittance * back.color, front.transmittance * back.transmittance));
}
#endif

// What became too many; continues says whether something did before.
void addToTail(PixelRecord record, Layer last, bool continues)
{
#if TAIL == TAIL_MERGE
  storeColor(record, LAYERS - 1, mergeLayers(loadColor(record, LAYERS - 1), last.color));
#elif TAIL == TAIL_AVERAGE
  Content layer = unpackContent(last.color);
  Tail tail = Tail(vec3(0.0), Channels(0.0), Channels(1.0));
  if (continues)
  {
    tail = loadTail(record, TAIL_WORD);
  }
  tail.color += layer.color;
  tail.opacity += 1.0 - layer.transmittance;
  tail.transmittance *= layer.transmittance;
  storeTail(record, TAIL_WORD, tail);
#endif
}

#if RECORD_TARGETS
// All layers are in registers: the fragment takes the place of the first that is not in front of it, that one takes the
// place of the next, and so on.
void updatePixel(PixelRecord record, vec4 color, float depth)
{
  Layer carried = Layer(depth, packContent(Content(color.a * color.rgb, 1.0 - opacityOf(color))));
  Layer layer;
  bool stays;
#define EXCHANGE(k) \
  layer = loadLayer(record, k); \
  stays = layer.depth < depth; \
  storeLayer(record, k, Layer(stays ? layer.depth : carried.depth, stays ? layer.color : carried.color)); \
  carried = Layer(stays ? carried.depth : layer.depth, stays ? carried.color : layer.color);
  EACH_NODE(EXCHANGE)
  if (carried.depth != EMPTY_NUMBER)
  {
    addToTail(record, carried, TAIL == TAIL_AVERAGE && recordFloat(record, TAIL_WORD) != EMPTY_NUMBER);
  }
}
#else
// Layers are moved where they lie: what few fragments need of a long record.
void updatePixel(PixelRecord record, vec4 color, float depth)
{
  uint count = recordCount(record);
  Layer carried = Layer(depth, packContent(Content(color.a * color.rgb, 1.0 - opacityOf(color))));
  uint kept = min(count, uint(LAYERS));
  uint place = 0u;
  for (int i = 0; i < LAYERS; ++i)
  {
    if (uint(i) < kept && layerDepth(record, i) < depth)
    {
      ++place;
    }
  }
  for (; place < kept; ++place)
  {
    Layer layer = loadLayer(record, int(place));
    storeLayer(record, int(place), carried);
    carried = layer;
  }
  if (count < uint(LAYERS))
  {
    storeLayer(record, int(count), carried);
    setRecordCount(record, count + 1u);
  }
  else
  {
    addToTail(record, carried, count > uint(LAYERS));
    setRecordCount(record, uint(LAYERS + (TAIL == TAIL_AVERAGE ? 1 : 0)));
  }
}
#endif

#include "Common/GatherPixels.glsl"
