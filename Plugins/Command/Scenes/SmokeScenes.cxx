// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInParts.h"

#include "Basics/Specification.h"
#include "Inputs.h"
#include "Models/Cards.h"
#include "Models/Glaze.h"
#include "Models/Noise.h"
#include "Models/Random.h"
#include "Models/Shapes.h"
#include "Models/Vectors.h"

#include "vtkMath.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkVector3d AnyPlace(Random& random, const vtkVector3d& half)
{
  const double x = random.Next(-half[0], half[0]);
  const double y = random.Next(-half[1], half[1]);
  const double z = random.Next(-half[2], half[2]);
  return vtkVector3d(x, y, z);
}

double AnyTurn(Random& random)
{
  return random.Next(0, 2 * vtkMath::Pi());
}

// Carried along by a turbulent flow, in small steps.
vtkVector3d Carried(vtkVector3d place, double wavelength, double way, int seed)
{
  const int steps = 8;
  for (int i = 0; i < steps; ++i)
  {
    place = place + CurlNoise(place * (1 / wavelength), seed) * (way / steps);
  }
  return place;
}

// A band of smoke that winds about the ball, thick where the noise is high, and lit from above.
Cards SmokeAbout(double ballRadius, int count, int seed, const vtkVector3d& eye)
{
  Random random(seed);
  Cards smoke;
  for (int i = 0; i < count; ++i)
  {
    vtkVector3d place = Carried(AnyPlace(random, vtkVector3d(2.6, 1.5, 1.9)), 1.4, 0.9, seed);
    const double thickness = Turbulence(place * 0.8, seed + 100);
    const double radius = random.Next(0.2, 0.42);
    const double distance = place.Norm();
    const double nearest = ballRadius + 0.9 * radius; // flows round it, and is not cut by it
    if (distance < nearest)
    {
      place = place * ((nearest + 0.3 * distance) / distance);
    }
    const double opacity = std::clamp(0.26 + 0.4 * thickness, 0.02, 0.6);
    const double light = 0.45 + 0.22 * place[1] - 0.25 * thickness;
    smoke.AddFacing(
      eye, place, radius, AnyTurn(random), Blend({ 0.16, 0.15, 0.17, opacity }, { 0.97, 0.95, 0.92, opacity }, light));
  }
  return smoke;
}

// A fire's tongues: broad and yellow below, narrow and red above.
Cards Fire(const vtkVector3d& foot, int count, int seed, const vtkVector3d& eye)
{
  Random random(seed);
  Cards fire;
  for (int i = 0; i < count; ++i)
  {
    const double age = random.Next(0, 1);
    const double spread = 0.75 * (1 - age) * std::sqrt(random.Next(0.02, 1));
    const double angle = AnyTurn(random);
    vtkVector3d place(spread * std::cos(angle), 2.5 * age * (1.1 - 0.5 * spread), spread * std::sin(angle));
    place = Carried(place - vtkVector3d(0, 1.3, 0), 0.8, 0.1 + 0.25 * age, seed) + vtkVector3d(0, 1.5, 0);
    const double heat = 1 - age - 0.5 * spread + random.Next(-0.1, 0.1);
    Paint paint = Blend({ 0.75, 0.12, 0.03, 0.14 }, { 1, 0.55, 0.08, 0.3 }, 2 * heat);
    paint = Blend(paint, { 1, 0.93, 0.6, 0.42 }, 2 * heat - 1);
    const double radius = (0.38 - 0.22 * age) * random.Next(0.7, 1.2);
    fire.AddFacing(eye, foot + place, radius, AnyTurn(random), paint);
  }
  return fire;
}

// A column that widens as it rises and leans with the wind; the side towards the fire is lit by it.
Cards SmokeColumn(const vtkVector3d& foot, int count, int seed, const vtkVector3d& eye)
{
  Random random(seed);
  Cards smoke;
  for (int i = 0; i < count; ++i)
  {
    const double age = random.Next(0, 1);
    const double width = 0.25 + 0.75 * age;
    const double distance = width * std::sqrt(random.Next(0, 1));
    const double angle = AnyTurn(random);
    vtkVector3d place(distance * std::cos(angle) + 0.9 * age * age, 0.2 + 3.6 * age, distance * std::sin(angle));
    place = Carried(place, 1.1, 0.6 * age, seed);
    const double glow = std::clamp(-0.7 * std::cos(angle) * (1 - age), 0.0, 1.0);
    const double shade = random.Next(0.25, 0.5) + 0.2 * age;
    const double opacity = 0.34 - 0.24 * age;
    smoke.AddFacing(eye, foot + place, 0.22 + 0.34 * age, AnyTurn(random),
      Blend({ shade, shade, shade * 1.06, opacity }, { 0.95, 0.5, 0.22, opacity }, glow));
  }
  return smoke;
}

