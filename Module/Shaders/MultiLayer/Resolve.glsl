// MultiLayer/Resolve.glsl: the layers of a pixel, or a sample of it, one behind the other, and what its tail holds behind them: the mean colour,
// as opaque as all of it together.
//
// Needs: LAYERS, TAIL, SAMPLES.
#include "MultiLayer/Layers.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
#if SAMPLES > 1
  PixelRecord record = pixelRecord(pixel, gl_SampleID);
#else
  PixelRecord record = pixelRecord(pixel, 0);
#endif
  uint count = recordCount(record);
  for (int i = 0; i < LAYERS; ++i)
  {
    if (uint(i) < count)
    {
      vec4 layer = unpackHalves(loadLayer(record, i).color);
      color += transmittance * layer.rgb;
      transmittance *= layer.a;
    }
  }
#if TAIL == TAIL_AVERAGE
  if (count > uint(LAYERS))
  {
    Tail tail = loadTail(record);
    color += transmittance * (1.0 - tail.transmittance) * tail.sums.rgb / max(tail.sums.a, 1e-30);
    transmittance *= tail.transmittance;
  }
#endif
  return count > 0u;
}

#include "Common/Composite.glsl"
