// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInParts.h"

#include "Basics/Specification.h"
#include "Inputs.h"
#include "Models/Cards.h"
#include "Models/Glaze.h"
#include "Models/Random.h"
#include "Models/Shapes.h"
#include "Models/Vectors.h"

#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

// The car is 4.5 m long and drives along x; z is to its right, the ground is at y = 0.
namespace
{
const Paint Lacquer{ 0.68, 0.08, 0.07 };
const Paint Dark{ 0.07, 0.07, 0.08 };
const Color Mist{ { 0.76, 0.79, 0.82 } };
const vtkVector3d Up(0, 1, 0);

// The windows' frame, of its right half: where the panes meet at the belt and at the roof, from the front.
const vtkVector2d Belt[] = { { 1.02, 0.92 }, { -0.28, 0.95 }, { -1.72, 0.96 } };
const vtkVector2d Roof[] = { { 0.18, 1.42 }, { -0.32, 1.44 }, { -1.08, 1.42 } };
constexpr double BeltHalfWidth = 0.74;
constexpr double RoofHalfWidth = 0.57;

vtkVector3d AtBelt(int pillar, double side)
{
  return vtkVector3d(Belt[pillar][0], Belt[pillar][1], side * BeltHalfWidth);
}

vtkVector3d AtRoof(int pillar, double side)
{
  return vtkVector3d(Roof[pillar][0], Roof[pillar][1], side * RoofHalfWidth);
}

double Power(double base, double exponent)
{
  return std::copysign(std::pow(std::abs(base), exponent), base);
}

// Below the windows: cross-sections that are rounded boxes, between two lines along the car.
vtkVector3d BodyAt(double u, double v)
{
  static const std::vector<vtkVector2d> top{ { 0, 0.62 }, { 0, 0.93 }, { 0, 0.98 }, { 0, 0.97 }, { 0, 0.96 },
    { 0, 0.95 }, { 0, 0.94 }, { 0, 0.93 }, { 0, 0.92 }, { 0, 0.89 }, { 0, 0.83 }, { 0, 0.74 }, { 0, 0.55 } };
  static const std::vector<vtkVector2d> bottom{ { 0, 0.45 }, { 0, 0.3 }, { 0, 0.25 }, { 0, 0.24 }, { 0, 0.24 },
    { 0, 0.24 }, { 0, 0.24 }, { 0, 0.24 }, { 0, 0.24 }, { 0, 0.24 }, { 0, 0.24 }, { 0, 0.26 }, { 0, 0.4 } };
  const double along = std::sin(vtkMath::Pi() * (std::clamp(v, 0.0, 1.0) - 0.5));
  const double high = Spline(top, 0.5 + 0.5 * along)[1];
  const double low = Spline(bottom, 0.5 + 0.5 * along)[1];
  const double halfWidth = 0.85 * std::pow(1 - std::pow(std::abs(along), 6), 1.0 / 6);
  const double angle = -2 * vtkMath::Pi() * u;
  return vtkVector3d(2.25 * along, (high + low) / 2 + (high - low) / 2 * Power(std::sin(angle), 0.5),
    halfWidth * Power(std::cos(angle), 0.5));
}

Mesh Wheel()
{
  Mesh wheel = Revolve({ { 0, -0.1 }, { 0.2, -0.1 }, { 0.22, -0.12 }, { 0.3, -0.12 }, { 0.34, -0.08 }, { 0.34, 0.08 },
                         { 0.3, 0.12 }, { 0.22, 0.12 }, { 0.2, 0.1 }, { 0, 0.1 } },
    60, 3);
  wheel.Cover(
    [](const Vertex& vertex)
    {
      const double radius = std::hypot(vertex.Place[0], vertex.Place[2]);
      const bool spoke = std::fmod(std::atan2(vertex.Place[2], vertex.Place[0]) + vtkMath::Pi(), 1.2566) < 0.7;
      return radius < 0.06 || (radius < 0.21 && spoke) || std::abs(radius - 0.2) < 0.015 ? Paint{ 0.8, 0.8, 0.82 }
                                                                                         : Dark;
    });
  return wheel.Turn(vtkVector3d(1, 0, 0), 90);
}

Mesh Box(const vtkVector3d& middle, const vtkVector3d& half, double radius, const Paint& paint)
{
  return RoundedBox(half, radius).Move(middle).Cover(paint);
}

void AddInside(Mesh& car)
{
  const Paint leather{ 0.62, 0.5, 0.36 };
  for (const double side : { -0.36, 0.36 })
  {
    for (const double x : { -0.35, -1.15 })
    {
      Mesh back = RoundedBox(vtkVector3d(0.07, 0.22, 0.22), 0.06);
      car.Append(back.Turn(vtkVector3d(0, 0, 1), 12).Move(vtkVector3d(x, 0.98, side)).Cover(leather));
      car.Append(Box(vtkVector3d(x - 0.06, 1.25, side), vtkVector3d(0.045, 0.065, 0.11), 0.04, leather));
    }
  }
  const double driver = -0.36;
  car.Append(Ball(0.115, 40).Move(vtkVector3d(-0.17, 1.27, driver)).Cover({ 0.85, 0.65, 0.52 }));
  car.Append(Box(vtkVector3d(-0.2, 0.98, driver), vtkVector3d(0.1, 0.2, 0.19), 0.09, { 0.15, 0.25, 0.45 }));
  Mesh wheel = Tessellate(
    [](double u, double v)
    {
      const double around = 2 * vtkMath::Pi() * u;
      const double distance = 0.16 + 0.016 * std::cos(2 * vtkMath::Pi() * v);
      return vtkVector3d(
        distance * std::cos(around), 0.016 * std::sin(2 * vtkMath::Pi() * v), distance * std::sin(around));
    },
    40, 10);
  car.Append(wheel.Turn(vtkVector3d(0, 0, 1), 65).Move(vtkVector3d(0.22, 1.02, driver)).Cover(Dark));
}

Mesh Car()
{
  Mesh car = Tessellate(BodyAt, 120, 120);
  car.Cover([](const Vertex& vertex) { return vertex.Place[1] < 0.33 ? Dark : Lacquer; });
  for (const double side : { -1.0, 1.0 })
  {
    for (int pillar = 0; pillar < 3; ++pillar)
    {
      car.Append(Rod(AtBelt(pillar, side), AtRoof(pillar, side), 0.035, 0.03).Cover(pillar == 1 ? Dark : Lacquer));
    }
    for (int pillar = 0; pillar < 2; ++pillar)
    {
      car.Append(Rod(AtRoof(pillar, side), AtRoof(pillar + 1, side), 0.03, 0.03).Cover(Lacquer));
    }
    for (const double x : { 1.38, -1.38 })
    {
      car.Append(Wheel().Move(vtkVector3d(x, 0.34, side * 0.76)));
    }
    car.Append(Ball(0.12, 40).Move(vtkVector3d(2.06, 0.62, side * 0.56)).Cover({ 1, 1, 0.9 }));
    car.Append(Box(vtkVector3d(-2.13, 0.76, side * 0.6), vtkVector3d(0.06, 0.06, 0.16), 0.05, { 0.9, 0.05, 0.05 }));
    car.Append(Box(vtkVector3d(0.72, 0.99, side * 0.87), vtkVector3d(0.05, 0.06, 0.09), 0.04, Lacquer));
  }
  Mesh roof = RoundedBox(vtkVector3d(0.66, 0.035, RoofHalfWidth + 0.02), 0.034);
  car.Append(roof.Move(vtkVector3d(-0.45, 1.44, 0)).Cover(Lacquer));
  car.Append(Box(vtkVector3d(2.16, 0.46, 0), vtkVector3d(0.06, 0.07, 0.42), 0.04, Dark));
  AddInside(car);
  return car;
}

// Windscreen, rear window, and two panes a side.
Mesh Windows(const vtkVector3d& eye)
{
  Mesh panes;
  const auto add = [&panes](const vtkVector3d& a, const vtkVector3d& b, const vtkVector3d& c, const vtkVector3d& d) {
    panes.Append(Pane({ a, b, c, d }, 24, 24));
  };
  add(AtBelt(0, 1), AtBelt(0, -1), AtRoof(0, -1), AtRoof(0, 1));
  add(AtBelt(2, -1), AtBelt(2, 1), AtRoof(2, 1), AtRoof(2, -1));
  for (int pillar = 0; pillar < 2; ++pillar)
  {
    add(AtBelt(pillar + 1, 1), AtBelt(pillar, 1), AtRoof(pillar, 1), AtRoof(pillar + 1, 1));
    add(AtBelt(pillar, -1), AtBelt(pillar + 1, -1), AtRoof(pillar + 1, -1), AtRoof(pillar, -1));
  }
  Glaze(panes, eye, { 0.04, 0.09, 0.08, 0.4 }, { { 0.3, 0.3, 0.3 }, { 0.7, 0.73, 0.76 }, { 0.95, 0.97, 1 }, {} });
  return panes;
}

// The road, which the distance hides as the fog does.
Mesh Road(const vtkVector3d& eye)
{
  Mesh road = Tessellate([](double u, double v) { return vtkVector3d(80 * u - 50, 0, 30 - 80 * v); }, 80, 80);
  road.Cover({ 0.3, 0.31, 0.32 });
  for (int dash = -8; dash < 6; ++dash)
  {
    road.Append(Box(vtkVector3d(3.0 * dash, 0, -2), vtkVector3d(0.8, 0.01, 0.06), 0.005, { 0.9, 0.9, 0.88 }));
  }
  Mesh shade =
    Tessellate([](double u, double v) { return vtkVector3d(2.6 * (2 * u - 1), 0.004, 1.3 * (1 - 2 * v)); }, 40, 40);
  shade.Cover(
    [](const Vertex& vertex)
    {
      const double edge = std::max(std::abs(vertex.Place[0]) / 2.6, std::abs(vertex.Place[2]) / 1.3);
      return Blend({ 0.08, 0.08, 0.08 }, { 0.3, 0.31, 0.32 }, (edge - 0.6) / 0.4);
    });
  road.Append(shade);
  return road.Cover(
    [&eye](const Vertex& vertex)
    {
      const double distance = (vertex.Place - eye).Norm();
      return Blend(vertex.Look, { Mist[0], Mist[1], Mist[2] }, (distance - 7) / 14);
    });
}

// What the headlights light up.
Cards Beams(const vtkVector3d& eye)
{
  Cards beams;
  for (const double side : { -1.0, 1.0 })
  {
    for (int i = 0; i < 16; ++i)
    {
      const vtkVector3d place(2.2 + 0.14 * i, 0.62 - 0.01 * i, side * (0.56 + 0.01 * i));
      beams.AddFacing(eye, place, 0.22 + 0.035 * i, 0, { 1, 0.97, 0.8, 0.32 - 0.019 * i });
    }
  }
  return beams;
}

// Soft cards in front of the car, about it and behind it.
Cards Fog(int count, int seed, const vtkVector3d& eye)
{
  Random random(seed);
  Cards fog;
  for (int i = 0; i < count; ++i)
  {
    const double radius = random.Next(0.6, 1.2);
    const double y = random.Next(0.75 * radius, 1.9); // the road doesn't cut it, nor does the car
    double x = 0;
    double z = 0;
    do
    {
      x = random.Next(-5, 4.5);
      z = random.Next(-5, 3.2);
    } while (std::abs(x) < 2.3 + 0.6 * radius && std::abs(z) < 0.9 + 0.6 * radius);
    const double turn = random.Next(0, 2 * vtkMath::Pi());
    const double light = random.Next(0.95, 1.08);
    fog.AddFacing(eye, vtkVector3d(x, y, z), radius, turn, { light * Mist[0], light * Mist[1], light * Mist[2], 0.15 });
  }
  return fog;
}
}

//------------------------------------------------------------------------------
// A car in fog: figure 2a of Wavelet Transparency (2021).
void AddCar(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 120, 1, 10000);
  const int seed = wanted.GetInteger("seed", 1, 1, 1000000);
  const vtkVector3d eye(4.6, 1.75, 5.6);
  vtkSmartPointer<vtkTexture> puff = Puff(seed);
  vtkSmartPointer<vtkTexture> disc = SoftDisc();
  scene.Parts.push_back(OpaquePart("car", Car()));
  Part road = OpaquePart("road", Road(eye));
  road.Actor->GetProperty()->LightingOff(); // no light is to tell its end from the fog
  scene.Parts.push_back(road);
  scene.Parts.push_back(TranslucentPart(input, "windows", Windows(eye)));
  scene.Parts.push_back(CardPart(input, "fog", Fog(count, seed, eye), puff));
  scene.Parts.push_back(CardPart(input, "beams", Beams(eye), disc));
  Use({ eye, { 0.1, 0.72, 0 }, 30, Mist, { 0.2, 1, 0.4 }, 0.4 }, scene);
}
