// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Room.h"

#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkLight.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

namespace
{
vtkSmartPointer<vtkActor> NewActor(vtkPolyDataAlgorithm* source, double red, double green, double blue, double opacity)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

void Show(const std::vector<vtkActor*>& actors, bool shown)
{
  for (vtkActor* actor : actors)
  {
    actor->SetVisibility(shown);
  }
}
}

//------------------------------------------------------------------------------
Room::Room(int samples, const vtkSmartPointer<vtkRenderer>& renderer)
  : Renderer(renderer)
{
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(samples);
  this->Window->SetSize(60, 50);
  this->Window->AddRenderer(renderer);
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-1.2, -1, -0.8);
  wall->SetPoint1(1.2, -1, -0.8);
  wall->SetPoint2(-1.2, 0.9, -0.8);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.45);
  ball->SetCenter(-0.3, 0.1, -0.3);
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(0.6);
  cube->SetYLength(0.6);
  cube->SetZLength(0.4);
  cube->SetCenter(0.6, -0.2, -0.4);
  const auto frame = NewActor(cube, 1, 1, 1, 1);
  frame->GetProperty()->SetRepresentationToWireframe();
  for (const auto& actor : { NewActor(wall, 0.6, 0.7, 0.8, 1), NewActor(ball, 0.3, 0.8, 0.4, 1), frame })
  {
    renderer->AddActor(actor);
  }
  this->Quads = { this->AddQuad(-0.9, -0.6, 0.4, 0.8), this->AddQuad(0.1, -0.5, 0.5, 0.7) };
  for (double depth : { 0.2, 0.7, 0.0 })
  {
    this->Others.push_back(this->AddQuad(-0.5 + depth, -0.3, depth, 0.8));
  }
  vtkNew<vtkLight> light; // by which shadows are thrown
  light->SetPositional(true);
  light->SetConeAngle(40);
  light->SetPosition(1, 2, 4);
  light->SetFocalPoint(0, 0, 0);
  renderer->AddLight(light);
  renderer->SetBackground(0.2, 0.3, 0.4);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 4);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetClippingRange(2, 8);
}

//------------------------------------------------------------------------------
vtkActor* Room::AddQuad(double x, double y, double z, double size)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x, y, z);
  plane->SetPoint1(x + size, y, z - 0.3);
  plane->SetPoint2(x, y + size, z);
  const auto quad = NewActor(plane, 0.9, 0.4 + 0.2 * x, 0.3, 0.5);
  this->Renderer->AddActor(quad);
  return quad;
}

//------------------------------------------------------------------------------
void Room::ShowTranslucent(bool shown)
{
  Show(this->Quads, shown);
  Show(this->Others, shown);
}

//------------------------------------------------------------------------------
void Room::ShowOthers(bool shown)
{
  Show(this->Others, shown);
}

//------------------------------------------------------------------------------
Picture Room::Render()
{
  this->Window->Render();
  return Capture(this->Window);
}

//------------------------------------------------------------------------------
bool BlendsOneSurface(const std::string& technique)
{
  return technique != "additive" && technique != "screendoor" && technique != "stochastic";
}
