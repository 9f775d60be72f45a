// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInScenes.h"

#include "Basics/Failure.h"
#include "Basics/Specification.h"
#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkMapper.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace
{
class Random
{
public:
  explicit Random(int seed) { this->Sequence->SetSeed(seed); }
  double Next(double low, double high) { return this->Sequence->GetNextRangeValue(low, high); }

private:
  vtkNew<vtkMinimalStandardRandomSequence> Sequence;
};

// Overlapping spheres of 20,000 triangles each, in a box: geometry and lighting count as much as blending.
void AddSpheres(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 40, 1, 10000);
  Random random(wanted.GetInteger("seed", 1, 1, 1000000));
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(100);
    sphere->SetPhiResolution(102);
    sphere->SetRadius(0.9);
    sphere->SetCenter(random.Next(-1.33, 1.33), random.Next(-1, 1), random.Next(-1, 1));
    sphere->Update();
    Part part = MakePart("sphere " + std::to_string(i), sphere->GetOutput());
    const Color color{ { random.Next(0.1, 1), random.Next(0.1, 1), random.Next(0.1, 1) } };
    SetLook(part, input.Tint.value_or(color), input.Opacity.value_or(0.3), input.Transmission);
    scene.Parts.push_back(part);
  }
}

// Rectangles with a colour at each corner, as one mesh.
class RectangleMesh
{
public:
  RectangleMesh() { this->Colors->SetNumberOfComponents(4); }

  void Add(double x, double y, double z, double width, double height, const double color[4])
  {
    vtkIdType corners[4];
    for (int corner = 0; corner < 4; ++corner)
    {
      const bool right = corner == 1 || corner == 2;
      const bool top = corner >= 2;
      corners[corner] = this->Points->InsertNextPoint(x + (right ? width : 0), y + (top ? height : 0), z);
      this->Colors->InsertNextTuple(color);
    }
    this->Cells->InsertNextCell(4, corners);
  }

  Part Finish(const std::string& name)
  {
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(this->Points);
    surface->SetPolys(this->Cells);
    surface->GetPointData()->SetScalars(this->Colors);
    Part part = MakePart(name, surface);
    part.Actor->GetMapper()->ScalarVisibilityOn();
    part.Actor->GetProperty()->LightingOff();
    part.Actor->ForceTranslucentOn();
    return part;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
};

// Overlapping unlit rectangles at random depths, drawn in no order of depth: nothing costs but the blending. Each
// covers 2.6 % of a picture of 4 to 3 on the average. meshes: 1 draws all at once, as many as rectangles each as an
// actor.
void AddRectangles(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 300, 1, 100000);
  const int meshes = std::min(wanted.GetInteger("meshes", count, 1, 100000), count);
  const double width = 4;
  const double height = 3;
  Random random(wanted.GetInteger("seed", 1, 1, 1000000));
  for (int mesh = 0; mesh < meshes; ++mesh)
  {
    RectangleMesh rectangles;
    for (int i = mesh * count / meshes; i < (mesh + 1) * count / meshes; ++i)
    {
      const double w = random.Next(0.08, 0.24) * width;
      const double h = random.Next(0.08, 0.24) * height;
      const double x = random.Next(0, width - w);
      const double y = random.Next(0, height - h);
      const double z = random.Next(-1, 0);
      const double color[4] = { random.Next(0, 255), random.Next(0, 255), random.Next(0, 255),
        255 * input.Opacity.value_or(random.Next(0.02, 0.3)) };
      rectangles.Add(x, y, z, w, h, color);
    }
    const Part part = rectangles.Finish("rectangles " + std::to_string(mesh));
    SetLook(part, { { 1, 1, 1 } }, 1, input.Transmission); // colour and opacity are the mesh's
    scene.Parts.push_back(part);
  }
  scene.Eye.Position = { { width / 2, height / 2, 10 } };
  scene.Eye.Target = { { width / 2, height / 2, 0 } };
  scene.Eye.Up = { { 0, 1, 0 } };
  scene.Eye.Height = height;
}

struct BuiltInScene
{
  const char* Name;
  const char* Help;
  std::vector<std::string> Keys;
  void (*Add)(const Input& input, const Specification& wanted, Scene& scene);
};

const BuiltInScene BuiltInScenes[] = {
  { "scene:spheres", "overlapping spheres of 20,000 triangles, opacity 0.3 (count=40:seed=1)", { "count", "seed" },
    AddSpheres },
  { "scene:rectangles",
    "overlapping unlit rectangles, opacity 0.02 to 0.3, parallel projection "
    "(count=300:meshes=300:seed=1)",
    { "count", "meshes", "seed" }, AddRectangles },
};
}

//------------------------------------------------------------------------------
bool AddBuiltInScene(const Input& input, Scene& scene)
{
  const std::string prefix = "scene:";
  if (input.Source.compare(0, prefix.size(), prefix) != 0)
  {
    return false;
  }
  const Specification wanted(input.Source.substr(prefix.size()));
  std::string names;
  for (const BuiltInScene& builtIn : BuiltInScenes)
  {
    names += (names.empty() ? "" : ", ") + std::string(builtIn.Name);
    if (prefix + wanted.Name == builtIn.Name)
    {
      wanted.CheckKeys(builtIn.Keys);
      builtIn.Add(input, wanted, scene);
      return true;
    }
  }
  throw Failure("there is no scene '" + prefix + wanted.Name + "', expected one of: " + names);
}

//------------------------------------------------------------------------------
std::string BuiltInSceneHelp()
{
  std::string help;
  for (const BuiltInScene& builtIn : BuiltInScenes)
  {
    help += "  " + std::string(builtIn.Name) + "  " + builtIn.Help + "\n";
  }
  return help;
}
