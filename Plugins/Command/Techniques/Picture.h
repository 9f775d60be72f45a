// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Pictures: written and compared by OpenImageIO, in a library of its own that is loaded with the first picture. What
 * OpenImageIO brings along, some 200 libraries on Debian, takes five times as long to load as all else that the command
 * needs to start.
 */
#ifndef Picture_h
#define Picture_h

#include <filesystem>
#include <memory>
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
  virtual ~Picture() = default;

  /// Writes .png, .jpg, .tif with 8 bits a channel, and .exr as linear light in 32-bit floats. Throws Failure; name is
  /// what to call the file in it.
  void Write(const std::filesystem::path& file, const std::string& name) const;

  virtual Difference CompareTo(const Picture& reference) const = 0;

  /// |this - other| * factor, clamped, of the colours.
  virtual std::unique_ptr<Picture> AbsoluteDifference(const Picture& other, float factor) const = 0;

protected:
  virtual void Write(const std::filesystem::path& file, const std::string& name, bool linear) const = 0;
};

/// From rows of 8-bit RGB, or RGBA with colours multiplied by their opacity, the lowest first, as OpenGL gives them.
/// Throws Failure.
std::unique_ptr<Picture> NewPicture(int width, int height, int channels, const unsigned char* pixels);

/// Throws Failure unless pictures of the file's suffix can be written.
void CheckPictureSuffix(const std::filesystem::path& file);

/// Throws Failure if pictures of the file's suffix can't hold opacities.
void CheckHoldsTransparency(const std::filesystem::path& file);

/// ".png .exr ..."
std::string PictureSuffixes();

#endif
