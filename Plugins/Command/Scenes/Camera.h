// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The eye: where the scene says, or else so that the whole scene just fills the picture.
 */
#ifndef Camera_h
#define Camera_h

class vtkCamera;
struct Scene;

/// aspect: the picture's width over its height.
void SetUpCamera(const Scene& scene, double aspect, vtkCamera* camera);

#endif
