// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/ResolveFetched.glsl: the colour of a pixel by the sums in its record (Record.glsl), where records lie in
// colours.
//
// Needs: NODE_COUNT, ESTIMATE_ERROR, ALPHA_CORRECTION, SAMPLES, TRANSMITTANCE_CHANNELS.
#define RECORDS_READ_ONLY 1
#include "Adaptive/Record.glsl"
#include "Common/AlphaCorrection.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  PixelRecord record = sampleRecord();
  if (fragmentCount(record) == 0u)
  {
    return false;
  }
  Tail tail = loadTail(record, RECORD_SUMS);
  WeightedSums sums;
  clearWeights(sums);
  sums.color = tail.color;
  sums.weights = tail.opacity;
  transmittance = tail.transmittance;
  color = correctedColor(sums, transmittance);
  return true;
}

#include "Common/Composite.glsl"
