// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencySamplers
 *
 * The state of samplers, which a software rasterizer compiles fragment shaders for.
 *
 * llvmpipe compiles a fragment shader anew for each state of its samplers, also of those that are texel buffers. These
 * have no state of their own: it takes the one that another program has left there (Documentation/Drivers.md). VTK
 * shows a multi-sampled frame through a texture, so the second frame compiled every shader again.
 */
#ifndef vtkTranslucencySamplers_h
#define vtkTranslucencySamplers_h

#include "vtkTranslucencyABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkTranslucencyFrameShaders;
struct vtkTranslucencyResources;

class vtkTranslucencySamplers
{
public:
  /// Leaves the same state each time, by a drawing without a fragment: before mappers draw, some of which have texel
  /// buffers, and before the resolves, whichever mapper was the last one. Other drivers need none. False, with the
  /// reason in the shaders' error, if its program does not compile.
  static bool Settle(
    vtkTranslucencyResources& resources, vtkOpenGLRenderWindow* window, vtkTranslucencyFrameShaders& shaders);
};
VTK_ABI_NAMESPACE_END

#endif
