// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  vtkPeelingSettings
 *
 * What the algorithms of vtkDepthPeelPass have in common.
 */
#ifndef vtkPeelingSettings_h
#define vtkPeelingSettings_h

#include "vtkTranslucencyABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
struct vtkPeelingSettings
{
  int Layers = 0;           ///< the most to peel; 0: all
  bool AveragesTail = true; ///< whether what is left after so many is drawn as one layer of its mean colour

  static constexpr int MostLayers = 65536;

  /// Why peeling is given up.
  static std::string GetTooMany()
  {
    return "more than " + std::to_string(MostLayers) +
      " layers, expected no more: depths of the same fragments may differ from drawing to drawing";
  }
};
VTK_ABI_NAMESPACE_END

#endif
