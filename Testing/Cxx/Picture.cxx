// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <ostream>
#include <sstream>
#include <stdexcept>

//------------------------------------------------------------------------------
Picture Capture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ShouldRerenderOff();
  grabber->ReadFrontBufferOff();
  grabber->Update();
  vtkImageData* image = grabber->GetOutput();
  Picture picture;
  picture.Width = image->GetDimensions()[0];
  picture.Height = image->GetDimensions()[1];
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  picture.Rgb.assign(bytes, bytes + 3 * picture.Width * picture.Height);
  return picture;
}

//------------------------------------------------------------------------------
PictureDifference Compare(const Picture& a, const Picture& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    throw std::invalid_argument("pictures differ in size");
  }
  PictureDifference result;
  double squares = 0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < a.Rgb.size(); ++i)
  {
    const double difference = std::abs(a.Rgb[i] - b.Rgb[i]);
    squares += difference * difference;
    if (difference > result.Largest)
    {
      result.Largest = difference;
      worst = i;
    }
  }
  result.RootMeanSquare = std::sqrt(squares / static_cast<double>(a.Rgb.size())) / 255;
  const std::size_t pixel = worst / 3;
  std::ostringstream where;
  where << "x " << pixel % a.Width << ", y " << pixel / a.Width << ", channel " << worst % 3 << ": " << a.Rgb[worst]
        << " and " << b.Rgb[worst];
  result.Where = where.str();
  return result;
}

//------------------------------------------------------------------------------
Picture Crop(const Picture& picture, int x, int y, int width, int height)
{
  Picture part{ width, height, {} };
  for (int row = y; row < y + height; ++row)
  {
    const auto first = picture.Rgb.begin() + 3 * (row * picture.Width + x);
    part.Rgb.insert(part.Rgb.end(), first, first + 3 * width);
  }
  return part;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const PictureDifference& difference)
{
  return os << "largest " << difference.Largest << "/255 (" << difference.Where << "), RMSE "
            << difference.RootMeanSquare;
}
