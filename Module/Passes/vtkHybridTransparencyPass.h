// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHybridTransparencyPass
 * @brief   the k nearest fragments of a pixel, exactly, and the mean of all others
 *
 * Maule et al., "Hybrid transparency" (I3D 2013): the nearest fragments dominate what is seen, and are blended exactly
 * (the core); the others are weighted by their opacity and averaged (the tail). As vtkMultiLayerAlphaBlendingPass, with
 * Tail Average by default. What shows through is exact, and the picture does not depend on the order of drawing but for
 * the rounding of sums. With transmission colours the weights are the opacities of each channel; where fragments of the
 * tail hide next to nothing of a channel, their light adds up.
 */
#ifndef vtkHybridTransparencyPass_h
#define vtkHybridTransparencyPass_h

#include "vtkMultiLayerAlphaBlendingPass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkHybridTransparencyPass : public vtkMultiLayerAlphaBlendingPass
{
public:
  static vtkHybridTransparencyPass* New();
  vtkTypeMacro(vtkHybridTransparencyPass, vtkMultiLayerAlphaBlendingPass);

protected:
  vtkHybridTransparencyPass()
    : vtkMultiLayerAlphaBlendingPass(Average)
  {
  }
  ~vtkHybridTransparencyPass() override = default;

private:
  vtkHybridTransparencyPass(const vtkHybridTransparencyPass&) = delete;
  void operator=(const vtkHybridTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
