// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticScene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTranslucencyPass.h>
#include <vtkUnsignedCharArray.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <set>
#include <stdexcept>
#include <string>

namespace
{
constexpr int DepthSteps = 65536;
constexpr double Farthest = 1 - 1.0 / DepthSteps;
constexpr int Cell = 20; // pixels between the edges of random rectangles

bool Covers(const Rectangle& rectangle, int x, int y)
{
  return x >= rectangle.Left && x < rectangle.Right && y >= rectangle.Bottom && y < rectangle.Top;
}

/// The places where the picture may change, along one axis.
std::vector<int> Borders(const AnalyticScene& scene, int Rectangle::*low, int Rectangle::*high, int size)
{
  std::set<int> borders = { 0, size };
  const auto add = [&](const Rectangle& rectangle)
  {
    borders.insert(std::clamp(rectangle.*low, 0, size));
    borders.insert(std::clamp(rectangle.*high, 0, size));
  };
  std::for_each(scene.Opaque.begin(), scene.Opaque.end(), add);
  for (const Layer& layer : scene.Translucent)
  {
    std::for_each(layer.begin(), layer.end(), add);
  }
  return { borders.begin(), borders.end() };
}

/// The fragment of a rectangle that hides a part only of what its opacity says, and adds as much light.
Reference::Fragment Hiding(const Rectangle& rectangle, double part)
{
  Reference::Fragment fragment{ rectangle.Depth, rectangle.Rgb, part * rectangle.Alpha };
  for (double& channel : fragment.Rgb)
  {
    channel /= part;
  }
  return fragment;
}

bool Transmits(const Rectangle& rectangle)
{
  return rectangle.Transmission != Reference::Color{ { 0, 0, 0 } };
}

Reference::Color ComputePixel(const AnalyticScene& scene, int x, int y, const AnalyticScene::Painter& paint)
{
  Reference::Color opaque = scene.Background;
  double opaqueDepth = 1;
  for (const Rectangle& rectangle : scene.Opaque)
  {
    if (Covers(rectangle, x, y) && rectangle.Depth < opaqueDepth)
    {
      opaqueDepth = rectangle.Depth;
      opaque = rectangle.Rgb;
    }
  }
  std::vector<Rectangle> covering;
  for (const Layer& layer : scene.Translucent)
  {
    std::copy_if(layer.begin(), layer.end(), std::back_inserter(covering),
      [&](const Rectangle& rectangle) { return Covers(rectangle, x, y) && rectangle.Depth < opaqueDepth; });
  }
  return paint(covering, opaque);
}

/// Each channel by itself.
Reference::Color PaintChannels(
  const std::vector<Rectangle>& covering, const Reference::Color& opaque, const Compositor& composite)
{
  const auto channelOver = [&](std::size_t channel)
  {
    std::vector<Reference::Fragment> fragments;
    for (const Rectangle& rectangle : covering)
    {
      fragments.push_back(Hiding(rectangle, 1 - rectangle.Transmission[channel]));
    }
    Reference::Pixel pixel = composite(fragments);
    for (double& color : pixel.Rgb)
    {
      color = std::min(color, 1.0); // as a framebuffer of bytes does before it blends; Overestimate can pass 1
    }
    return pixel.Over(opaque);
  };
  const bool transmits = std::any_of(covering.begin(), covering.end(), Transmits);
  const Reference::Color red = channelOver(0);
  return transmits ? Reference::Color{ { red[0], channelOver(1)[1], channelOver(2)[2] } } : red;
}

vtkSmartPointer<vtkPolyData> MakeQuads(const Layer& layer)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (const Rectangle& r : layer)
  {
    const double z = 1 - 2 * r.Depth; // see AddTo for the camera
    const vtkIdType corners[4] = { points->InsertNextPoint(r.Left, r.Bottom, z),
      points->InsertNextPoint(r.Right, r.Bottom, z), points->InsertNextPoint(r.Right, r.Top, z),
      points->InsertNextPoint(r.Left, r.Top, z) };
    quads->InsertNextCell(4, corners);
    for (double channel : { r.Rgb[0], r.Rgb[1], r.Rgb[2], r.Alpha })
    {
      colors->InsertNextValue(static_cast<unsigned char>(std::lround(255 * channel)));
    }
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  polyData->SetPolys(quads);
  if (layer.size() > 1)
  {
    polyData->GetCellData()->SetScalars(colors);
  }
  return polyData;
}

vtkSmartPointer<vtkActor> MakeActor(const Layer& layer)
{
  const bool one = layer.size() == 1; // else the cells have their colours
  auto actor = NewUnlitActor(
    MakeQuads(layer), one ? layer.front().Rgb : Reference::Color{ { 1, 1, 1 } }, one ? layer.front().Alpha : 1);
  const Reference::Color& transmission = layer.front().Transmission;
  if (Transmits(layer.front()))
  {
    vtkTranslucencyPass::SetTransmissionColor(actor, transmission[0], transmission[1], transmission[2]);
  }
  return actor;
}

AnalyticScene Rounded(AnalyticScene scene, double (*round)(double))
{
  for (Layer& layer : scene.Translucent)
  {
    for (Rectangle& rectangle : layer)
    {
      rectangle.Alpha = round(rectangle.Alpha);
      std::transform(rectangle.Rgb.begin(), rectangle.Rgb.end(), rectangle.Rgb.begin(), round);
    }
  }
  return scene;
}

/// Depths without repetition, in no order, in front of the farthest and none of them in the very middle: there is
/// opaque geometry.
std::vector<double> RandomDepths(std::mt19937& random, int count)
{
  std::uniform_int_distribution<int> step(1, DepthSteps - 2);
  std::set<int> taken = { DepthSteps / 2 };
  std::vector<double> depths;
  while (static_cast<int>(depths.size()) < count)
  {
    const int candidate = step(random);
    if (taken.insert(candidate).second)
    {
      depths.push_back(static_cast<double>(candidate) / DepthSteps);
    }
  }
  return depths;
}

Rectangle WholeView(const AnalyticScene& scene)
{
  return { 0, 0, scene.Width, scene.Height, 0, { { 0, 0, 0 } }, 1 };
}

/// A rectangle with edges on a grid, inside the view or across its border.
Rectangle PartOfView(const AnalyticScene& scene, std::mt19937& random)
{
  const auto pick = [&random](int size, int& low, int& high)
  {
    std::uniform_int_distribution<int> border(-1, size / Cell + 1);
    const int a = border(random);
    const int b = border(random);
    low = Cell * std::min(a, b);
    high = Cell * (std::max(a, b) + (a == b ? 1 : 0));
  };
  Rectangle rectangle = WholeView(scene);
  pick(scene.Width, rectangle.Left, rectangle.Right);
  pick(scene.Height, rectangle.Bottom, rectangle.Top);
  return rectangle;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> NewUnlitActor(vtkPolyData* data, const Reference::Color& rgb, double alpha)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->LightingOff();
  property->SetAmbient(1); // with diffuse 0, the shader's colour is the given one
  property->SetDiffuse(0);
  property->SetColor(rgb[0], rgb[1], rgb[2]);
  property->SetOpacity(alpha);
  return actor;
}

//------------------------------------------------------------------------------
Picture AnalyticScene::Compute(const Compositor& composite) const
{
  const Painter paint = [&composite](const std::vector<Rectangle>& covering, const Reference::Color& opaque)
  { return PaintChannels(covering, opaque, composite); };
  return this->Compute(paint);
}

//------------------------------------------------------------------------------
Picture AnalyticScene::Compute(const Painter& paint) const
{
  Picture picture{ this->Width, this->Height, {} };
  picture.Rgb.resize(3 * static_cast<std::size_t>(this->Width) * this->Height);
  const std::vector<int> columns = Borders(*this, &Rectangle::Left, &Rectangle::Right, this->Width);
  const std::vector<int> rows = Borders(*this, &Rectangle::Bottom, &Rectangle::Top, this->Height);
  for (std::size_t row = 0; row + 1 < rows.size(); ++row)
  {
    for (std::size_t column = 0; column + 1 < columns.size(); ++column)
    {
      const Reference::Color color = ComputePixel(*this, columns[column], rows[row], paint);
      for (int y = rows[row]; y < rows[row + 1]; ++y)
      {
        for (int x = columns[column]; x < columns[column + 1]; ++x)
        {
          for (int c = 0; c < 3; ++c)
          {
            picture.Rgb[3 * (y * this->Width + x) + c] = 255 * std::clamp(color[c], 0.0, 1.0);
          }
        }
      }
    }
  }
  return picture;
}

//------------------------------------------------------------------------------
void AnalyticScene::AddTo(vtkRenderer* renderer) const
{
  for (const Rectangle& rectangle : this->Opaque)
  {
    renderer->AddActor(MakeActor({ rectangle }));
  }
  for (const Layer& layer : this->Translucent)
  {
    const auto actor = MakeActor(layer);
    actor->ForceTranslucentOn();
    renderer->AddActor(actor);
  }
  renderer->SetBackground(this->Background[0], this->Background[1], this->Background[2]);
  // Window depth is (1 - z) / 2.
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(this->Height / 2.0);
  camera->SetPosition(this->Width / 2.0, this->Height / 2.0, 2);
  camera->SetFocalPoint(this->Width / 2.0, this->Height / 2.0, 0);
  camera->SetClippingRange(1, 3);
  renderer->SetActiveCamera(camera);
}

//------------------------------------------------------------------------------
AnalyticScene AnalyticScene::Reversed() const
{
  AnalyticScene scene = *this;
  std::reverse(scene.Translucent.begin(), scene.Translucent.end());
  for (Layer& layer : scene.Translucent)
  {
    std::reverse(layer.begin(), layer.end());
  }
  return scene;
}

//------------------------------------------------------------------------------
AnalyticScene AnalyticScene::Shrunk(int factor) const
{
  AnalyticScene scene = *this;
  const auto divide = [factor](int& length)
  {
    if (length % factor != 0)
    {
      throw std::invalid_argument(std::to_string(length) + " is no multiple of " + std::to_string(factor));
    }
    length /= factor;
  };
  const auto shrink = [&divide](Rectangle& rectangle)
  {
    for (int* edge : { &rectangle.Left, &rectangle.Bottom, &rectangle.Right, &rectangle.Top })
    {
      divide(*edge);
    }
  };
  divide(scene.Width);
  divide(scene.Height);
  std::for_each(scene.Opaque.begin(), scene.Opaque.end(), shrink);
  for (Layer& layer : scene.Translucent)
  {
    std::for_each(layer.begin(), layer.end(), shrink);
  }
  return scene;
}

//------------------------------------------------------------------------------
AnalyticScene AnalyticScene::Transmitting(unsigned int seed) const
{
  AnalyticScene scene = *this;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 0.9);
  for (Layer& layer : scene.Translucent)
  {
    const Reference::Color transmission{ { part(random), part(random), part(random) } };
    for (Rectangle& rectangle : layer)
    {
      rectangle.Transmission = transmission;
    }
  }
  return scene;
}

