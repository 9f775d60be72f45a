// MultiLayer/Resolve.glsl: the layers of a pixel, or a sample of it, one behind the other.
//
// Needs: LAYERS, SAMPLES.
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
  return count > 0u;
}

#include "Common/Composite.glsl"
