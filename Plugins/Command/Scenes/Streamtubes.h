// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tubes round the streamlines of a volume or a grid with vectors.
 */
#ifndef Streamtubes_h
#define Streamtubes_h

class vtkDataSet;
struct Input;
struct Scene;

/**
 * Appends the tubes that the input's Tubes ask for, as one part. They follow the point data's vectors, or else the
 * first point array of three floating-point components, both ways from each seed, and end before the step that would
 * be too slow. Seeds are points of the data, spread evenly over all that are fast enough in the order of the data: the
 * same each time. Throws Failure if there are no such vectors (data may be null), one is not finite, all are 0, or no
 * streamline has two points.
 */
void AddStreamtubes(const Input& input, vtkDataSet* data, Scene& scene);

#endif
