// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyChain
 * @brief   keeps a technique where a renderer draws what is translucent, whatever passes it is given
 *
 * A renderer has one pass, which may be a chain of them; programs and toolkits replace it to add an effect, and set it
 * to null when the last effect goes. So before each frame the chain is looked at, and where it has changed the
 * technique is put into it anew:
 *
 * - A renderer without a pass gets a vtkTranslucencyRenderStepsPass, which carries out the renderer's own effects.
 * - In a chain the technique takes the place of each pass that draws translucent props: of vtkTranslucentPass, VTK's
 * depth peeling and weighted average, and another technique, within vtkRenderStepsPass, vtkSequencePass, vtkCameraPass,
 * vtkSSAAPass, every vtkImageProcessingPass and vtkShadowMapPass; a vtkDefaultPass becomes a sequence, and the
 * vtkPVDefaultPass of ParaView's views steps that carry out the renderer's effects. Volumes that are drawn next go to
 * techniques that draw them among the surfaces.
 * - A vtkShadowMapPass draws what is opaque, and what steps before it have drawn would be hidden: there the technique
 * is drawn with it, and shadows fall on what is translucent.
 *
 * A chain with ParaView's vtkIceTCompositePass is left alone: it draws together with those of other processes, and
 * waits for all of them.
 *
 * There is one of them a renderer, which owns it.
 */
#ifndef vtkTranslucencyChain_h
#define vtkTranslucencyChain_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucencyABINamespace.h"
#include "vtkWeakPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationObjectBaseKey;
class vtkRenderPass;
class vtkRenderer;
class vtkTranslucencyRenderStepsPass;

class vtkTranslucencyChain : public vtkObject
{
public:
  static vtkTranslucencyChain* New();
  vtkTypeMacro(vtkTranslucencyChain, vtkObject);

  /// Puts a technique into a renderer's chain, in the place of an earlier one. A pass that has no place for it is
  /// replaced, with a warning. False, after an error of the renderer, where the chain is one that is left alone.
  static bool Enable(vtkRenderer* renderer, vtkRenderPass* technique);

  /// The technique in a renderer's chain; null without one.
  static vtkRenderPass* GetTechnique(vtkRenderer* renderer);

  /// Leaves the renderer as it would be if no technique had been put into its chain.
  static void Disable(vtkRenderer* renderer);

protected:
  vtkTranslucencyChain() = default;
  ~vtkTranslucencyChain() override = default;

private:
  vtkTranslucencyChain(const vtkTranslucencyChain&) = delete;
  void operator=(const vtkTranslucencyChain&) = delete;

  void Update(); // before each frame
  void PutIn(bool replaces);
  void TakeOut();
  bool PutInto(vtkRenderPass* owner, vtkRenderPass* pass, bool shadowsFollow);
  bool PutIntoShadows(vtkRenderPass* root);
  bool PutIntoEmptySteps(vtkRenderPass* root);
  void TakeVolumes(vtkRenderPass* owner, vtkRenderPass* before);
  void Exchange(vtkRenderPass* owner, vtkRenderPass* from, vtkRenderPass* to);
  bool Replace(vtkRenderPass* owner, vtkRenderPass* from, vtkRenderPass* to);
  void Release(vtkRenderPass* pass);

  static vtkInformationObjectBaseKey* CHAIN();
  static vtkTranslucencyChain* Find(vtkRenderer* renderer);

  struct Edit
  {
    vtkSmartPointer<vtkRenderPass> Owner; // null: the renderer
    vtkSmartPointer<vtkRenderPass> From;
    vtkSmartPointer<vtkRenderPass> To;
  };

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
  vtkSmartPointer<vtkRenderPass> Technique;
  vtkSmartPointer<vtkTranslucencyRenderStepsPass> Steps;      // for a renderer without a pass
  vtkSmartPointer<vtkTranslucencyRenderStepsPass> StepsBelow; // below a camera pass of ParaView's
  std::vector<Edit> Edits;                                    // by which the technique was put in
  bool TookVolumes = false;
  std::vector<vtkRenderPass*> Tree; // the passes as they were left: compared only, for they may be gone
};
VTK_ABI_NAMESPACE_END

#endif
