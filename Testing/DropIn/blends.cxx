// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
// A program that knows nothing of this project and never asks for depth peeling, unless it is told to:
//   blends FILE HOW [peeling]
// HOW: renderer, or viewer: a class of renderer of its own that switches peeling off in each
// frame and draws by passes into a framebuffer of theirs, as F3D does.
#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkFramebufferPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderWindow.h"
#include "vtkSequencePass.h"
#include "vtkSphereSource.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"
#include "vtkWindowToImageFilter.h"

#include <string>

namespace
{
class Viewer : public vtkOpenGLRenderer
{
public:
  static Viewer* New();
  vtkTypeMacro(Viewer, vtkOpenGLRenderer);

  void Render() override
  {
    this->SetUseDepthPeeling(false);
    this->Superclass::Render();
  }

protected:
  Viewer()
  {
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(vtkNew<vtkLightsPass>());
    passes->AddItem(vtkNew<vtkOpaquePass>());
    passes->AddItem(vtkNew<vtkTranslucentPass>());
    passes->AddItem(vtkNew<vtkVolumetricPass>());
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    vtkNew<vtkFramebufferPass> framebuffer;
    framebuffer->SetColorFormat(vtkTextureObject::Float32);
    framebuffer->SetDepthFormat(vtkTextureObject::Fixed32);
    framebuffer->SetDelegatePass(camera);
    this->SetPass(framebuffer);
  }
};
vtkStandardNewMacro(Viewer);

void AddBall(vtkRenderer* renderer, double x, double y, double z, const double (&color)[3])
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, y, z);
  source->SetPhiResolution(40);
  source->SetThetaResolution(40);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(0.5);
  renderer->AddActor(actor);
}
}

int main(int count, char** words)
{
  if (count < 3)
  {
    return 2;
  }
  const bool peeling = count > 3;
  const bool viewer = !peeling && std::string(words[2]) == "viewer";
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(400, 300);
  auto renderer =
    viewer ? vtkSmartPointer<vtkRenderer>(vtkSmartPointer<Viewer>::New()) : vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(0.2, 0.3, 0.4);
  renderer->SetUseDepthPeeling(peeling);
  renderer->SetMaximumNumberOfPeels(100);
  renderer->SetOcclusionRatio(0);
  window->AddRenderer(renderer);
  AddBall(renderer, 0, 0, 0, { 1, 0.2, 0.2 });
  AddBall(renderer, 0.2, 0.1, -0.4, { 0.2, 1, 0.2 });
  AddBall(renderer, -0.1, 0.2, 0.5, { 0.2, 0.3, 1 });
  window->Render();

  vtkNew<vtkWindowToImageFilter> reader;
  reader->SetInput(window);
  reader->ReadFrontBufferOff();
  reader->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(words[1]);
  writer->SetInputConnection(reader->GetOutputPort());
  writer->Write();
  return 7;
}
