// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Peel/ResolveBuckets.glsl: a pixel's colour, or that of a sample of it: all that has been peeled.
//
// Needs: BUCKETS, BUCKET_SIZE, SAMPLES, TRANSMITTANCE_CHANNELS.
#include "Peel/Buckets.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  Front front = loadFront(sampleRecord());
  color = front.color;
  transmittance = front.transmittance;
  return color != vec3(0.0) || transmittance != Channels(1.0);
}

#include "Common/Composite.glsl"
