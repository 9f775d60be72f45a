// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyScopedTargets
 *
 * Makes a stage's targets what is drawn to, and clears them. When it goes, the framebuffer that was bound before is
 * again.
 */
#ifndef vtkTranslucencyScopedTargets_h
#define vtkTranslucencyScopedTargets_h

#include "vtkTranslucencyStage.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class vtkTranslucencyScopedTargets
{
public:
  /// A stage without targets changes nothing. The stage has to outlive it.
  vtkTranslucencyScopedTargets(vtkOpenGLRenderWindow* window, const vtkTranslucencyStage& stage);
  ~vtkTranslucencyScopedTargets();
  vtkTranslucencyScopedTargets(const vtkTranslucencyScopedTargets&) = delete;
  vtkTranslucencyScopedTargets& operator=(const vtkTranslucencyScopedTargets&) = delete;

  /// What is wrong, empty if nothing is.
  const std::string& GetObstacle() const { return this->Obstacle; }

private:
  const vtkTranslucencyStage& Drawn;
  std::string Obstacle;
};
VTK_ABI_NAMESPACE_END

#endif
