// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Triangles with a colour and an opacity at each corner: many things can be one mesh, and so one actor.
 */
#ifndef Mesh_h
#define Mesh_h

#include "vtkSmartPointer.h"
#include "vtkVector.h"

#include <array>
#include <functional>
#include <vector>

class vtkPolyData;

/// All of 0 to 1.
struct Paint
{
  double Red = 1;
  double Green = 1;
  double Blue = 1;
  double Opacity = 1;
};

/// Between the two: the first where share is 0 or less, the second where it is 1 or more.
Paint Blend(const Paint& first, const Paint& second, double share);

struct Vertex
{
  vtkVector3d Place;
  vtkVector3d Normal;
  Paint Look;
};

struct Mesh
{
  std::vector<Vertex> Vertices;
  std::vector<std::array<int, 3>> Triangles;

  Mesh& Append(const Mesh& other);
  Mesh& Move(const vtkVector3d& offset);
  Mesh& Turn(const vtkVector3d& axis, double degrees); ///< about a unit vector through the origin
  Mesh& Scale(double factor);
  Mesh& Cover(const Paint& paint);
  Mesh& Cover(const std::function<Paint(const Vertex&)>& paint);

  /// With normals, and colours of three components, or of four if the opacities are to count.
  vtkSmartPointer<vtkPolyData> ToPolyData(bool opaque) const;
};

/// A point of a surface for each u and v of 0 to 1. Normals are along the product of its slopes by u and by v.
using Surface = std::function<vtkVector3d(double u, double v)>;

/// The surface in columns along u and rows along v.
Mesh Tessellate(const Surface& surface, int columns, int rows);

#endif
