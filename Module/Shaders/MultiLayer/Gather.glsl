// MultiLayer/Gather.glsl: multi-layer alpha blending (Salvi and Vaidyanathan 2014): a fragment goes to its place among the layers of its
// pixel; if there is then one too many, the two farthest become one.
//
// Of equal depths, the fragment that comes later is put in front, as in linked lists.
//
// Needs: LAYERS, SAMPLES.  Gives: gatherFragment.
#include "MultiLayer/Layers.glsl"

// The farther one behind the nearer one: the over operator of colours that are multiplied by their opacity.
uvec2 mergeLayers(uvec2 nearer, uvec2 farther)
{
  vec4 front = unpackHalves(nearer);
  vec4 back = unpackHalves(farther);
  return packHalves(vec4(front.rgb + front.a * back.rgb, front.a * back.a));
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
    Layer last = loadLayer(record, LAYERS - 1);
    last.color = mergeLayers(last.color, carried.color);
    storeLayer(record, LAYERS - 1, last);
  }
}

#include "Common/GatherPixels.glsl"
