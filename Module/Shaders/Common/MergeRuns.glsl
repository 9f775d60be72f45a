// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Common/MergeRuns.glsl: long lists, once for each doubling: pairs of sorted runs become one.
//
// Needs: what the storage's sorting needs.
#include "Common/Statistics.glsl"
#include "Storage/SortList.glsl"

uniform int runLength;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  recordUnfinished(mergeRuns(pixel, uint(runLength)));
  return false;
}

#include "Common/Resolve.glsl"
