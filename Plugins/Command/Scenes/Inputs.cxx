// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "Basics/Failure.h"
#include "Basics/Progress.h"
#include "BuiltInScenes.h"
#include "Isosurfaces.h"
#include "LabelVolume.h"
#include "Readers.h"
#include "Streamtubes.h"

#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"

#include <algorithm>
#include <filesystem>

namespace
{
constexpr double MeshOpacity = 0.4;
constexpr double HullOpacity = 0.12; // round the isosurfaces inside it

// The surface as it is read, or, where that has no normals, with such as keep edges sharp.
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface)
{
  if (surface->GetPointData()->GetNormals() || surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    return surface;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(60);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

void AddSurface(const Input& input, vtkPolyData* surface, double opacity, Scene& scene)
{
  CheckSurface(input.Source, surface);
  Part part = MakePart(input.Source, WithNormals(surface));
  const Color color = input.Tint.value_or(DistinctColor(static_cast<int>(scene.Parts.size())));
  SetLook(part, color, input.Opacity.value_or(opacity), input.Transmission);
  scene.Parts.push_back(part);
}

// Neither surfaces nor streamlines come out of a slice; VTK's tracer would follow vectors out of it.
void CheckDimensions(const Input& input, vtkImageData* volume)
{
  const int* dimensions = volume->GetDimensions();
  if (dimensions[0] < 2 || dimensions[1] < 2 || dimensions[2] < 2)
  {
    throw Failure(input.Source + ": is " + std::to_string(dimensions[0]) + "x" + std::to_string(dimensions[1]) + "x" +
      std::to_string(dimensions[2]) + " points, expected a volume of at least 2x2x2");
  }
}

void AddVolume(const Input& input, vtkImageData* volume, Scene& scene)
{
  const bool labels = input.Volume == Input::Meaning::Labels ||
    (input.Volume == Input::Meaning::Automatic && input.Isovalues.empty() &&
      (!input.Labels.empty() || IsLabelVolume(volume)));
  if (labels)
  {
    AddLabels(input, volume, scene);
  }
  else if (AddIsosurfaces(input, volume, scene) == 0)
  {
    throw Failure(
      input.Source + ": has no surface to show, expected point scalars of one component with two values or more");
  }
}

void AddGrid(const Input& input, vtkDataSet* grid, Scene& scene)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  CheckSurface(input.Source, surface->GetOutput());
  const int inside = AddIsosurfaces(input, grid, scene);
  Input hull = input;
  if (inside > 0)
  {
    hull.Tint = input.Tint.value_or(Color{ { 0.6, 0.65, 0.7 } });
  }
  AddSurface(hull, surface->GetOutput(), inside > 0 ? HullOpacity : MeshOpacity, scene);
}

// Files with materials keep them, save what the input sets; where all is opaque, it becomes as translucent as other
// meshes.
void AddActors(const Input& input, const std::vector<vtkSmartPointer<vtkActor>>& actors, Scene& scene)
{
  const bool opaque = std::none_of(
    actors.begin(), actors.end(), [](vtkActor* actor) { return actor->HasTranslucentPolygonalGeometry(); });
  for (const auto& actor : actors)
  {
    Part part;
    part.Name = input.Source;
    part.Actor = actor;
    Color color;
    actor->GetProperty()->GetColor(color.data());
    SetLook(part, input.Tint.value_or(color),
      input.Opacity.value_or(opaque ? MeshOpacity : actor->GetProperty()->GetOpacity()), input.Transmission);
    scene.Parts.push_back(part);
  }
}

void AddParts(const Input& input, Scene& scene)
{
  if (AddBuiltInScene(input, scene))
  {
    return;
  }
  const std::string name = std::filesystem::path(input.Source).filename().string();
  Progress progress("reading");
  progress.Step(name);
  const FileContents contents = ReadFile(input.Source);
  auto* volume = vtkImageData::SafeDownCast(contents.Data);
  if (volume)
  {
    CheckDimensions(input, volume);
  }
  if (input.Tubes)
  {
    AddStreamtubes(input, contents.Data, scene);
  }
  else if (!contents.Actors.empty())
  {
    AddActors(input, contents.Actors, scene);
  }
  else if (volume)
  {
    AddVolume(input, volume, scene);
  }
  else if (auto* surface = vtkPolyData::SafeDownCast(contents.Data))
  {
    AddSurface(input, surface, MeshOpacity, scene);
  }
  else
  {
    AddGrid(input, vtkDataSet::SafeDownCast(contents.Data), scene);
  }
}
}

//------------------------------------------------------------------------------
void AddInput(const Input& input, Scene& scene)
{
  const std::size_t before = scene.Parts.size();
  AddParts(input, scene);
  for (std::size_t i = before; i < scene.Parts.size() && input.Material; ++i)
  {
    vtkTranslucencyMaterial::SetMaterial(scene.Parts[i].Actor, input.Material);
  }
}

//------------------------------------------------------------------------------
std::string InputSuffixes()
{
  return ReadableSuffixes();
}
