// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cards.h"

#include "Noise.h"
#include "Random.h"
#include "Vectors.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using Texels = std::function<Paint(double x, double y)>; // x and y from -1 to 1

vtkSmartPointer<vtkTexture> MakeTexture(int side, const Texels& texels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int row = 0; row < side; ++row)
  {
    for (int column = 0; column < side; ++column, bytes += 4)
    {
      const Paint texel = texels((2 * column + 1.0) / side - 1, (2 * row + 1.0) / side - 1);
      const double parts[4] = { texel.Red, texel.Green, texel.Blue, texel.Opacity };
      std::transform(parts, parts + 4, bytes,
        [](double part) { return static_cast<unsigned char>(std::lround(255 * std::clamp(part, 0.0, 1.0))); });
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOff();
  texture->EdgeClampOn();
  return texture;
}

struct Leaf
{
  double X;
  double Y;
  double Turn;
  double Length;
  double Shade;
};

// Above 0 inside the leaf: the distance to its edge, about. along goes from -1 at its stalk to 1 at its tip.
double Inside(const Leaf& leaf, double x, double y, double& along, double& across)
{
  const double dx = x - leaf.X;
  const double dy = y - leaf.Y;
  along = (dx * std::cos(leaf.Turn) + dy * std::sin(leaf.Turn)) / leaf.Length;
  across = (dy * std::cos(leaf.Turn) - dx * std::sin(leaf.Turn)) / leaf.Length;
  const double halfWidth = 0.42 * (1 - along * along) * (1 - 0.35 * along);
  return (halfWidth - std::abs(across)) * leaf.Length;
}
}

//------------------------------------------------------------------------------
void Cards::Add(const vtkVector3d& center, const vtkVector3d& right, const vtkVector3d& up, const Paint& paint)
{
  this->All.push_back({ center - (right + up) * 0.5, right, up,
    { { 255 * paint.Red, 255 * paint.Green, 255 * paint.Blue, 255 * paint.Opacity } } });
}

//------------------------------------------------------------------------------
void Cards::AddFacing(const vtkVector3d& eye, const vtkVector3d& center, double radius, double turn, const Paint& paint)
{
  const vtkVector3d view = (eye - center).Normalized();
  const vtkVector3d side = vtkVector3d(0, 1, 0).Cross(view).Normalized();
  const vtkVector3d upright = view.Cross(side);
  this->Add(center, (side * std::cos(turn) + upright * std::sin(turn)) * (2 * radius),
    (upright * std::cos(turn) - side * std::sin(turn)) * (2 * radius), paint);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Cards::ToPolyData() const
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const Card& card : this->All)
  {
    vtkIdType corners[4];
    for (int i = 0; i < 4; ++i)
    {
      const double u = i == 1 || i == 2 ? 1 : 0;
      const double v = i >= 2 ? 1 : 0;
      corners[i] = points->InsertNextPoint((card.Corner + card.Right * u + card.Up * v).GetData());
      colors->InsertNextTuple(card.Color.data());
      coordinates->InsertNextTuple2(u, v);
    }
    cells->InsertNextCell(4, corners);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->SetScalars(colors);
  surface->GetPointData()->SetTCoords(coordinates);
  return surface;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> SoftDisc()
{
  return MakeTexture(64,
    [](double x, double y)
    {
      const double inside = std::max(0.0, 1 - x * x - y * y);
      return Paint{ 1, 1, 1, inside * inside };
    });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> Puff(int seed)
{
  return MakeTexture(64,
    [seed](double x, double y)
    {
      const double inside = 1 - x * x - y * y;
      const double torn = Turbulence(vtkVector3d(2.2 * x + 50, 2.2 * y + 50, 0), seed);
      return Paint{ 1, 1, 1, std::max(0.0, inside) * std::clamp(0.55 * inside + 0.45 + 0.75 * torn, 0.0, 1.0) };
    });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> Leaves(int seed)
{
  Random random(seed);
  std::vector<Leaf> leaves;
  for (int i = 0; i < 14; ++i)
  {
    const double angle = 2.4 * i; // the golden angle: no leaf is over the one before
    const double distance = 0.62 * std::sqrt((i + 0.5) / 14);
    const double turn = angle + random.Next(-0.5, 0.5);
    leaves.push_back(
      { distance * std::cos(angle), distance * std::sin(angle), turn, random.Next(0.2, 0.3), random.Next(0.72, 1) });
  }
  return MakeTexture(128,
    [leaves](double x, double y)
    {
      Paint texel{ 0.85, 0.85, 0.85, 0 }; // the colour of what is clear counts at the edges
      for (const Leaf& leaf : leaves)
      {
        double along = 0;
        double across = 0;
        const double cover = std::clamp(Inside(leaf, x, y, along, across) / 0.025, 0.0, 1.0);
        if (std::abs(along) < 1 && cover > 0)
        {
          const double vein = std::abs(across) < 0.035 ? 1.15 : 1 - 0.25 * std::abs(across);
          const double shade = leaf.Shade * vein;
          const double opacity = std::max(texel.Opacity, cover);
          texel = Blend(texel, { shade, shade, shade }, cover);
          texel.Opacity = opacity;
        }
      }
      return texel;
    });
}