//------------------------------------------------------------------------------
AnalyticScene AnalyticScene::MeanTransmission() const
{
  AnalyticScene scene = *this;
  for (Layer& layer : scene.Translucent)
  {
    for (Rectangle& rectangle : layer)
    {
      const Reference::Color transmission = rectangle.Transmission;
      rectangle.Transmission.fill((transmission[0] + transmission[1] + transmission[2]) / 3);
    }
  }
  return scene;
}

//------------------------------------------------------------------------------
AnalyticScene AnalyticScene::RoundedToHalf() const
{
  return Rounded(
    *this, [](double value) -> double { return glm::unpackHalf1x16(glm::packHalf1x16(static_cast<float>(value))); });
}

//------------------------------------------------------------------------------
AnalyticScene AnalyticScene::RoundedToBytes() const
{
  return Rounded(*this, [](double value) { return std::round(255 * value) / 255; });
}

//------------------------------------------------------------------------------
AnalyticScene RandomLayers(int width, int height, unsigned int seed, int layers, double leastAlpha, double mostAlpha)
{
  AnalyticScene scene;
  scene.Width = width;
  scene.Height = height;
  scene.Background = { { 0.2, 0.4, 0.6 } };
  for (int x = 0; x < scene.Width; x += 4 * Cell)
  {
    scene.Opaque.push_back({ x, 0, x + 2 * Cell, scene.Height, Farthest, { { 0.8, 0.6, 0 } }, 1 });
  }
  scene.Opaque.push_back({ width / 4, height / 4, width / 2, 3 * height / 4, 0.5, { { 1, 1, 1 } }, 1 });

  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_real_distribution<double> opacity(leastAlpha, mostAlpha);
  for (double depth : RandomDepths(random, layers))
  {
    const bool whole = unit(random) < 2.0 / 3;
    Rectangle rectangle = whole ? WholeView(scene) : PartOfView(scene, random);
    rectangle.Depth = depth;
    rectangle.Rgb = { { unit(random), unit(random), unit(random) } };
    rectangle.Alpha = opacity(random);
    scene.Translucent.push_back({ rectangle });
  }
  return scene;
}

//------------------------------------------------------------------------------
AnalyticScene RandomMosaic(int width, int height, unsigned int seed, int fragments, double leastAlpha, double mostAlpha)
{
  AnalyticScene scene;
  scene.Width = width;
  scene.Height = height;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> level(0, 255);
  std::uniform_int_distribution<int> opacity(
    static_cast<int>(std::ceil(255 * leastAlpha)), static_cast<int>(std::floor(255 * mostAlpha)));
  scene.Translucent.resize(static_cast<std::size_t>(fragments));
  for (int y = 0; y < scene.Height; y += Cell)
  {
    for (int x = 0; x < scene.Width; x += Cell)
    {
      const std::vector<double> depths = RandomDepths(random, fragments);
      for (std::size_t i = 0; i < depths.size(); ++i)
      {
        const Reference::Color color{ { level(random) / 255.0, level(random) / 255.0, level(random) / 255.0 } };
        scene.Translucent[i].push_back({ x, y, x + Cell, y + Cell, depths[i], color, opacity(random) / 255.0 });
      }
    }
  }
  return scene;
}
