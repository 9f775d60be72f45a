// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Basics/Failure.h"

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
const char* const Suffixes[] = { ".png", ".exr", ".tif", ".tiff", ".jpg", ".jpeg" };

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
  return text;
}

void Check(const OIIO::ImageBuf& result)
{
  if (result.has_error())
  {
    throw Failure("a picture can't be computed: " + result.geterror());
  }
}

OIIO::ImageBuf ToLinearLight(const OIIO::ImageBuf& pixels)
{
  OIIO::ImageBuf linear =
    OIIO::ImageBufAlgo::colorconvert(OIIO::ImageBufAlgo::copy(pixels, OIIO::TypeFloat), "sRGB", "linear");
  Check(linear);
  return linear;
}
}

//------------------------------------------------------------------------------
Picture::Picture(int width, int height, int channels, const unsigned char* pixels)
{
  const OIIO::ImageSpec spec(
    width, height, channels, OIIO::TypeUInt8); // of four, OpenImageIO takes the last for the opacity
  const OIIO::ImageBuf upsideDown(spec, const_cast<unsigned char*>(pixels));
  this->Pixels = OIIO::ImageBufAlgo::flip(upsideDown);
  Check(this->Pixels);
}

//------------------------------------------------------------------------------
Picture::Picture(const OIIO::ImageBuf& pixels)
  : Pixels(pixels)
{
  Check(this->Pixels);
}

//------------------------------------------------------------------------------
void Picture::Write(const std::filesystem::path& file, const std::string& name) const
{
  const bool linear = LowerCase(file.extension().string()) == ".exr";
  OIIO::ImageBuf out = linear ? ToLinearLight(this->Pixels) : this->Pixels;
  out.specmod().attribute("CompressionQuality", 95);    // JPEG
  out.specmod().attribute("jpeg:subsampling", "4:4:4"); // thin lines keep their colour
  out.specmod().attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  if (!out.write(file.string()))
  {
    throw Failure("'" + name + "' can't be written: " + out.geterror());
  }
}

//------------------------------------------------------------------------------
Difference Picture::CompareTo(const Picture& reference) const
{
  const auto result = OIIO::ImageBufAlgo::compare(this->Pixels, reference.Pixels, 0, 0);
  if (this->Pixels.has_error()) // result.error only says that the pictures differ
  {
    throw Failure("pictures can't be compared: " + this->Pixels.geterror());
  }
  Difference difference;
  difference.Rmse = result.rms_error;
  difference.Largest = static_cast<int>(std::lround(result.maxerror * 255));
  if (result.rms_error > 0)
  {
    difference.Psnr = result.PSNR;
  }
  return difference;
}

//------------------------------------------------------------------------------
Picture Picture::AbsoluteDifference(const Picture& other, float factor) const
{
  const std::array<int, 3> colors{ { 0, 1, 2 } };
  const auto difference =
    OIIO::ImageBufAlgo::channels(OIIO::ImageBufAlgo::absdiff(this->Pixels, other.Pixels), 3, colors);
  return Picture(OIIO::ImageBufAlgo::mul(difference, factor));
}

//------------------------------------------------------------------------------
void CheckPictureSuffix(const std::filesystem::path& file)
{
  const std::string suffix = LowerCase(file.extension().string());
  if (std::find(std::begin(Suffixes), std::end(Suffixes), suffix) == std::end(Suffixes))
  {
    throw Failure("'" + file.string() + "' has the suffix '" + suffix + "', expected one of " + PictureSuffixes());
  }
}

//------------------------------------------------------------------------------
void CheckHoldsTransparency(const std::filesystem::path& file)
{
  const std::string suffix = LowerCase(file.extension().string());
  if (suffix == ".jpg" || suffix == ".jpeg")
  {
    throw Failure("'" + file.string() + "' is to have a transparent background, which " + suffix +
      " can't hold, expected .png .exr .tif or .tiff");
  }
}

//------------------------------------------------------------------------------
std::string PictureSuffixes()
{
  std::string suffixes;
  for (const char* suffix : Suffixes)
  {
    suffixes += (suffixes.empty() ? "" : " ") + std::string(suffix);
  }
  return suffixes;
}
