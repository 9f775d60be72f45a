// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Flat, unlit rectangles in parallel projection: a scene whose picture a few lines compute, whatever the techniques do.
 *
 * A unit of length is a pixel, edges lie on pixel borders, and depths are numbers that every float on the way to
 * gl_FragCoord.z holds without rounding: coverage and order are beyond doubt.
 */
#ifndef AnalyticScene_h
#define AnalyticScene_h

#include "Picture.h"
#include "Reference.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

/// Drawn in this very colour, without lights.
vtkSmartPointer<vtkActor> NewUnlitActor(vtkPolyData* data, const Reference::Color& rgb, double alpha);

struct Rectangle
{
  int Left;
  int Bottom;
  int Right;    // one past the last pixel
  int Top;      // one past the last pixel
  double Depth; // window depth, a multiple of 1/65536
  Reference::Color Rgb;
  double Alpha;
  Reference::Color Transmission{ { 0, 0, 0 } }; // an actor has one: that of its first rectangle
};

/// Rectangles that are drawn by one actor, in this order. Where there are several, colours and opacities are multiples
/// of 1/255, since VTK keeps those of cells in bytes.
using Layer = std::vector<Rectangle>;

/// How a pixel's translucent fragments, in the order of drawing, become its colour.
using Compositor = std::function<Reference::Pixel(const std::vector<Reference::Fragment>&)>;

struct AnalyticScene
{
  int Width = 400;
  int Height = 300;
  Reference::Color Background{ { 0, 0, 0 } }; // multiples of 1/255: the framebuffer holds it in bytes
  std::vector<Rectangle> Opaque;
  std::vector<Layer> Translucent; // in the order of drawing

  /// How a pixel's translucent rectangles, in the order of drawing, and what is opaque behind them become its colour.
  using Painter =
    std::function<Reference::Color(const std::vector<Rectangle>& covering, const Reference::Color& opaque)>;

  Picture Compute(const Painter& paint) const;

  /// The picture as it should be. With transmission colours each channel is composited by itself: a surface of opacity
  /// a and transmission t is one of opacity a * (1 - t) that adds as much light.
  Picture Compute(const Compositor& composite) const;

  /// Adds the actors and sets background and camera.
  void AddTo(vtkRenderer* renderer) const;

  /// The same with the translucent layers drawn the other way round.
  AnalyticScene Reversed() const;

  /// The same lists of fragments in fewer pixels: all lengths, which are multiples of the factor, are divided by it.
  AnalyticScene Shrunk(int factor) const;

  /// The same with transmission colours, from 0 to 0.9.
  AnalyticScene Transmitting(unsigned int seed) const;

  /// The same with the mean of each transmission colour instead of its channels.
  AnalyticScene MeanTransmission() const;

  /// The same with colours and opacities rounded as a fragment storage rounds them.
  AnalyticScene RoundedToHalf() const;
  AnalyticScene RoundedToBytes() const;
};

/// Layers of random depth, colour and draw order, two thirds of them as large as the view, over a background of stripes
/// and with an opaque rectangle in the middle of the depths.
AnalyticScene RandomLayers(int width, int height, unsigned int seed, int layers, double leastAlpha, double mostAlpha);

/// Every cell of a grid has fragments of its own, uniform in depth, colour and opacity, over black.
AnalyticScene RandomMosaic(
  int width, int height, unsigned int seed, int fragments, double leastAlpha, double mostAlpha);

#endif
