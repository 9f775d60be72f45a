// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Pictures: written and compared by OpenImageIO.
 */
#ifndef Picture_h
#define Picture_h

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <optional>
#include <string>

/// How far a picture is from another, both with channels in 0..1.
struct Difference
{
  double Rmse = 0;            ///< root mean square error
  std::optional<double> Psnr; ///< decibels; none if the pictures are the same
  int Largest = 0;            ///< of all channels of all pixels, in steps of 1/255
};

class Picture
{
public:
  /// From rows of 8-bit RGB, or RGBA with colours multiplied by their opacity, the lowest first, as OpenGL gives them.
  Picture(int width, int height, int channels, const unsigned char* pixels);

  /// Writes .png, .jpg, .tif with 8 bits a channel, and .exr as linear light in 32-bit floats. Throws Failure; name is
  /// what to call the file in it.
  void Write(const std::filesystem::path& file, const std::string& name) const;

  Difference CompareTo(const Picture& reference) const;

  /// |this - other| * factor, clamped, of the colours.
  Picture AbsoluteDifference(const Picture& other, float factor) const;

private:
  explicit Picture(const OIIO::ImageBuf& pixels);
  OIIO::ImageBuf Pixels;
};

/// Throws Failure unless pictures of the file's suffix can be written.
void CheckPictureSuffix(const std::filesystem::path& file);

/// Throws Failure if pictures of the file's suffix can't hold opacities.
void CheckHoldsTransparency(const std::filesystem::path& file);

/// ".png .exr ..."
std::string PictureSuffixes();

#endif
