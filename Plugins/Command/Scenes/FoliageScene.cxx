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
struct Crown
{
  vtkVector3d Middle;
  vtkVector3d Half; // its half axes
  double Share;     // of all leaves
};

const Crown Crowns[] = { { { -2.1, 2.75, -2 }, { 1.5, 1.15, 1.2 }, 0.42 },
  { { -1.2, 1.95, -1.4 }, { 0.9, 0.6, 0.8 }, 0.12 }, { { 2.3, 2.3, -3 }, { 1.3, 1.2, 1.1 }, 0.26 },
  { { 0.5, 0.75, -1.6 }, { 0.8, 0.5, 0.5 }, 0.1 }, { { 3.3, 0.6, -1.2 }, { 0.75, 0.5, 0.5 }, 0.1 } };

const vtkVector3d Sun = vtkVector3d(-0.55, 0.7, 0.45).Normalized();

double HeightOfGround(double x, double z)
{
  const double t = std::clamp((1.6 - z) / 3.2, 0.0, 1.0);
  return -0.8 + 1.05 * t * t * (3 - 2 * t) + 0.12 * Noise(vtkVector3d(x * 0.9, 0, z * 0.9), 5);
}

Mesh Ground()
{
  Mesh ground = Tessellate(
    [](double u, double v)
    {
      const double x = 24 * u - 12;
      const double z = 8 - 20 * v;
      return vtkVector3d(x, HeightOfGround(x, z), z);
    },
    120, 120);
  ground.Cover(
    [](const Vertex& vertex)
    {
      const double spots = 0.5 + 0.5 * Turbulence(vertex.Place * 2.5, 9);
      const Paint sand = Blend({ 0.42, 0.36, 0.25 }, { 0.75, 0.68, 0.5 }, spots);
      const Paint grass = Blend({ 0.16, 0.3, 0.1 }, { 0.4, 0.55, 0.2 }, spots);
      return Blend(sand, grass, (vertex.Place[1] - 0.05) / 0.15);
    });
  Mesh hills = Tessellate(
    [](double u, double v)
    {
      const double x = 30 * u - 15;
      return vtkVector3d(x, v * (1.6 + 0.7 * Turbulence(vtkVector3d(0.35 * x, 0, 0), 21)), -11.9);
    },
    160, 2);
  return ground.Append(hills.Cover({ 0.5, 0.62, 0.62 }));
}

// Trunks, with three branches each into their crowns.
Mesh Trunks()
{
  Mesh trunks;
  for (const int tree : { 0, 2 })
  {
    const Crown& crown = Crowns[tree];
    const vtkVector3d foot(crown.Middle[0] + 0.2, 0, crown.Middle[2]);
    const vtkVector3d fork = foot + (crown.Middle - foot) * 0.55;
    trunks.Append(Rod(foot, fork, 0.17, 0.11));
    for (int branch = 0; branch < 3; ++branch)
    {
      const vtkVector3d tip(0.7 * (branch - 1) * crown.Half[0], 0.3 - 0.3 * std::abs(branch - 1), 0.15 * branch);
      trunks.Append(Rod(fork, crown.Middle + tip, 0.1, 0.03));
    }
  }
  return trunks.Cover(
    [](const Vertex& vertex) {
      return Blend({ 0.2, 0.13, 0.08 }, { 0.45, 0.33, 0.22 }, 0.5 + Turbulence(vertex.Place * 4.0, 2));
    });
}

vtkVector3d AnyDirection(Random& random)
{
  const double height = random.Next(-1, 1);
  const double angle = random.Next(0, 2 * vtkMath::Pi());
  const double width = std::sqrt(1 - height * height);
  return vtkVector3d(width * std::cos(angle), height, width * std::sin(angle));
}

