// MultiLayer/Gather.glsl: a fragment goes to its place among the layers of its pixel; if there is then one too many, the farthest goes to the
// tail (Layers.glsl).
//
// Of equal depths, the fragment that comes later is put in front, as in linked lists.
//
// Needs: LAYERS, TAIL, SAMPLES.  Gives: gatherFragment.
#include "MultiLayer/Layers.glsl"

#if TAIL == TAIL_MERGE
// The farther one behind the nearer one: the over operator of colours that are multiplied by their opacity.
uvec2 mergeLayers(uvec2 nearer, uvec2 farther)
{
  vec4 front = unpackHalves(nearer);
  vec4 back = unpackHalves(farther);
  return packHalves(vec4(front.rgb + front.a * back.rgb, front.a * back.a));
}
#endif

// What became too many; count is that of the record.
void addToTail(PixelRecord record, Layer last, uint count)
{
#if TAIL == TAIL_MERGE
  Layer before = loadLayer(record, LAYERS - 1);
  before.color = mergeLayers(before.color, last.color);
  storeLayer(record, LAYERS - 1, before);
#elif TAIL == TAIL_AVERAGE
  vec4 layer = unpackHalves(last.color);
  Tail tail = Tail(vec4(0.0), 1.0);
  if (count > uint(LAYERS))
  {
    tail = loadTail(record);
  }
  tail.sums += vec4(layer.rgb, 1.0 - layer.a);
  tail.transmittance *= layer.a;
  storeTail(record, tail);
  setRecordCount(record, uint(LAYERS + 1));
#endif
}

void updatePixel(PixelRecord record, vec4 color, float depth)
{
  uint count = recordCount(record);
  Layer carried = Layer(depth, packHalves(vec4(color.a * color.rgb, 1.0 - color.a)));
  for (int i = 0; i < LAYERS; ++i)
  {
    if (uint(i) < count)
    {
      Layer layer = loadLayer(record, i);
      if (carried.depth <= layer.depth)
      {
        storeLayer(record, i, carried);
        carried = layer;
      }
    }
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
