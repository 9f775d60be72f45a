// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStorageSimulator
 *
 * A behavioural simulator of the designs of vtkStorageAccounting ("T-buffer", section 4): it takes a frame's fragments
 * in the order of their arrival, stores each in the design's own tables, sections, nodes or FIFO, reads all of them
 * back, and counts bytes when they are given out and accesses when they happen. It uses no closed form:
 * vtkStorageAccounting's have to come to the same numbers.
 *
 * How fragments come back: the T-buffer and the M-buffer give them pixel by pixel in the order of arrival, the linked
 * list pixel by pixel with the last one first, the R-buffer pass by pass, each pixel's farthest first, of equal depths
 * the one that came first.
 *
 * The R-buffer's FIFO is read once for each layer of the deepest pixel: time grows with the square of a pixel's
 * fragments. That is the design's nature; 20,000 in one pixel take a second or so.
 */
#ifndef vtkStorageSimulator_h
#define vtkStorageSimulator_h

#include "vtkStorageAccounting.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkStorageSimulator
{
public:
  struct Fragment
  {
    int X = 0;       ///< pixels from the left
    int Y = 0;       ///< pixels from the bottom
    float Depth = 0; ///< of the window: 0 at the near plane, 1 at the far plane
    std::array<float, 4> Color{ { 0, 0, 0,
      0 } }; ///< red, green, blue, not multiplied by the opacity, which is the last
  };

  struct Result
  {
    vtkStorageAccounting::Cost Cost;
    std::vector<Fragment> Read; ///< in the order of reading
    std::string Error; ///< empty, or what is wrong, and what was expected: a fragment that is outside the frame, a
                       ///< section without an address
  };

  static Result Run(const vtkStorageAccounting::Layout& layout, const std::vector<Fragment>& fragments);

  /// What the accounting needs to know of a frame.
  static vtkStorageAccounting::Histogram Count(int width, int height, const std::vector<Fragment>& fragments);
};
VTK_ABI_NAMESPACE_END

#endif
