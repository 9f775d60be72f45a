// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Label volumes: integers that say which tissue, material or object a voxel belongs to; 0 is the background.
 */
#ifndef LabelVolume_h
#define LabelVolume_h

class vtkImageData;
struct Input;
struct Scene;

/// True if the volume's scalars are integers of few different values.
bool IsLabelVolume(vtkImageData* volume);

/// Appends one surface for each label; throws Failure if there is none, or one that the input names is not there.
void AddLabels(const Input& input, vtkImageData* volume, Scene& scene);

#endif
