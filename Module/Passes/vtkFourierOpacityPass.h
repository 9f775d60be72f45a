// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityPass
 * @brief   Fourier opacity mapping: absorbance along a ray as a Fourier series
 *
 * Jansen and Bavoil 2010, "Fourier opacity mapping", used for transparency as Salvi et al. 2011 do (FOMTF and FOMTV):
 * see vtkAbsorbancePass for the stages. The sums are the mean absorbance and Coefficients pairs of cosine and sine, 4 +
 * 8 * Coefficients bytes a pixel and sample with fixed memory (16 bytes for three of the last four sums).
 *
 * What a visibility is, then: a lone fragment's is 1, as it should be. The first one of several is told from those
 * behind it only as far as the series tells them apart; it sees up to half of what is close behind.
 *
 * Smooth where many faint fragments follow each other, as in smoke; the series of few opaque ones rings, and rises
 * slowly: fragments closer than 1 / (2 * Coefficients) of the range hide each other by half, in whatever order they
 * are.
 */
#ifndef vtkFourierOpacityPass_h
#define vtkFourierOpacityPass_h

#include "vtkAbsorbancePass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkFourierOpacityPass : public vtkAbsorbancePass
{
public:
  static vtkFourierOpacityPass* New();
  vtkTypeMacro(vtkFourierOpacityPass, vtkAbsorbancePass);

  ///@{
  /**
   * Pairs of cosine and sine, 1 to 15, 4 by default. A value outside is an error and changes nothing.
   */
  void SetCoefficients(int coefficients) { this->SetSums(coefficients); }
  int GetCoefficients() const { return this->Number; }
  ///@}

protected:
  vtkFourierOpacityPass();
  ~vtkFourierOpacityPass() override = default;

  int GetTermCount() const override { return 2 * this->Number + 1; }

private:
  vtkFourierOpacityPass(const vtkFourierOpacityPass&) = delete;
  void operator=(const vtkFourierOpacityPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
