// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Adaptive/ShowFixed.glsl: a pixel, or a sample of it, by its record in fixed memory.
//
// Needs: SHOW, NODE_COUNT, NODE_REMOVAL, ALPHA_CORRECTION, ESTIMATE_ERROR, SAMPLES.
#include "Adaptive/Record.glsl"
#include "Adaptive/Show.glsl"
#include "Adaptive/Visibility.glsl"
#include "Common/RecordNumbers.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  PixelRecord record = sampleRecord();
  int count = min(int(recordCount(record)), NODE_COUNT);
  float error = 0.0;
#if ESTIMATE_ERROR
  error = estimateError(recordFloat(record, RECORD_LOST),
    recordFloat(record, RECORD_NEAREST), recordFloat(record, RECORD_FARTHEST));
#endif
  showPixel(error, count, color, transmittance);
  return count > 0;
}

#include "Common/Composite.glsl"
