// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpacityShadowMapPass
 * @brief   opacity shadow maps: absorbance along a ray on a uniform grid
 *
 * Kim and Neumann 2001, "Opacity shadow maps", used for transparency as Salvi et al. 2011 do (OSMTF and OSMTV): see
 * vtkAbsorbancePass for the stages. The sums are the absorbances of Slices slices of equal depth, 4 * Slices bytes a
 * pixel and sample with fixed memory. Within a slice absorbance is taken to be spread evenly: of two fragments in one
 * slice, the farther one hides the nearer one, too. With the bounds of the fragments, the visibilities of a pixel's
 * first and last one are exact (before the alpha correction): they lie at the ends of the grid.
 */
#ifndef vtkOpacityShadowMapPass_h
#define vtkOpacityShadowMapPass_h

#include "vtkAbsorbancePass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkOpacityShadowMapPass : public vtkAbsorbancePass
{
public:
  static vtkOpacityShadowMapPass* New();
  vtkTypeMacro(vtkOpacityShadowMapPass, vtkAbsorbancePass);

  ///@{
  /**
   * Slices of the range of depths, 1 to 32, 16 by default. A value outside is an error and changes nothing.
   */
  void SetSlices(int slices) { this->SetSums(slices); }
  int GetSlices() const { return this->Number; }
  ///@}

protected:
  vtkOpacityShadowMapPass();
  ~vtkOpacityShadowMapPass() override = default;

private:
  vtkOpacityShadowMapPass(const vtkOpacityShadowMapPass&) = delete;
  void operator=(const vtkOpacityShadowMapPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
