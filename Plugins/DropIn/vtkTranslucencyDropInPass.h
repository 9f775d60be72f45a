// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyDropInPass
 * @brief   a depth peeling pass that draws by another technique
 *
 * To whoever made it, it is a vtkDualDepthPeelingPass; MaximumNumberOfPeels and OcclusionRatio mean nothing to it.
 * Volumes are drawn among the surfaces where it was given a VolumetricPass, as depth peeling does.
 */
#ifndef vtkTranslucencyDropInPass_h
#define vtkTranslucencyDropInPass_h

#include "vtkDualDepthPeelingPass.h"
#include "vtkSmartPointer.h"

class vtkTranslucencyDropInPass : public vtkDualDepthPeelingPass
{
public:
  static vtkTranslucencyDropInPass* New();
  vtkTypeMacro(vtkTranslucencyDropInPass, vtkDualDepthPeelingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The pass that draws, a vtkTranslucencyFactory's. Must be set.
  void SetTechnique(vtkRenderPass* technique) { this->Technique = technique; }

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTranslucencyDropInPass() = default;
  ~vtkTranslucencyDropInPass() override = default;

private:
  vtkTranslucencyDropInPass(const vtkTranslucencyDropInPass&) = delete;
  void operator=(const vtkTranslucencyDropInPass&) = delete;

  vtkSmartPointer<vtkRenderPass> Technique;
};

#endif
