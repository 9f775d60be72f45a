// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStockPeelingPass
 * @brief   VTK's dual depth peeling, the technique vtk-peel, made to end and to say what it can't draw
 *
 * For comparison: what it draws is VTK's own, with what is wrong there. Two things are known.
 * - It ends after the first layer where opaque surfaces lie behind all translucent ones. It starts from the opaque
 * depth as the farthest one, and so the first drawing finds no farthest layer; but it goes on only while an occlusion
 * query counts farthest layers (vtkDualDepthPeelingPass::BlendBackBuffer; seen in VTK 9.1 and 9.7). A single pixel of
 * translucent surface with nothing opaque behind it hides this: all others then come out right.
 * - It draws nothing in a multi-sampled window, whose depth buffer it can't copy. That is refused here: an error says
 * so, once, and translucent surfaces are blended in the order of drawing.
 *
 * Props that its shaders don't reach are drawn over the others, after a warning (vtkTranslucencyPeelingGuard).
 */
#ifndef vtkStockPeelingPass_h
#define vtkStockPeelingPass_h

#include "vtkDualDepthPeelingPass.h"
#include "vtkTranslucencyPeelingGuard.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkStockPeelingPass : public vtkDualDepthPeelingPass
{
public:
  static vtkStockPeelingPass* New();
  vtkTypeMacro(vtkStockPeelingPass, vtkDualDepthPeelingPass);

  void Render(const vtkRenderState* state) override;

protected:
  vtkStockPeelingPass() = default;
  ~vtkStockPeelingPass() override = default;

private:
  vtkStockPeelingPass(const vtkStockPeelingPass&) = delete;
  void operator=(const vtkStockPeelingPass&) = delete;

  vtkTranslucencyPeelingGuard Guard;
  bool Refused = false; // a multi-sampled window, with an error
};
VTK_ABI_NAMESPACE_END

#endif
