// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkListPeeling
 *
 * Peels up to six layers of a pixel in a drawing of the geometry, into targets: BucketSort of vtkDepthPeelPass where
 * the driver has no storage buffers. vtkDepthPeelPass tells how.
 */
#ifndef vtkListPeeling_h
#define vtkListPeeling_h

#include "vtkPeelingSettings.h"
#include "vtkTranslucencyStage.h"
#include "vtkTranslucencyTargets.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyFrame;

class vtkListPeeling
{
public:
  /// Draws the current tile.
  bool Render(vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings);

  vtkTypeInt64 GetBytes() const;
  void Release(bool contextAlive);

private:
  bool Peel(vtkTranslucencyFrame& frame, const vtkTranslucencyGathering& gathering);
  bool AddTail(vtkTranslucencyFrame& frame, const vtkTranslucencyGathering& gathering);
  std::vector<vtkTranslucencyStage::Input> GetLists() const;

  vtkTranslucencyTargets Drawn;                 // by the last drawing: buckets, listed layers
  std::array<vtkTranslucencyTargets, 2> States; // before and after a merge (Shaders/Peel/MergeLists.glsl)
  int Current = 0;                              // of the states
};
VTK_ABI_NAMESPACE_END

#endif
