// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StrictComparison.h"

#include <OpenImageIO/imagebufalgo.h>

#include <sstream>

//------------------------------------------------------------------------------
std::string CompareStrictly(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& baseline, const StrictBounds& bounds)
{
  std::ostringstream difference;
  if (picture.spec().width != baseline.spec().width || picture.spec().height != baseline.spec().height)
  {
    difference << picture.spec().width << "x" << picture.spec().height << " pixels, expected " << baseline.spec().width
               << "x" << baseline.spec().height;
    return difference.str();
  }
  const float channel = static_cast<float>(bounds.Channel);
  const auto result = OIIO::ImageBufAlgo::compare(picture, baseline, channel, channel);
  const double allowed = bounds.PixelFraction * static_cast<double>(picture.spec().image_pixels());
  if (result.error || static_cast<double>(result.nfail) > allowed)
  {
    difference << result.nfail << " pixels differ by more than " << 255 * bounds.Channel << "/255, allowed are "
               << allowed << "; the largest difference is " << 255 * result.maxerror << "/255 at " << result.maxx
               << ", " << result.maxy << ", RMSE " << result.rms_error;
  }
  return difference.str();
}
