// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScreenDoorPass
 * @brief   translucent surfaces as opaque ones with holes
 *
 * Screen-door transparency, as in the survey "Transparency, alpha, compositing" (Real-Time Rendering, 4th
 * edition, 5.5): a mask of thresholds lies over the window, and of a fragment of opacity a those pixels are drawn whose
 * threshold is below a. What is drawn is opaque, so the depth buffer keeps the nearest: nothing is blended, and the
 * order of drawing does not matter.
 *
 * A mask has n cells with thresholds (k + 1/2) / n. Over each period of it a flat layer of opacity a covers round(a *
 * n) cells, and the mean over a period differs from blending it by 1/(2 n) at most. Of several layers behind each other
 * this does not hold: what is seen of a layer are its cells that the masks of those in front leave free. With the same
 * mask they are none that a layer of as much opacity in front leaves free; hence Offset. What is drawn hides all behind
 * it, so a transmission colour counts by its mean only, in how much is drawn.
 *
 * Stages:
 * 1. Gather: the nearest of the fragments that pass the mask, in a buffer of colours with a depth buffer of its own,
 * which starts as the opaque one (20 bytes a pixel and sample).
 * 2. Composite: that over the opaque picture.
 */
#ifndef vtkScreenDoorPass_h
#define vtkScreenDoorPass_h

#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyTargets.h" // for Nearest

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkScreenDoorPass : public vtkTranslucencyPass
{
public:
  static vtkScreenDoorPass* New();
  vtkTypeMacro(vtkScreenDoorPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MaskType
  {
    Ordered4x4 = 0,
    Ordered8x8 = 1,
    BlueNoise = 2
  };

  enum OffsetType
  {
    NoOffset = 0,
    ObjectOffset = 1,
    PrimitiveOffset = 2
  };

  ///@{
  /**
   * The thresholds: the ordered masks of Bayer, with 17 or 65 opacities and a regular pattern, or BlueNoise (the
   * default), 64x64 cells without one. Another value is an error and changes nothing.
   */
  void SetMask(int mask);
  vtkGetMacro(Mask, int);
  ///@}

  ///@{
  /**
   * What has the mask in a place of its own: nothing (NoOffset), each object, and its front and its back faces
   * (ObjectOffset, the default), or each primitive (PrimitiveOffset), for objects with many layers; there the pattern
   * is broken at their borders, and the mean holds within each primitive only. The ordered masks know few places at
   * opacities like 1/2. Another value is an error and changes nothing.
   */
  void SetOffset(int offset);
  vtkGetMacro(Offset, int);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;

protected:
  vtkScreenDoorPass() = default;
  ~vtkScreenDoorPass() override;

  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int Mask = BlueNoise;
  int Offset = ObjectOffset;

private:
  vtkTranslucencyTargets Nearest;
  vtkTranslucencyTargets Ranks;
  std::vector<unsigned int> MadeRanks;
  int MadeMask = -1; // of which these are

  vtkScreenDoorPass(const vtkScreenDoorPass&) = delete;
  void operator=(const vtkScreenDoorPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
