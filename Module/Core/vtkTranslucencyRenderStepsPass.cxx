// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyRenderStepsPass.h"

#include "vtkTranslucencyVTKVersion.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
class StereoCameraPass : public vtkCameraPass
{
public:
  static StereoCameraPass* New();
  vtkTypeMacro(StereoCameraPass, vtkCameraPass);

  void Render(const vtkRenderState* state) override
  {
    vtkRenderer* renderer = state->GetRenderer();
    if (!renderer->IsActiveCameraCreated())
    {
      renderer->ResetCamera();
    }
    renderer->GetActiveCamera()->Render(renderer);
    this->Superclass::Render(state);
  }
};
vtkStandardNewMacro(StereoCameraPass);

void Add(vtkRenderPassCollection* passes, vtkRenderPass* pass)
{
  if (pass)
  {
    passes->AddItem(pass);
  }
}

bool HasWireframes(const vtkRenderState* state)
{
  std::vector<vtkProp*> props;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    props.push_back(vtkTranslucencyProp(state, i));
  }
  return vtkHiddenLineRemovalPass::WireframePropsExist(props.data(), static_cast<int>(props.size()));
}
}

//------------------------------------------------------------------------------
// The step that smooths edges in what has been drawn. (vtkOpenGLFXAAPass is a pass around others instead, which knows
// no options.)
class vtkTranslucencyFXAAStep : public vtkRenderPass
{
public:
  static vtkTranslucencyFXAAStep* New();
  vtkTypeMacro(vtkTranslucencyFXAAStep, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(state->GetRenderer());
    if (renderer->GetFXAAOptions())
    {
      this->Filter->UpdateConfiguration(renderer->GetFXAAOptions());
    }
    this->Filter->Execute(renderer);
  }

  void ReleaseGraphicsResources(vtkWindow*) override { this->Filter->ReleaseGraphicsResources(); }

private:
  vtkNew<vtkOpenGLFXAAFilter> Filter;
};
vtkStandardNewMacro(vtkTranslucencyFXAAStep);
vtkStandardNewMacro(vtkTranslucencyRenderStepsPass);

//------------------------------------------------------------------------------
vtkTranslucencyRenderStepsPass::vtkTranslucencyRenderStepsPass()
{
  vtkNew<StereoCameraPass> camera;
  camera->SetDelegatePass(this->CameraPass->GetDelegatePass());
  this->SetCameraPass(camera);
  this->Shadowed->SetPasses(vtkNew<vtkRenderPassCollection>());
  this->Shadows->SetOpaqueSequence(this->Shadowed);
}

//------------------------------------------------------------------------------
vtkTranslucencyRenderStepsPass::~vtkTranslucencyRenderStepsPass() = default;

//------------------------------------------------------------------------------
void vtkTranslucencyRenderStepsPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->HiddenLines->ReleaseGraphicsResources(window);
  this->Occlusion->ReleaseGraphicsResources(window);
  this->Shadows->GetShadowMapBakerPass()->ReleaseGraphicsResources(window);
  this->Shadows->ReleaseGraphicsResources(window);
  this->FXAA->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
// As vtkOpenGLRenderer::DeviceRenderOpaqueGeometry chooses.
vtkRenderPass* vtkTranslucencyRenderStepsPass::UseOpaquePass(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  if (renderer->GetUseHiddenLineRemoval() && HasWireframes(state))
  {
    return this->HiddenLines;
  }
  if (renderer->GetUseSSAO())
  {
    this->Occlusion->SetDelegatePass(this->OpaquePass);
    this->Occlusion->SetRadius(renderer->GetSSAORadius());
    this->Occlusion->SetBias(renderer->GetSSAOBias());
    this->Occlusion->SetKernelSize(renderer->GetSSAOKernelSize());
    this->Occlusion->SetBlur(renderer->GetSSAOBlur());
    return this->Occlusion;
  }
  return this->OpaquePass;
}

//------------------------------------------------------------------------------
void vtkTranslucencyRenderStepsPass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  if (!this->CameraPass)
  {
    this->RenderBelowCamera(state);
  }
  else if (renderer->GetPass() == this || renderer->GetSelector())
  {
    this->RenderAlone(state);
  }
  else
  {
    this->Superclass::Render(state);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyRenderStepsPass::RenderAlone(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  if (renderer->GetSelector())
  {
    const vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
    renderer->SetPass(nullptr);
    renderer->DeviceRender();
    renderer->SetPass(pass);
    return;
  }
  this->SetUpSteps(state);
  this->NumberOfRenderedProps = 0;
  for (vtkRenderPass* pass : { static_cast<vtkRenderPass*>(this->CameraPass), this->PostProcessPass })
  {
    if (pass)
    {
      pass->Render(state);
      this->NumberOfRenderedProps += pass->GetNumberOfRenderedProps();
    }
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyRenderStepsPass::RenderBelowCamera(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  if (renderer->GetSelector())
  {
    this->UpdateGeometry(renderer, state->GetFrameBuffer());
    return;
  }
  this->SetUpSteps(state);
  this->SequencePass->Render(state);
  this->NumberOfRenderedProps = this->SequencePass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkTranslucencyRenderStepsPass::SetUpSteps(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  vtkRenderPassCollection* passes = this->SequencePass->GetPasses();
  passes->RemoveAllItems();
  Add(passes, this->LightsPass);
  if (renderer->GetUseShadows())
  {
    vtkRenderPassCollection* shadowed = this->Shadowed->GetPasses();
    shadowed->RemoveAllItems();
    for (vtkRenderPass* pass : { this->LightsPass, this->OpaquePass, this->TranslucentPass })
    {
      Add(shadowed, pass);
    }
    passes->AddItem(this->Shadows->GetShadowMapBakerPass());
    passes->AddItem(this->Shadows);
  }
  else
  {
    Add(passes, this->UseOpaquePass(state));
    Add(passes, this->TranslucentPass);
  }
  if (renderer->GetUseFXAA() && vtkTranslucencyPropCount(state) > 0)
  {
    passes->AddItem(this->FXAA);
  }
  Add(passes, this->VolumetricPass);
  Add(passes, this->OverlayPass);
}
VTK_ABI_NAMESPACE_END
