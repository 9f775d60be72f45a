// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Basics/Failure.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNamedColors.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTranslucencyPass.h"

#include <cmath>
#include <regex>

namespace
{
long long CountTriangles(vtkPolyData* surface)
{
  long long triangles = 0;
  for (vtkCellArray* cells : { surface->GetPolys(), surface->GetStrips() })
  {
    // A polygon or a strip of n points is n - 2 triangles.
    triangles += cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
  }
  return triangles;
}
}

//------------------------------------------------------------------------------
void CheckSurface(const std::string& name, vtkPolyData* surface)
{
  if (surface->GetNumberOfCells() == 0)
  {
    throw Failure(name + ": has no cells, expected at least one");
  }
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* point = surface->GetPoint(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!std::isfinite(point[axis]))
      {
        throw Failure(name + ": coordinate " + "xyz"[axis] + " of point " + std::to_string(i) + " is " +
          std::to_string(point[axis]) + ", expected a finite number");
      }
    }
  }
}

//------------------------------------------------------------------------------
Part MakePart(const std::string& name, vtkPolyData* surface)
{
  CheckSurface(name, surface);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  Part part;
  part.Name = name;
  part.Actor = vtkSmartPointer<vtkActor>::New();
  part.Actor->SetMapper(mapper);
  // A little gloss: it shows where a surface bends also where it is thin.
  part.Actor->GetProperty()->SetSpecular(0.2);
  part.Actor->GetProperty()->SetSpecularPower(30);
  return part;
}

//------------------------------------------------------------------------------
Background BackgroundOf(const Scene& scene)
{
  return scene.Behind.value_or(Color{ { 1, 1, 1 } });
}

//------------------------------------------------------------------------------
void SetLook(const Part& part, const Color& color, double opacity, const std::optional<Color>& transmission)
{
  part.Actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  part.Actor->GetProperty()->SetOpacity(opacity);
  if (transmission)
  {
    vtkTranslucencyPass::SetTransmissionColor(part.Actor, (*transmission)[0], (*transmission)[1], (*transmission)[2]);
  }
}

//------------------------------------------------------------------------------
long long CountTriangles(const Scene& scene)
{
  long long triangles = 0;
  for (const Part& part : scene.Parts)
  {
    triangles += CountTriangles(vtkPolyData::SafeDownCast(part.Actor->GetMapper()->GetInputDataObject(0, 0)));
  }
  return triangles;
}

//------------------------------------------------------------------------------
Color ParseColor(const std::string& what, const std::string& text)
{
  static const std::regex hexadecimal("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})");
  vtkNew<vtkNamedColors> colors;
  vtkColor4ub found;
  if (std::regex_match(text, hexadecimal))
  {
    found = colors->HTMLColorToRGBA(text);
  }
  else if (!text.empty() && colors->ColorExists(text))
  {
    found = colors->GetColor4ub(text);
  }
  else
  {
    throw Failure(what + " is '" + text + "', expected #rrggbb or the name of a colour, such as white or steelblue");
  }
  return { { found.GetRed() / 255.0, found.GetGreen() / 255.0, found.GetBlue() / 255.0 } };
}

//------------------------------------------------------------------------------
Background ParseBackground(const std::string& what, const std::string& text)
{
  return text == "transparent" ? Background() : ParseColor(what, text);
}

//------------------------------------------------------------------------------
Color DistinctColor(int index)
{
  // Hues a golden section apart never meet; three kinds of strength keep neighbours in hue apart.
  const double goldenSection = 0.61803398875;
  const double hue = std::fmod(0.56 + index * goldenSection, 1.0);
  const double saturation[] = { 0.72, 0.5, 0.85 };
  const double value[] = { 0.85, 0.95, 0.7 };
  Color color;
  vtkMath::HSVToRGB(hue, saturation[index % 3], value[index % 3], &color[0], &color[1], &color[2]);
  return color;
}
