// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdditiveTransparencyPass
 * @brief   translucent surfaces that shine: they brighten what lies behind and hide nothing
 *
 * Additive blending, as in the survey "Transparency, alpha, compositing" (Real-Time Rendering, 4th edition, 5.5): each
 * fragment adds its opacity times its colour. A sum, so the order of the fragments does not matter and nothing is
 * approximated; where it passes what the window can show it saturates. For glow, sparks, and drawings like X-ray
 * pictures.
 *
 * Everything behind a surface is seen in any case: transmission colours change nothing.
 *
 * Stages:
 * 1. Gather: blending adds opacity times colour to a buffer of floats, so that many faint surfaces are not lost to
 * rounding (16 bytes a pixel and sample).
 * 2. Composite: the sum is added to the opaque picture.
 */
#ifndef vtkAdditiveTransparencyPass_h
#define vtkAdditiveTransparencyPass_h

#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyTargets.h" // for Sum

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkAdditiveTransparencyPass : public vtkTranslucencyPass
{
public:
  static vtkAdditiveTransparencyPass* New();
  vtkTypeMacro(vtkAdditiveTransparencyPass, vtkTranslucencyPass);

  bool KeepsTransmissionColors() const override { return true; }

protected:
  vtkAdditiveTransparencyPass() = default;
  ~vtkAdditiveTransparencyPass() override;

  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

private:
  vtkTranslucencyTargets Sum;

  vtkAdditiveTransparencyPass(const vtkAdditiveTransparencyPass&) = delete;
  void operator=(const vtkAdditiveTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
