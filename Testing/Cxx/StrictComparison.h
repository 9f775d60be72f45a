// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A comparison of pictures that sees what VTK's does not: VTK 9.1 averages after a shift by two pixels and takes a
 * picture dimmed to 80 % for the same.
 */
#ifndef StrictComparison_h
#define StrictComparison_h

#include <OpenImageIO/imagebuf.h>

#include <string>

/// Rasterizers may differ in a few pixels, at edges.
struct StrictBounds
{
  double Channel = 2.0 / 255;    // what a channel may differ
  double PixelFraction = 0.0005; // of the pixels may differ more
};

/// Empty if the pictures are the same within the bounds, else how they differ.
std::string CompareStrictly(
  const OIIO::ImageBuf& picture, const OIIO::ImageBuf& baseline, const StrictBounds& bounds = {});

#endif
