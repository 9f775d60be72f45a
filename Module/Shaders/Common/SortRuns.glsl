// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Common/SortRuns.glsl: long lists, first step: every 32 fragments of a list become a sorted run.
//
// Needs: what the storage's sorting needs.
#include "Common/Statistics.glsl"
#include "Storage/SortList.glsl"

bool resolvePixel(ivec2 pixel, inout vec3 color, inout Channels transmittance)
{
  uint cursor;
  recordFragments(sortRuns(pixel, cursor));
  recordUnfinished(cursor);
  return false;
}

#include "Common/Resolve.glsl"
