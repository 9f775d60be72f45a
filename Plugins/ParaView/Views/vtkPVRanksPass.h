// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVRanksPass
 * @brief   puts together what ranks draw, and rounds once
 *
 * ParaView's vtkIceTCompositePass has IceT put parts of 8 bits a channel together, and IceT rounds down each time it
 * puts one behind others. Here the same is done in finer numbers, so that the picture of many ranks differs from that
 * of one by what two roundings to 8 bits make:
 *
 * 1. Each rank draws its part into a framebuffer of 16 bits a channel. As with the window's 8 bits, and not with
 * floats, what is brighter than white is cut off before something lies over it.
 * 2. IceT puts the parts together as floats, over each other in ParaView's order of the ranks.
 * 3. Rank 0 rounds, and gives the 8 bits to ParaView's pass, which ParaView takes the picture from, in the window too.
 *
 * The framebuffer is there while the pass draws: 12 bytes per pixel. The part is read as 16 bytes per pixel, where
 * ParaView's has 4, and IceT sends so much of it, but for pixels without anything in them.
 *
 * It is for frames in which ranks are put together in an order (something is translucent, or a volume), in full size.
 * The others are left to ParaView's pass: opaque ones, selections, tiled displays, reduced pictures while the camera
 * moves, pictures of values, and what is drawn by other passes than this plugin's, as by ray tracing.
 */
#ifndef vtkPVRanksPass_h
#define vtkPVRanksPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkIceTContext;
class vtkIceTSynchronizedRenderers;
class vtkRenderer;
class vtkSynchronizedRenderers;

class vtkPVRanksPass : public vtkRenderPass
{
public:
  static vtkPVRanksPass* New();
  vtkTypeMacro(vtkPVRanksPass, vtkRenderPass);

  /// Whether the next frame of a renderer is one that this pass is for, as far as this rank knows: drawn by `pass`,
  /// below ParaView's. It may take the place of ParaView's pass only if this is so on all ranks, which wait for each
  /// other.
  static bool CanRender(vtkSynchronizedRenderers* ranks, vtkRenderer* renderer, vtkRenderPass* pass);

  /// Takes the place of ParaView's pass until TakeOut(). Only after CanRender().
  void PutIn(vtkSynchronizedRenderers* ranks);

  /// Puts ParaView's pass back, if it has been replaced.
  void TakeOut();

  void Render(const vtkRenderState* state) override;

protected:
  vtkPVRanksPass();
  ~vtkPVRanksPass() override;

private:
  vtkPVRanksPass(const vtkPVRanksPass&) = delete;
  void operator=(const vtkPVRanksPass&) = delete;

  vtkSmartPointer<vtkIceTContext> Context;
  vtkWeakPointer<vtkIceTSynchronizedRenderers> Ranks; // while this pass is put in
};

#endif
