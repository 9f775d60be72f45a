#include "vtkTranslucencyRenderStepsPass.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

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
}

vtkStandardNewMacro(vtkTranslucencyRenderStepsPass);

//------------------------------------------------------------------------------
vtkTranslucencyRenderStepsPass::vtkTranslucencyRenderStepsPass()
{
  vtkNew<StereoCameraPass> camera;
  camera->SetDelegatePass(this->CameraPass->GetDelegatePass());
  this->SetCameraPass(camera);
}

//------------------------------------------------------------------------------
void vtkTranslucencyRenderStepsPass::Render(const vtkRenderState* state)
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
  this->Superclass::Render(state);
}
