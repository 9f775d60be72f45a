// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 *
 * The one file that knows how VTK's releases differ: everything else is written for 9.1 and later alike.
 */
#ifndef vtkTranslucencyVTKVersion_h
#define vtkTranslucencyVTKVersion_h

// OpenGL's functions: GLEW up to VTK 9.3, GLAD from 9.4 on.
#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // IWYU pragma: export
#else
#include "vtk_glew.h" // IWYU pragma: export
#endif

#include "vtkRenderState.h"
#include "vtkVersionMacros.h"

#include <vector>

class vtkProp;

/// The number of props of a render state.
inline int vtkTranslucencyPropCount(const vtkRenderState* state)
{
  return static_cast<int>(state->GetPropArrayCount());
}

/// One prop of a render state: an element of an array up to VTK 9.6, of a std::vector after.
inline vtkProp* vtkTranslucencyProp(const vtkRenderState* state, int index)
{
  return state->GetPropArray()[index];
}

/// Makes a render state like another one, of these props, which have to outlive it.
inline void vtkTranslucencySetProps(vtkRenderState& state, std::vector<vtkProp*>& props, const vtkRenderState* like)
{
  state.SetFrameBuffer(like->GetFrameBuffer());
  state.SetRequiredKeys(like->GetRequiredKeys());
  state.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
}

// vtkOpenGLShaderCache knows tessellation shaders from 9.4 on.
#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 4)
#define VTK_TRANSLUCENCY_TESSELLATION 1
#else
#define VTK_TRANSLUCENCY_TESSELLATION 0
#endif

// VTK_VERSION_CHECK and the factory macros of VTK 9.1 lack what later releases define.
#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST
#endif

#endif
