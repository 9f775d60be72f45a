// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKBufferPass
 * @brief   the k nearest fragments of a pixel, exactly, and no others
 *
 * Bavoil et al., "Multi-fragment effects on the GPU using the k-buffer" (I3D 2007), with the read-modify-write of a
 * pixel in a critical section instead of races. As vtkMultiLayerAlphaBlendingPass, with Tail Drop by default: exact
 * where no more than Layers surfaces lie behind each other; what lies farther is not drawn. Transmission colours are
 * kept.
 */
#ifndef vtkKBufferPass_h
#define vtkKBufferPass_h

#include "vtkMultiLayerAlphaBlendingPass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkKBufferPass : public vtkMultiLayerAlphaBlendingPass
{
public:
  static vtkKBufferPass* New();
  vtkTypeMacro(vtkKBufferPass, vtkMultiLayerAlphaBlendingPass);

protected:
  vtkKBufferPass()
    : vtkMultiLayerAlphaBlendingPass(Drop)
  {
  }
  ~vtkKBufferPass() override = default;

private:
  vtkKBufferPass(const vtkKBufferPass&) = delete;
  void operator=(const vtkKBufferPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
