// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyDrawings
 *
 * The drawings that a stage takes: one, on most drivers. The picture is the same.
 * - A driver of OpenGL before 4.0 may have one way of blending for all buffers. Where a stage has several, it is drawn
 *   once for each, to the buffers that are blended so, while the others are masked.
 * - Such a driver may also be unable to shade samples. Where shaders read targets of several samples, a stage is drawn
 *   once for each, under a mask of the samples.
 */
#ifndef vtkTranslucencyDrawings_h
#define vtkTranslucencyDrawings_h

#include "vtkTranslucencyStage.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLState;
struct vtkTranslucencyCapabilities;

class vtkTranslucencyDrawings
{
public:
  /// Calls draw for each drawing, with the stage as it is then, and what shaders are to see as the uniform
  /// targetSample. samples is how many a pixel has, 1 if no shader reads them.
  static void Each(vtkOpenGLState* state, const vtkTranslucencyStage& stage,
    const vtkTranslucencyCapabilities& capabilities, int samples,
    const std::function<void(const vtkTranslucencyStage& drawn, int sample)>& draw);
};
VTK_ABI_NAMESPACE_END

#endif
