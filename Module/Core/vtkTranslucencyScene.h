// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyScene
 *
 * What a technique asks of the translucent props that a frame draws: those that say so, and those that were seen to
 * draw what is translucent (vtkTranslucencyUnreached).
 */
#ifndef vtkTranslucencyScene_h
#define vtkTranslucencyScene_h

#include "vtkTranslucencyABINamespace.h"
#include "vtkTranslucencyPropBounds.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderState;
class vtkRenderer;
class vtkTranslucencyUnreached;

class vtkTranslucencyScene
{
public:
  vtkTranslucencyScene(
    const vtkRenderState* state, const vtkTranslucencyUnreached& unreached, vtkTranslucencyPropBounds& kept)
    : State(state)
    , Unreached(unreached)
    , Kept(kept)
  {
  }

  /// The distances of the near and the far plane, or 1 and 1 where the projection is parallel, and twice 0
  /// (Shaders/Common/Frame.glsl).
  static std::array<float, 4> GetClipping(vtkRenderer* renderer);

  /// The directions of rays through pixels of a viewport that the camera's picture fills (Shaders/Common/Frame.glsl).
  static std::array<float, 4> GetRays(vtkRenderer* renderer, const std::array<int, 4>& viewport);

  /// In the order of drawing.
  std::vector<vtkProp*> GetProps() const;

  /// Between which depths their boxes lie, 0 at the near plane, 1 at the far plane, linear in the distance
  /// (Shaders/Common/LinearDepth.glsl). All of it where a prop does not know its box.
  std::array<double, 2> GetDepthRange() const;

  /// Where the boxes of visible props lie in a viewport that the camera's picture fills: left, bottom, right, top in
  /// window pixels. All of the viewport for a prop that does not know its box or is partly behind the camera.
  std::vector<std::array<double, 4>> GetBoxes(const std::array<int, 4>& viewport) const;

private:
  // Of visible props.
  std::vector<vtkTranslucencyPropBounds::Bounds> GetBounds() const;

  const vtkRenderState* State;
  const vtkTranslucencyUnreached& Unreached;
  vtkTranslucencyPropBounds& Kept;
};
VTK_ABI_NAMESPACE_END

#endif
