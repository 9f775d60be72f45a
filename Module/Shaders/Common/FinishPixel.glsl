// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// FinishPixel.glsl: what every resolve ends a pixel with.
//
// Needs: what the storage needs.  Gives: finishPixel.
#ifndef FinishPixel_glsl
#define FinishPixel_glsl
#include "Common/Samples.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

// All count fragments of the pixel have been composited, which is of no use if its samples differ: then they are
// resolved one by one.
void finishPixel(ivec2 pixel, uint count)
{
  recordFragments(count);
  if (samplesAgree())
  {
    dropFragments(pixel);
  }
  else
  {
    leaveToLevel(pixel, LEVEL_EACH_SAMPLE);
  }
}

#endif
