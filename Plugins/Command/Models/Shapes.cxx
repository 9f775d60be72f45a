// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "Vectors.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
// Along one edge of the box: the rounding at each end, and one step between them.
double RoundedPosition(double t, double half, double radius)
{
  const double core = half - radius;
  const double bend = 0.4; // of t, for each rounding
  if (t < bend)
  {
    return -core - radius * std::tan((1 - t / bend) * vtkMath::Pi() / 4);
  }
  return t > 1 - bend ? -RoundedPosition(1 - t, half, radius) : core * (2 * (t - bend) / (1 - 2 * bend) - 1);
}
}

//------------------------------------------------------------------------------
vtkVector2d Spline(const std::vector<vtkVector2d>& points, double t)
{
  const int spans = static_cast<int>(points.size()) - 1;
  const double place = std::clamp(t, 0.0, 1.0) * spans;
  const int span = std::min(static_cast<int>(place), spans - 1);
  const double s = place - span;
  const vtkVector2d& from = points[span];
  const vtkVector2d& to = points[span + 1];
  if (from == to)
  {
    return from;
  }
  const vtkVector2d& before = points[std::max(span - 1, 0)];
  const vtkVector2d& after = points[std::min(span + 2, spans)];
  return (from * 2 + (to - before) * s + (before * 2 - from * 5 + to * 4 - after) * (s * s) +
           (from * 3 - before - to * 3 + after) * (s * s * s)) *
    0.5;
}

//------------------------------------------------------------------------------
Mesh Revolve(const std::vector<vtkVector2d>& profile, int sides, int rowsOfSpan)
{
  const Surface surface = [&profile](double u, double v)
  {
    const double angle = -2 * vtkMath::Pi() * u;
    const vtkVector2d point = Spline(profile, v);
    const double radius = std::max(point[0], 0.0);
    return vtkVector3d(radius * std::cos(angle), point[1], radius * std::sin(angle));
  };
  return Tessellate(surface, sides, rowsOfSpan * static_cast<int>(profile.size() - 1));
}

//------------------------------------------------------------------------------
Mesh Ball(double radius, int sides)
{
  const Surface surface = [radius](double u, double v)
  {
    const double angle = -2 * vtkMath::Pi() * u;
    const double polar = vtkMath::Pi() * v;
    return vtkVector3d(radius * std::sin(polar) * std::cos(angle), -radius * std::cos(polar),
      radius * std::sin(polar) * std::sin(angle));
  };
  return Tessellate(surface, sides, sides / 2);
}

//------------------------------------------------------------------------------
Mesh RoundedBox(const vtkVector3d& halfSize, double radius)
{
  Mesh box;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { -1, 1 })
    {
      const int first = (axis + (side > 0 ? 1 : 2)) % 3;
      const int second = (axis + (side > 0 ? 2 : 1)) % 3;
      Mesh face = Tessellate(
        [&](double u, double v)
        {
          vtkVector3d place;
          place[axis] = side * halfSize[axis];
          place[first] = RoundedPosition(u, halfSize[first], radius);
          place[second] = RoundedPosition(v, halfSize[second], radius);
          return place;
        },
        15, 15);
      for (Vertex& vertex : face.Vertices)
      {
        vtkVector3d core;
        for (int i = 0; i < 3; ++i)
        {
          core[i] = std::clamp(vertex.Place[i], radius - halfSize[i], halfSize[i] - radius);
        }
        vertex.Normal = (vertex.Place - core).Normalized();
        vertex.Place = core + vertex.Normal * radius;
      }
      box.Append(face);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
Mesh Rod(const vtkVector3d& from, const vtkVector3d& to, double fromRadius, double toRadius)
{
  const vtkVector3d way = to - from;
  const vtkVector3d across = std::abs(way[1]) > 0.5 * way.Norm() ? vtkVector3d(1, 0, 0) : vtkVector3d(0, 1, 0);
  const vtkVector3d first = way.Cross(across).Normalized();
  const vtkVector3d second = first.Cross(way).Normalized();
  const Surface surface = [&](double u, double v)
  {
    const double angle = 2 * vtkMath::Pi() * u;
    return from + way * v +
      (first * std::cos(angle) + second * std::sin(angle)) * (fromRadius + (toRadius - fromRadius) * v);
  };
  return Tessellate(surface, 24, 16);
}

//------------------------------------------------------------------------------
Mesh Pane(const vtkVector3d (&corners)[4], int columns, int rows)
{
  return Tessellate([&corners](double u, double v)
    { return (corners[0] * (1 - u) + corners[1] * u) * (1 - v) + (corners[3] * (1 - u) + corners[2] * u) * v; },
    columns, rows);
}
