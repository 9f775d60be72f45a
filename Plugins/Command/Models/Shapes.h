// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Surfaces that scenes are put together of. y is up.
 */
#ifndef Shapes_h
#define Shapes_h

#include "Mesh.h"

#include <vector>

/// A smooth line through the points, which t of 0 to 1 goes along (Catmull and Rom). A point that is there twice is a
/// corner.
vtkVector2d Spline(const std::vector<vtkVector2d>& points, double t);

/// The line through points of radius and height, turned about the axis y. Normals are to the right of the line's way:
/// outwards, where it goes up.
Mesh Revolve(const std::vector<vtkVector2d>& profile, int sides, int rowsOfSpan);

Mesh Ball(double radius, int sides);

/// About the origin, with edges of that radius.
Mesh RoundedBox(const vtkVector3d& halfSize, double radius);

/// From one point to the other, with a radius at each.
Mesh Rod(const vtkVector3d& from, const vtkVector3d& to, double fromRadius, double toRadius);

/// A flat piece between four corners, in the order of going round it against the clock.
Mesh Pane(const vtkVector3d (&corners)[4], int columns, int rows);

#endif
