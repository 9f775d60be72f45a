// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Three translucent spheres that overlap, drawn into a file by a technique: Spheres [spheres.png [adaptive]]
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyPass.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>

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
  actor->GetProperty()->SetOpacity(0.7);
  renderer->AddActor(actor);
}

int main(int argc, char* argv[])
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  AddSphere(renderer, -0.25, 0, 0.9, 0.3, 0.1);
  AddSphere(renderer, 0.25, 0, 0.1, 0.6, 0.2);
  AddSphere(renderer, 0, 0.4, 0.1, 0.3, 0.9);

  vtkRenderPass* technique = vtkTranslucencyFactory::Enable(renderer, argc > 2 ? argv[2] : "adaptive");
  if (!technique)
  {
    return 1; // after an error that names the techniques
  }

  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  window->Render();

  if (auto* pass = vtkTranslucencyPass::SafeDownCast(technique)) // blend and VTK's other two have no statistics
  {
    vtkTranslucencyStatistics* statistics = pass->GetStatistics();
    std::cout << statistics->GetFragments() << " fragments, at most " << statistics->GetDeepestPixel()
              << " in a pixel, " << statistics->GetBytes() << " bytes\n";
  }

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "spheres.png");
  writer->Write();
  return 0;
}
