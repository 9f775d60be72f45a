// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// The library of Picture.h.
#include "Picture.h"

#include "Basics/Failure.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <cmath>

namespace
{
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

class OpenImageIOPicture : public Picture
{
public:
  explicit OpenImageIOPicture(const OIIO::ImageBuf& pixels)
    : Pixels(pixels)
  {
    Check(this->Pixels);
  }

  Difference CompareTo(const Picture& reference) const override
  {
    const auto result = OIIO::ImageBufAlgo::compare(this->Pixels, PixelsOf(reference), 0, 0);
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

  std::unique_ptr<Picture> AbsoluteDifference(const Picture& other, float factor) const override
  {
    const std::array<int, 3> colors{ { 0, 1, 2 } };
    const auto difference =
      OIIO::ImageBufAlgo::channels(OIIO::ImageBufAlgo::absdiff(this->Pixels, PixelsOf(other)), 3, colors);
    return std::make_unique<OpenImageIOPicture>(OIIO::ImageBufAlgo::mul(difference, factor));
  }

protected:
  void Write(const std::filesystem::path& file, const std::string& name, bool linear) const override
  {
    OIIO::ImageBuf out = linear ? ToLinearLight(this->Pixels) : this->Pixels;
    out.specmod().attribute("CompressionQuality", 95);    // JPEG
    out.specmod().attribute("jpeg:subsampling", "4:4:4"); // thin lines keep their colour
    out.specmod().attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    if (!out.write(file.string()))
    {
      throw Failure("'" + name + "' can't be written: " + out.geterror());
    }
  }

private:
  // All are made here.
  static const OIIO::ImageBuf& PixelsOf(const Picture& picture)
  {
    return static_cast<const OpenImageIOPicture&>(picture).Pixels;
  }

  OIIO::ImageBuf Pixels;
};
}

//------------------------------------------------------------------------------
extern "C" __attribute__((visibility("default"))) Picture* NewOpenImageIOPicture(
  int width, int height, int channels, const unsigned char* pixels)
{
  const OIIO::ImageSpec spec(
    width, height, channels, OIIO::TypeUInt8); // of four, OpenImageIO takes the last for the opacity
  const OIIO::ImageBuf upsideDown(spec, const_cast<unsigned char*>(pixels));
  return new OpenImageIOPicture(OIIO::ImageBufAlgo::flip(upsideDown));
}
