// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyRenderStepsPass
 * @brief   vtkRenderStepsPass with what a renderer does without a pass and that one leaves out
 *
 * - Stereo: vtkRenderer lets its camera set itself up before it draws, which tells the camera whether the window is in
 * stereo. VTK's camera pass does not: under it both eyes see the picture from the middle between them.
 * - Selection: vtkHardwareSelector draws the props itself, to give each its number. Under VTK's passes it is not asked
 * to, and selects nothing.
 * - Effects: UseHiddenLineRemoval, UseSSAO, UseShadows and UseFXAA of the renderer, where it draws by these steps
 * alone, are carried out by the passes that vtkOpenGLRenderer takes for them, in its order. As they are looked at in
 * every frame, they may be set at any time. As without a pass, lines are hidden instead of darkened where both are
 * asked for, and shadows leave out both. With shadows vtkOpenGLRenderer does not draw what is translucent: here it is
 * drawn, and shadows fall on it.
 *
 * Within other passes the effects of the renderer don't hold, as with VTK's own steps. They do below a camera pass that
 * somebody else keeps, where these steps have none (SetCameraPass(nullptr)): so ParaView's views draw, whose
 * vtkPVDefaultPass leaves all of it to the renderer.
 */
#ifndef vtkTranslucencyRenderStepsPass_h
#define vtkTranslucencyRenderStepsPass_h

#include "vtkNew.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkHiddenLineRemovalPass;
class vtkSSAOPass;
class vtkSequencePass;
class vtkShadowMapPass;
class vtkTranslucencyFXAAStep;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyRenderStepsPass : public vtkRenderStepsPass
{
public:
  static vtkTranslucencyRenderStepsPass* New();
  vtkTypeMacro(vtkTranslucencyRenderStepsPass, vtkRenderStepsPass);

  void Render(const vtkRenderState* state) override;

  /// What Render does where these steps are the renderer's pass.
  void RenderAlone(const vtkRenderState* state);

  /// What Render does below somebody else's camera pass.
  void RenderBelowCamera(const vtkRenderState* state);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTranslucencyRenderStepsPass();
  ~vtkTranslucencyRenderStepsPass() override;

private:
  vtkTranslucencyRenderStepsPass(const vtkTranslucencyRenderStepsPass&) = delete;
  void operator=(const vtkTranslucencyRenderStepsPass&) = delete;

  vtkRenderPass* UseOpaquePass(const vtkRenderState* state);
  void SetUpSteps(const vtkRenderState* state);

  vtkNew<vtkHiddenLineRemovalPass> HiddenLines;
  vtkNew<vtkSSAOPass> Occlusion;
  vtkNew<vtkShadowMapPass> Shadows;
  vtkNew<vtkSequencePass> Shadowed; // what Shadows draws
  vtkNew<vtkTranslucencyFXAAStep> FXAA;
};
VTK_ABI_NAMESPACE_END

#endif
