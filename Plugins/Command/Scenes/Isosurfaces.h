// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Nested isosurfaces of a volume or a grid.
 */
#ifndef Isosurfaces_h
#define Isosurfaces_h

class vtkDataSet;
struct Input;
struct Scene;

/**
 * Appends the isosurfaces of the point scalars, or of the first point array of one component: at the input's
 * Isovalues, or else at values that part of the points exceed, each a smaller part. Returns how many surfaces there
 * are: none if there are no such scalars.
 */
int AddIsosurfaces(const Input& input, vtkDataSet* data, Scene& scene);

#endif
