// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMomentTransparencyPass
 * @brief   moment transparency: absorbance along a ray by its moments
 *
 * Muenstermann, Krumpen, Klein, Peters 2018, "Moment-Based Order-Independent Transparency"; Sharpe 2018, "Moment
 * Transparency": see vtkAbsorbancePass for the stages. The sums are the moments of the absorbance as a distribution of
 * mass over depth: 5 to 9 floats, the first of which is the total.
 *
 * Many distributions have the same few moments. The least and the most that any of them can have in front of a depth
 * are known, and Overestimation chooses between the two. A pixel with few layers leaves no choice: half as many as
 * there are power moments, or as many as there are trigonometric ones, and one more are exact to 1e-4, and to 1e-3 with
 * Power8 and Trigonometric4. Smooth absorbance, as of smoke, comes out well too; many distinct layers are smoothed.
 * What trigonometric moments give for the least and the most is no strict bound.
 *
 * A fragment's own moments are taken out before it asks. How the rest is inverted in 32 bits, with no fragment lost
 * where a pixel has but one, two or a few: Module/Shaders/Moment/Power.glsl and Trigonometric.glsl. Zeros are found
 * anew for each fragment, so that it takes more arithmetic than other techniques of sums.
 */
#ifndef vtkMomentTransparencyPass_h
#define vtkMomentTransparencyPass_h

#include "vtkAbsorbancePass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkMomentTransparencyPass : public vtkAbsorbancePass
{
public:
  static vtkMomentTransparencyPass* New();
  vtkTypeMacro(vtkMomentTransparencyPass, vtkAbsorbancePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MomentsType
  {
    Power4 = 0,
    Power6 = 1,
    Power8 = 2,
    Trigonometric2 = 3,
    Trigonometric3 = 4,
    Trigonometric4 = 5
  };

  ///@{
  /**
   * Which moments are summed: 4, 6 (the default) or 8 of powers of depth, or 2, 3 or 4 complex ones of an angle. More
   * tell more layers apart, and take memory and time. Another value is an error and changes nothing.
   */
  void SetMoments(int moments) { this->SetSums(moments); }
  int GetMoments() const { return this->Number; }
  ///@}

  ///@{
  /**
   * What is taken for the truth between the least (0) and the most (1) absorbance that can lie in front of a fragment;
   * 0.25 by default. Less is brighter, more is darker. A value outside is an error and changes nothing.
   */
  void SetOverestimation(double overestimation);
  vtkGetMacro(Overestimation, double);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;

protected:
  vtkMomentTransparencyPass();
  ~vtkMomentTransparencyPass() override = default;

  int GetTermCount() const override;
  vtkTranslucencyFrame::Uniforms GetValues(const vtkTranslucencyFrame& frame) const override;

  double Overestimation = 0.25;

private:
  vtkTranslucencyOption GetOverestimationOption();

  vtkMomentTransparencyPass(const vtkMomentTransparencyPass&) = delete;
  void operator=(const vtkMomentTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