Mesh Logs(const vtkVector3d& foot)
{
  Mesh logs;
  const std::vector<vtkVector2d> profile{ { 0, -0.75 }, { 0.14, -0.75 }, { 0.14, -0.75 }, { 0.13, 0.75 },
    { 0.13, 0.75 }, { 0, 0.75 } };
  for (int i = 0; i < 5; ++i)
  {
    Mesh log = Revolve(profile, 24, 4);
    log.Turn(vtkVector3d(1, 0, 0), 68).Turn(vtkVector3d(0, 1, 0), 72.0 * i).Move(foot + vtkVector3d(0, 0.12, 0));
    log.Cover(
      [i](const Vertex& vertex) {
        return Blend({ 0.13, 0.07, 0.04 }, { 0.4, 0.24, 0.13 }, 0.5 + Turbulence(vertex.Place * 6.0, i));
      });
    logs.Append(log);
  }
  return logs;
}
}

//------------------------------------------------------------------------------
// Smoke about a ball: rows 1 and 2 of figure 3 of Wavelet Transparency (2021).
void AddSmoke(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 900, 1, 100000);
  const int seed = wanted.GetInteger("seed", 1, 1, 1000000);
  const bool transparent = wanted.GetChoice("sphere", { "opaque", "transparent" }) == "transparent";
  const vtkVector3d eye(0, 0.4, 7);
  const double radius = 1;
  Mesh ball = Ball(radius, 128);
  if (transparent)
  {
    Glaze(ball, eye, { 0.16, 0.35, 0.6, 0.25 },
      { { 0.25, 0.1, 0.03 }, { 0.9, 0.5, 0.2 }, { 1, 0.85, 0.65 }, { { { -0.5, 0.7, 0.5 }, 0.93, { 14, 13, 12 } } } });
    scene.Parts.push_back(TranslucentPart(input, "sphere", ball));
  }
  else
  {
    ball.Cover({ 0.13, 0.36, 0.66 });
    scene.Parts.push_back(OpaquePart("sphere", ball));
  }
  vtkSmartPointer<vtkTexture> puff = Puff(seed);
  scene.Parts.push_back(CardPart(input, "smoke", SmokeAbout(radius, count, seed, eye), puff));
  Use({ eye, { 0, 0, 0 }, 33, { { 0.9, 0.5, 0.18 } }, { -0.5, 0.9, 0.5 }, 0.55 }, scene);
}

//------------------------------------------------------------------------------
// Two systems of particles, the one behind the other: figure 2c.
void AddParticles(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 900, 2, 100000);
  const int seed = wanted.GetInteger("seed", 1, 1, 1000000);
  const vtkVector3d eye(0.4, 1.5, 7.5);
  const vtkVector3d fireFoot(-0.75, 0, -1.2); // behind the smoke
  const vtkVector3d smokeFoot(0.1, 0, 0.9);
  Mesh ground = Tessellate([](double u, double v) { return vtkVector3d(24 * u - 12, 0, 6 - 30 * v); }, 96, 120);
  ground.Cover(
    [&fireFoot](const Vertex& vertex)
    {
      const double distance = (vertex.Place - fireFoot).Norm();
      return Blend({ 0.1, 0.11, 0.15 }, { 0.75, 0.4, 0.16 }, 1.3 / (1 + distance * distance));
    });
  scene.Parts.push_back(OpaquePart("ground", ground));
  scene.Parts.push_back(OpaquePart("logs", Logs(fireFoot)));
  vtkSmartPointer<vtkTexture> disc = SoftDisc();
  vtkSmartPointer<vtkTexture> puff = Puff(seed);
  scene.Parts.push_back(CardPart(input, "fire", Fire(fireFoot, count / 2, seed, eye), disc));
  scene.Parts.push_back(CardPart(input, "smoke", SmokeColumn(smokeFoot, count - count / 2, seed + 1, eye), puff));
  Use({ eye, { 0, 1.45, 0 }, 32, { { 0.05, 0.07, 0.13 } }, { -0.2, 1, 0.3 }, 0.3 }, scene);
}
