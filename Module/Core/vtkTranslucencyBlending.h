// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyBlending
 *
 * The blend functions of a stage, through VTK's cache of OpenGL's state, which knows one for all buffers: that of the
 * first one.
 */
#ifndef vtkTranslucencyBlending_h
#define vtkTranslucencyBlending_h

#include "vtkTranslucencyStage.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLState;

class vtkTranslucencyBlending
{
public:
  /// Blends as the stage wants it, each buffer by its own function.
  static void Set(vtkOpenGLState* state, const vtkTranslucencyStage& stage);

  /// The same if a mapper has set a function of its own since.
  static void Keep(vtkOpenGLState* state, const vtkTranslucencyStage& stage);

  /// A stage that draws to targets, as several, in each of which all buffers that are drawn to are blended alike.
  static std::vector<vtkTranslucencyStage> Split(const vtkTranslucencyStage& stage);

  /// Masks the buffers that a stage leaves alone, and takes the masks away. The cache knows what the first one has.
  static void Mask(vtkOpenGLState* state, const vtkTranslucencyStage& stage);
  static void Unmask(vtkOpenGLState* state, const vtkTranslucencyStage& stage);

  /// Blends all buffers as the first one, as the cache has it.
  static void UseOneFunction();
};
VTK_ABI_NAMESPACE_END

#endif
