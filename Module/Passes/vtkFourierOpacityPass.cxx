// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityPass.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFourierOpacityPass);

//------------------------------------------------------------------------------
vtkFourierOpacityPass::vtkFourierOpacityPass()
  : vtkAbsorbancePass({ { "Coefficients", "coefficients", vtkTranslucencyOption::Kind::Integer, 4, 1, 15, {},
                          "pairs of cosine and sine beside the mean absorbance; more tell nearer fragments apart and "
                          "take memory and time",
                          {}, {} },
      "Fourier", "FOURIER_COEFFICIENTS" })
{
}
VTK_ABI_NAMESPACE_END
