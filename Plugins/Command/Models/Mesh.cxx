// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh.h"
#include "Vectors.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkVector3d Turned(const vtkVector3d& v, const vtkVector3d& axis, double radians)
{
  return v * std::cos(radians) + axis.Cross(v) * std::sin(radians) + axis * (axis.Dot(v) * (1 - std::cos(radians)));
}

// Where the surface shrinks to a point, as at a pole, the normal is that beside it.
vtkVector3d NormalOf(const Surface& surface, double u, double v)
{
  const double step = 1e-4;
  const double inside = v + (v < 0.5 ? 10 : -10) * step;
  for (const double row : { v, inside })
  {
    const vtkVector3d alongU = surface(u + step, row) - surface(u - step, row);
    const vtkVector3d alongV = surface(u, std::min(row + step, 1.0)) - surface(u, std::max(row - step, 0.0));
    const vtkVector3d normal = alongU.Cross(alongV);
    if (normal.Norm() > 1e-6 * step * step)
    {
      return normal.Normalized();
    }
  }
  return vtkVector3d(0, 1, 0);
}

unsigned char Byte(double part)
{
  return static_cast<unsigned char>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
}
}

//------------------------------------------------------------------------------
Paint Blend(const Paint& first, const Paint& second, double share)
{
  const double t = std::clamp(share, 0.0, 1.0);
  const auto mix = [t](double a, double b) { return a + (b - a) * t; };
  return { mix(first.Red, second.Red), mix(first.Green, second.Green), mix(first.Blue, second.Blue),
    mix(first.Opacity, second.Opacity) };
}

//------------------------------------------------------------------------------
Mesh& Mesh::Append(const Mesh& other)
{
  const int first = static_cast<int>(this->Vertices.size());
  this->Vertices.insert(this->Vertices.end(), other.Vertices.begin(), other.Vertices.end());
  for (const auto& triangle : other.Triangles)
  {
    this->Triangles.push_back({ { first + triangle[0], first + triangle[1], first + triangle[2] } });
  }
  return *this;
}

//------------------------------------------------------------------------------
Mesh& Mesh::Move(const vtkVector3d& offset)
{
  for (Vertex& vertex : this->Vertices)
  {
    vertex.Place = vertex.Place + offset;
  }
  return *this;
}

//------------------------------------------------------------------------------
Mesh& Mesh::Turn(const vtkVector3d& axis, double degrees)
{
  const double radians = vtkMath::RadiansFromDegrees(degrees);
  for (Vertex& vertex : this->Vertices)
  {
    vertex.Place = Turned(vertex.Place, axis, radians);
    vertex.Normal = Turned(vertex.Normal, axis, radians);
  }
  return *this;
}

//------------------------------------------------------------------------------
Mesh& Mesh::Scale(double factor)
{
  for (Vertex& vertex : this->Vertices)
  {
    vertex.Place = vertex.Place * factor;
  }
  return *this;
}

//------------------------------------------------------------------------------
Mesh& Mesh::Cover(const Paint& paint)
{
  return this->Cover([&paint](const Vertex&) { return paint; });
}

//------------------------------------------------------------------------------
Mesh& Mesh::Cover(const std::function<Paint(const Vertex&)>& paint)
{
  for (Vertex& vertex : this->Vertices)
  {
    vertex.Look = paint(vertex);
  }
  return *this;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Mesh::ToPolyData(bool opaque) const
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(opaque ? 3 : 4);
  for (const Vertex& vertex : this->Vertices)
  {
    points->InsertNextPoint(vertex.Place.GetData());
    normals->InsertNextTuple(vertex.Normal.GetData());
    const Paint& look = vertex.Look;
    const unsigned char color[4] = { Byte(look.Red), Byte(look.Green), Byte(look.Blue), Byte(look.Opacity) };
    colors->InsertNextTypedTuple(color);
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : this->Triangles)
  {
    const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
    cells->InsertNextCell(3, corners);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->SetNormals(normals);
  surface->GetPointData()->SetScalars(colors);
  return surface;
}

//------------------------------------------------------------------------------
Mesh Tessellate(const Surface& surface, int columns, int rows)
{
  Mesh mesh;
  for (int row = 0; row <= rows; ++row)
  {
    for (int column = 0; column <= columns; ++column)
    {
      const double u = static_cast<double>(column) / columns;
      const double v = static_cast<double>(row) / rows;
      mesh.Vertices.push_back({ surface(u, v), NormalOf(surface, u, v), {} });
    }
  }
  const auto place = [&mesh](int vertex) { return mesh.Vertices[vertex].Place; };
  const auto add = [&mesh, &place](int a, int b, int c)
  {
    if ((place(b) - place(a)).Cross(place(c) - place(a)).Norm() > 0) // not at a pole
    {
      mesh.Triangles.push_back({ { a, b, c } });
    }
  };
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const int a = row * (columns + 1) + column;
      const int b = a + columns + 1;
      add(a, a + 1, b + 1);
      add(a, b + 1, b);
    }
  }
  return mesh;
}
