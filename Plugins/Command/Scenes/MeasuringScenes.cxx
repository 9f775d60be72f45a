// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInParts.h"

#include "Basics/Specification.h"
#include "Inputs.h"
#include "Models/Cards.h"
#include "Models/Random.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <algorithm>

//------------------------------------------------------------------------------
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
    const double z = random.Next(-1, 1);
    const double y = random.Next(-1, 1);
    const double x = random.Next(-1.33, 1.33);
    sphere->SetCenter(x, y, z);
    sphere->Update();
    Part part = MakePart("sphere " + std::to_string(i), sphere->GetOutput());
    const Color color{ { random.Next(0.1, 1), random.Next(0.1, 1), random.Next(0.1, 1) } };
    SetLook(part, input.Tint.value_or(color), input.Opacity.value_or(0.3), input.Transmission);
    scene.Parts.push_back(part);
  }
}

//------------------------------------------------------------------------------
// Overlapping unlit rectangles at random depths, drawn in no order of depth: nothing costs but the blending. Each
// covers 2.6 % of a picture of 4 to 3 on the average. meshes: 1 draws all at once, as many as rectangles each as an
// actor.
void AddRectangles(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 300, 1, 100000);
  const int meshes = std::min(wanted.GetInteger("meshes", count, 1, 100000), count);
  const double width = 4;
  const double height = 3;
  Input look = input;
  look.Opacity.reset(); // in the place of each rectangle's
  Random random(wanted.GetInteger("seed", 1, 1, 1000000));
  for (int mesh = 0; mesh < meshes; ++mesh)
  {
    Cards rectangles;
    for (int i = mesh * count / meshes; i < (mesh + 1) * count / meshes; ++i)
    {
      const double w = random.Next(0.08, 0.24) * width;
      const double h = random.Next(0.08, 0.24) * height;
      const double x = random.Next(0, width - w);
      const double y = random.Next(0, height - h);
      const double z = random.Next(-1, 0);
      const std::array<double, 4> color = { { random.Next(0, 255), random.Next(0, 255), random.Next(0, 255),
        255 * input.Opacity.value_or(random.Next(0.02, 0.3)) } };
      rectangles.All.push_back({ vtkVector3d(x, y, z), vtkVector3d(w, 0, 0), vtkVector3d(0, h, 0), color });
    }
    scene.Parts.push_back(CardPart(look, "rectangles " + std::to_string(mesh), rectangles, nullptr));
  }
  scene.Eye.Position = { { width / 2, height / 2, 10 } };
  scene.Eye.Target = { { width / 2, height / 2, 0 } };
  scene.Eye.Up = { { 0, 1, 0 } };
  scene.Eye.Height = height;
}
