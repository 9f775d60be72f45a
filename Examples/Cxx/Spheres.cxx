// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Three translucent spheres that overlap, drawn into spheres.png or the file named on the command line.
#include <vtkActor.h>
#include <vtkAdaptiveTransparencyPass.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

void AddSphere(vtkRenderer* renderer, double x, double y, double red, double green, double blue)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(x, y, 0);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->SetOpacity(0.4);
  renderer->AddActor(actor);
}

int main(int argc, char* argv[])
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  AddSphere(renderer, -0.25, 0, 0.9, 0.3, 0.1);
  AddSphere(renderer, 0.25, 0, 0.1, 0.6, 0.2);
  AddSphere(renderer, 0, 0.4, 0.1, 0.3, 0.9);

  vtkNew<vtkAdaptiveTransparencyPass> pass;
  pass->SetNodeCount(16);
  renderer->SetPass(pass);

  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "spheres.png");
  writer->Write();
  return 0;
}
