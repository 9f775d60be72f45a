// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What was drawn and what was computed, and how far they are apart.
 */
#ifndef Picture_h
#define Picture_h

#include <iosfwd>
#include <string>
#include <vector>

class vtkRenderWindow;

/// Channels of pixels, from the bottom left, in units of 1/255 and not rounded.
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<double> Rgb;

  double At(int x, int y, int channel) const { return this->Rgb[3 * (y * this->Width + x) + channel]; }

  bool operator==(const Picture& other) const
  {
    return this->Width == other.Width && this->Height == other.Height && this->Rgb == other.Rgb;
  }
};

struct PictureDifference
{
  double Largest = 0;        // of a channel, in units of 1/255
  double RootMeanSquare = 0; // of all channels, where 1 is the full range
  std::string Where;         // the pixel with the largest difference

  friend std::ostream& operator<<(std::ostream& os, const PictureDifference& difference);
};

/// The pixels of a window that has rendered.
Picture Capture(vtkRenderWindow* window);

/// Both have to be of the same size.
PictureDifference Compare(const Picture& a, const Picture& b);

/// A part of a picture.
Picture Crop(const Picture& picture, int x, int y, int width, int height);

#endif