// Cards that lie roughly in the crown's surface, and not edge-on to the eye.
void AddLeaves(const Crown& crown, int count, const vtkVector3d& eye, Random& random, Cards& leaves)
{
  for (int i = 0; i < count; ++i)
  {
    const vtkVector3d outward = AnyDirection(random);
    const double depth = std::pow(random.Next(0, 1), 0.4);
    vtkVector3d place = crown.Middle;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] += crown.Half[axis] * depth * outward[axis] * random.Next(0.85, 1.1);
    }
    const vtkVector3d toEye = (eye - place).Normalized();
    const vtkVector3d normal = (outward * 0.5 + AnyDirection(random) * 0.5 + toEye).Normalized();
    const vtkVector3d side = normal.Cross(AnyDirection(random)).Normalized();
    const double size = random.Next(0.38, 0.6);
    const double light = (0.25 + 0.35 * depth + 0.4 * outward.Dot(Sun)) * random.Next(0.8, 1.1);
    Paint paint = Blend({ 0.05, 0.14, 0.04 }, { 0.42, 0.66, 0.16 }, light);
    paint = Blend(paint, { 0.8, 0.85, 0.35 }, light - 0.65);
    leaves.Add(place, side * size, normal.Cross(side) * size, paint);
  }
}

// Mist over the water, and pollen that shines in the sun.
Cards Particles(int count, const vtkVector3d& eye, Random& random)
{
  Cards particles;
  for (int i = 0; i < count; ++i)
  {
    const bool mist = i % 2 == 0;
    const double x = random.Next(-4.5, 4.5);
    const double radius = mist ? random.Next(0.25, 0.6) : random.Next(0.015, 0.05);
    const double y = mist ? radius * random.Next(0.75, 1) : random.Next(0.1, 3.2);
    const double z = mist ? random.Next(0.3, 2.5) : random.Next(-1.5, 4);
    const Paint paint = mist ? Paint{ 0.93, 0.96, 1, 0.16 } : Paint{ 1, 0.96, 0.75, 0.85 };
    particles.AddFacing(eye, vtkVector3d(x, y, z), radius, 0, paint);
  }
  return particles;
}

Mesh Water(const vtkVector3d& eye)
{
  Mesh water = Tessellate(
    [](double u, double v)
    {
      const vtkVector3d place(20 * u - 10, 0, 8 - 10 * v);
      const double waves = Turbulence(vtkVector3d(1.5 * place[0], 0, 4 * place[2]), 31);
      return place + vtkVector3d(0, 0.006 * waves, 0);
    },
    240, 200);
  Glaze(water, eye, { 0.03, 0.16, 0.17, 0.3 },
    { { 0.1, 0.2, 0.15 }, { 0.5, 0.62, 0.6 }, { 0.72, 0.85, 0.97 }, { { Sun, 0.985, { 3, 2.8, 2.4 } } } });
  return water;
}
}

//------------------------------------------------------------------------------
// Leaves with soft edges by a water, with particles: rows 6 to 9 of figure 3 of Wavelet Transparency (2021).
void AddFoliage(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 1400, 10, 100000);
  Random random(wanted.GetInteger("seed", 1, 1, 1000000));
  const vtkVector3d eye(0, 1.5, 9);
  Mesh opaque = Ground();
  scene.Parts.push_back(OpaquePart("ground", opaque.Append(Trunks())));
  Cards leaves;
  for (const Crown& crown : Crowns)
  {
    AddLeaves(crown, static_cast<int>(count * crown.Share), eye, random, leaves);
  }
  vtkSmartPointer<vtkTexture> twig = Leaves(7);
  vtkSmartPointer<vtkTexture> disc = SoftDisc();
  scene.Parts.push_back(CardPart(input, "leaves", leaves, twig));
  scene.Parts.push_back(TranslucentPart(input, "water", Water(eye)));
  scene.Parts.push_back(CardPart(input, "particles", Particles(count / 5, eye, random), disc));
  Use({ eye, { 0, 1.35, 0 }, 31, { { 0.74, 0.85, 0.93 } }, Sun, 0.25 }, scene);
}
