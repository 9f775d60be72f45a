// MultiLayer/Gather.glsl: a fragment goes to its place among the layers of its pixel; if there is then one too many, the farthest goes to the
// tail (Layers.glsl).
//
// Of equal depths, the fragment that comes later is put in front, as in linked lists.
//
// Needs: LAYERS, TAIL, SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: gatherFragment.
#include "Common/Opacity.glsl"
#include "MultiLayer/Layers.glsl"

#if TAIL == TAIL_MERGE
// The farther one behind the nearer one: the over operator of colours that are multiplied by their opacity.
PackedColor mergeLayers(PackedColor nearer, PackedColor farther)
{
  Content front = unpackContent(nearer);
  Content back = unpackContent(farther);
  return packContent(Content(front.color + front.transmittance * back.color, front.transmittance * back.transmittance));
}
#endif

// What became too many; count is that of the record.
void addToTail(PixelRecord record, Layer last, uint count)
{
#if TAIL == TAIL_MERGE
  int word = (LAYERS - 1) * LAYER_WORDS + 1;
  setRecordColor(record, word, mergeLayers(recordColor(record, word), last.color));
#elif TAIL == TAIL_AVERAGE
  Content layer = unpackContent(last.color);
  Tail tail = Tail(vec3(0.0), Channels(0.0), Channels(1.0));
  if (count > uint(LAYERS))
  {
    tail = loadTail(record, TAIL_WORD);
  }
  tail.color += layer.color;
  tail.opacity += 1.0 - layer.transmittance;
  tail.transmittance *= layer.transmittance;
  storeTail(record, TAIL_WORD, tail);
  setRecordCount(record, uint(LAYERS + 1));
#endif
}

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
    addToTail(record, carried, count);
  }
}

#include "Common/GatherPixels.glsl"
