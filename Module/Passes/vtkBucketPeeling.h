// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBucketPeeling
 *
 * Peels up to 32 layers of a pixel in a drawing of the geometry: BucketSort of vtkDepthPeelPass, which tells how.
 */
#ifndef vtkBucketPeeling_h
#define vtkBucketPeeling_h

#include "vtkPeelingSettings.h"
#include "vtkTranslucencyPixels.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyFrame;

class vtkBucketPeeling
{
public:
  /// Draws the current tile, with buckets that take no more than the limit (MiB, 0 for the default).
  bool Render(vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings, double memoryLimit);

  vtkTypeInt64 GetBytes() const { return this->Buckets.GetBytes(); }
  void Release(bool contextAlive) { this->Buckets.Release(contextAlive); }

private:
  vtkTranslucencyPixels Buckets;
};
VTK_ABI_NAMESPACE_END

#endif
