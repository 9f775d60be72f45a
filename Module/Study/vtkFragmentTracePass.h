// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFragmentTracePass
 * @brief   draws the exact picture and keeps a copy of the fragments that it is made of
 *
 * What the simulator of the T-buffer's paper is fed with (section 4): the fragments of a frame, before they are put
 * into order.
 *
 * 1. Gather: all translucent fragments into the storage, as vtkABufferPass does.
 * 2. Trace: a resolve (Shaders/Trace/Resolve.glsl) walks the lists, whatever the storage, and copies them, 24 bytes a
 * fragment.
 * 3. Resolve: as vtkABufferPass does.
 *
 * Fragments are those that the depth test against opaque geometry leaves, in the precision of the storage. Needs a
 * window of one sample a pixel: with several it is an error and nothing is kept. Of transmission colours the mean is
 * taken.
 */
#ifndef vtkFragmentTracePass_h
#define vtkFragmentTracePass_h

#include "vtkABufferPass.h"
#include "vtkStorageSimulator.h"   // for Fragment
#include "vtkTranslucencyBuffer.h" // for Copy

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkFragmentTracePass : public vtkABufferPass
{
public:
  static vtkFragmentTracePass* New();
  vtkTypeMacro(vtkFragmentTracePass, vtkABufferPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The fragments of the last frame, pixel by pixel, row by row from the lowest; those of a pixel in the order of
   * drawing, as far as the driver keeps it. Pixels are the window's. Empty where the frame was drawn by a fallback.
   */
  const std::vector<vtkStorageSimulator::Fragment>& GetFragments() const { return this->Fragments; }

  bool KeepsTransmissionColors() const override { return false; }

protected:
  vtkFragmentTracePass() = default;
  ~vtkFragmentTracePass() override;

  void RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass) override;
  bool UseLists(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

private:
  vtkFragmentTracePass(const vtkFragmentTracePass&) = delete;
  void operator=(const vtkFragmentTracePass&) = delete;

  std::vector<vtkStorageSimulator::Fragment> Fragments;
  vtkTranslucencyBuffer Copy;
};
VTK_ABI_NAMESPACE_END

#endif
