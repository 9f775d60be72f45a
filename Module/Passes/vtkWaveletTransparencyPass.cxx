// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaveletTransparencyPass.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaveletTransparencyPass);

//------------------------------------------------------------------------------
vtkWaveletTransparencyPass::vtkWaveletTransparencyPass()
  : vtkAbsorbancePass(
      { { "Rank", "rank", vtkTranslucencyOption::Kind::Integer, 3, 1, 5, {},
          "the finest level of wavelets; each one more tells fragments half as far apart and doubles the coefficients",
          {}, {} },
        "Wavelet", "WAVELET_RANK", false })
{
}
VTK_ABI_NAMESPACE_END
