// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// MultiLayer/Resolve.glsl: the layers of a pixel, or a sample of it, one behind the other, and what its tail holds
// behind them: the mean colour, as opaque as all of it together.
//
// Needs: LAYERS, TAIL, COLOR_FORMAT, SAMPLES, TRANSMITTANCE_CHANNELS.
#define RECORDS_READ_ONLY 1
#include "Common/MeanColor.glsl"
#include "MultiLayer/Layers.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  PixelRecord record = sampleRecord();
  uint count = countLayers(record);
  for (int i = 0; i < LAYERS; ++i)
  {
    if (uint(i) < count)
    {
      Content layer = unpackContent(loadLayer(record, i).color);
      color += transmittance * layer.color;
      transmittance *= layer.transmittance;
    }
  }
#if TAIL == TAIL_AVERAGE
  if (count > uint(LAYERS))
  {
    Tail tail = loadTail(record, TAIL_WORD);
    color += transmittance * meanColor(tail.color, tail.opacity, tail.transmittance);
    transmittance *= tail.transmittance;
  }
#endif
  return count > 0u;
}

#include "Common/Composite.glsl"
