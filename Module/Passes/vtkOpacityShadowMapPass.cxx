// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpacityShadowMapPass.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkOpacityShadowMapPass);

//------------------------------------------------------------------------------
vtkOpacityShadowMapPass::vtkOpacityShadowMapPass()
  : vtkAbsorbancePass({ { "Slices", "slices", vtkTranslucencyOption::Kind::Integer, 16, 1, 32, {},
                          "slices of equal depth in which absorbance is summed; more tell nearer fragments apart and "
                          "take memory and time",
                          {}, {} },
      "OpacityShadowMap", "SLICES", false })
{
}
VTK_ABI_NAMESPACE_END
