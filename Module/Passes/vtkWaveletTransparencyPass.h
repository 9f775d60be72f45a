// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaveletTransparencyPass
 * @brief   wavelet transparency: absorbance along a ray in Haar wavelets
 *
 * Aizenshtein, Smal, McGuire 2021, "Wavelet Transparency", sections 2.1 to 2.3: see vtkAbsorbancePass for the stages.
 * The sums are the 2^(Rank + 1) coefficients of the scaling function and of the wavelets of levels 0 to Rank, 4 bytes
 * each a pixel and sample with fixed memory. They tell the mean of the absorbance over each of as many intervals of the
 * range of depths; in between it is interpolated.
 *
 * Surfaces of one pixel are told apart where an interval lies between them; nearer ones hide each other in part,
 * whatever their order. The transmittance falls with depth without ringing.
 *
 * With fixed memory, Rank 5 has 64 coefficients in 16 targets, for which the geometry is drawn once more, and takes a
 * driver with 24 texture units.
 */
#ifndef vtkWaveletTransparencyPass_h
#define vtkWaveletTransparencyPass_h

#include "vtkAbsorbancePass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkWaveletTransparencyPass : public vtkAbsorbancePass
{
public:
  static vtkWaveletTransparencyPass* New();
  vtkTypeMacro(vtkWaveletTransparencyPass, vtkAbsorbancePass);

  ///@{
  /**
   * The finest level of wavelets, 1 to 5, 3 by default. A value outside is an error and changes nothing.
   */
  void SetRank(int rank) { this->SetSums(rank); }
  int GetRank() const { return this->Number; }
  ///@}

protected:
  vtkWaveletTransparencyPass();
  ~vtkWaveletTransparencyPass() override = default;

  int GetTermCount() const override { return 2 << this->Number; }

private:
  vtkWaveletTransparencyPass(const vtkWaveletTransparencyPass&) = delete;
  void operator=(const vtkWaveletTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
