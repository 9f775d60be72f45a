// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyPeelingGuard
 *
 * Lets VTK's depth peeling passes end, whatever they draw.
 *
 * They peel until an occlusion query counts no fragments. A prop that their text does not reach
 * (vtkTranslucencyUnreached) draws the same fragments in every drawing, and so does a shader whose depths are not
 * numbers: there is no end. Under the guard, props that are not reached are left out, and drawn by blending over what
 * was peeled; and two drawings with the same outcome end the peeling. That is looked for when the number of drawings is
 * a power of two: a peeling that changes nothing goes on doing so.
 */
#ifndef vtkTranslucencyPeelingGuard_h
#define vtkTranslucencyPeelingGuard_h

#include "vtkTranslucencyUnreached.h"

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDepthPeelingPass;
class vtkOpenGLRenderWindow;
class vtkRenderState;

class vtkTranslucencyPeelingGuard
{
public:
  vtkTranslucencyPeelingGuard();

  /// Draws by a pass of VTK, whose Render the function calls. Gives what to warn of: props that were not reached. Empty
  /// if there is none or if it was given before.
  std::string Render(vtkDepthPeelingPass* peeling, const vtkRenderState* state, vtkOpenGLRenderWindow* window,
    const std::function<void()>& render);

private:
  vtkTranslucencyUnreached Unreached;
};
VTK_ABI_NAMESPACE_END

#endif
