// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScreenDoorMask
 *
 * Masks of thresholds for vtkScreenDoorPass: squares of cells, repeated over the window, which are filled in the order
 * of their ranks as opacity grows. A mask of n cells holds each rank from 0 to n - 1 once, row by row.
 */
#ifndef vtkScreenDoorMask_h
#define vtkScreenDoorMask_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkScreenDoorMask
{
public:
  /// Bayer, "An optimum method for two-level rendition of continuous-tone pictures" (ICC 1973). The size is a power
  /// of 2.
  static std::vector<unsigned int> MakeOrdered(int size);

  /// Blue noise, without a pattern that the eye finds: Ulichney, "The void-and-cluster method for dither array
  /// generation" (SPIE 1993). The same in each run; takes time in proportion to the fourth power of the size, about 50
  /// ms for 64.
  static std::vector<unsigned int> MakeBlueNoise(int size);
};
VTK_ABI_NAMESPACE_END

#endif
