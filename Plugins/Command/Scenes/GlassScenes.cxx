// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInParts.h"

#include "Basics/Specification.h"
#include "Inputs.h"
#include "Models/Glaze.h"
#include "Models/Noise.h"
#include "Models/Random.h"
#include "Models/Shapes.h"
#include "Models/Vectors.h"

#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkTranslucencyMaterial.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
using Profile = std::vector<vtkVector2d>; // radius and height in decimetres: up outside, over the rim, down inside

// A kind of glass, or a wine.
struct Material
{
  const char* Name;
  Paint Body;
  std::optional<Color> Transmission;
};

const Material Clear{ "clear glass", { 0.1, 0.12, 0.12, 0.05 }, std::nullopt };
const Material GreenGlass{ "green glass", { 0.01, 0.03, 0.012, 0.5 }, Color{ { 0.5, 0.82, 0.45 } } };
const Material RedWine{ "red wine", { 0.09, 0, 0.015, 0.65 }, Color{ { 0.6, 0.03, 0.1 } } };
const Material WhiteWine{ "white wine", { 0.1, 0.085, 0.02, 0.3 }, Color{ { 0.98, 0.9, 0.4 } } };

const Profile WineGlass{ { 0, 0 }, { 0.33, 0 }, { 0.35, 0.015 }, { 0.33, 0.03 }, { 0.14, 0.06 }, { 0.045, 0.16 },
  { 0.036, 0.45 }, { 0.05, 0.76 }, { 0.2, 0.87 }, { 0.37, 1.1 }, { 0.41, 1.4 }, { 0.37, 1.72 }, { 0.33, 1.95 },
  { 0.322, 1.957 }, { 0.315, 1.95 }, { 0.355, 1.72 }, { 0.394, 1.4 }, { 0.352, 1.11 }, { 0.18, 0.895 }, { 0, 0.84 } };
const Profile WineInGlass{ { 0, 0.855 }, { 0.172, 0.907 }, { 0.342, 1.12 }, { 0.376, 1.29 }, { 0.376, 1.29 },
  { 0, 1.29 } };
const Profile Tumbler{ { 0, 0 }, { 0.29, 0 }, { 0.31, 0.02 }, { 0.325, 0.35 }, { 0.345, 0.75 }, { 0.365, 1.15 },
  { 0.357, 1.157 }, { 0.348, 1.15 }, { 0.328, 0.75 }, { 0.306, 0.35 }, { 0.285, 0.16 }, { 0, 0.13 } };
const Profile WineInTumbler{ { 0, 0.145 }, { 0.275, 0.175 }, { 0.296, 0.36 }, { 0.308, 0.6 }, { 0.308, 0.6 },
  { 0, 0.6 } };
const Profile Bottle{ { 0, 0.2 }, { 0.14, 0.14 }, { 0.25, 0.02 }, { 0.33, 0 }, { 0.37, 0.05 }, { 0.375, 0.3 },
  { 0.375, 1.1 }, { 0.375, 1.85 }, { 0.33, 2.07 }, { 0.2, 2.27 }, { 0.15, 2.45 }, { 0.143, 2.7 }, { 0.143, 2.87 },
  { 0.158, 2.9 }, { 0.158, 2.98 }, { 0.13, 3 }, { 0.1, 2.98 }, { 0.103, 2.7 }, { 0.112, 2.45 }, { 0.165, 2.25 },
  { 0.295, 2.05 }, { 0.335, 1.85 }, { 0.335, 1.1 }, { 0.335, 0.3 }, { 0.31, 0.1 }, { 0.24, 0.1 }, { 0.14, 0.22 },
  { 0, 0.28 } };
const Profile WineInBottle{ { 0, 0.3 }, { 0.146, 0.238 }, { 0.242, 0.12 }, { 0.3, 0.12 }, { 0.325, 0.3 },
  { 0.325, 1.1 }, { 0.325, 1.84 }, { 0.285, 2.04 }, { 0.24, 2.1 }, { 0.24, 2.1 }, { 0, 2.1 } };

// A bar at night: warm lamps, and a window to the left.
const Surroundings Bar{ { 0.22, 0.13, 0.07 }, { 0.3, 0.24, 0.2 }, { 0.45, 0.4, 0.36 },
  { { { -0.62, 0.45, 0.64 }, 0.93, { 10, 11, 13 } }, { { 0.57, 0.55, 0.61 }, 0.97, { 16, 13, 9 } },
    { { 0.6, 0.5, -0.62 }, 0.95, { 4, 3.2, 2.2 } } } };

// A table by a window, in daylight.
const Surroundings Daylight{ { 0.4, 0.3, 0.2 }, { 0.75, 0.75, 0.72 }, { 0.9, 0.93, 1 },
  { { { -0.62, 0.35, 0.7 }, 0.94, { 13, 13.5, 14 } }, { { 0.75, 0.3, 0.58 }, 0.975, { 9, 9, 8.5 } } } };

const vtkVector3d AboveTable(0, 0.002, 0); // so that no depths are equal

Paint Wood(const vtkVector3d& place, int seed)
{
  const double grain = Noise(vtkVector3d(1.2 * place[0], 3, 9 * place[2] + Noise(place * 1.1, seed)), seed + 3);
  return Blend({ 0.3, 0.17, 0.09 }, { 0.55, 0.34, 0.19 }, 0.5 + 0.6 * grain);
}

// A round table whose top is at height 0.
Mesh Table(double radius, double legHeight, int seed)
{
  const Profile profile{ { 0, -legHeight }, { 0.5 * radius, -legHeight }, { 0.5 * radius, -legHeight + 0.08 },
    { 0.1, -legHeight + 0.25 }, { 0.1, -0.4 }, { 0.15, -0.16 }, { 0.15, -0.16 }, { radius - 0.04, -0.16 },
    { radius, -0.1 }, { radius, -0.04 }, { radius - 0.03, 0 }, { radius - 0.03, 0 }, { 0.6 * radius, 0 },
    { 0.3 * radius, 0 }, { 0, 0 } };
  return Revolve(profile, 96, 5).Cover([seed](const Vertex& vertex) { return Wood(vertex.Place, seed); });
}

Part GlazedPart(
  const Input& input, const Material& material, Mesh& mesh, const vtkVector3d& eye, const Surroundings& surroundings)
{
  Glaze(mesh, eye, material.Body, surroundings);
  return TranslucentPart(input, material.Name, mesh, material.Transmission);
}

// Where the glasses stand that a table has room for, about its middle: a spiral in which none touches another.
vtkVector3d PlaceOnTable(int number)
{
  const double goldenAngle = vtkMath::Pi() * (3 - std::sqrt(5.0));
  const double distance = 0.5 * std::sqrt(number + 0.5);
  return vtkVector3d(distance * std::cos(goldenAngle * number), 0, distance * std::sin(goldenAngle * number));
}

// The tables stand in rows of 1, 2, 3, ...: where the view widens, more are seen.
vtkVector3d PlaceOfTable(int number)
{
  int row = 0;
  for (; number > row; ++row)
  {
    number -= row + 1;
  }
  return vtkVector3d(5.2 * (number - 0.5 * row) + 0.35 * row, 0, -4.4 * row);
}

// Balls of light above the tables.
Mesh Lamps(int tables)
{
  Mesh lamps;
  for (int table = 0; table < tables; ++table)
  {
    lamps.Append(Ball(0.3, 48).Move(PlaceOfTable(table) + vtkVector3d(0, 3.2, 0)));
  }
  return lamps.Cover({ 1, 0.86, 0.6 });
}

// About the front of the bottle.
Mesh Label()
{
  Mesh label = Tessellate(
    [](double u, double v)
    {
      const double angle = 1.2 * (1 - 2 * u) + 0.5 * vtkMath::Pi();
      return vtkVector3d(0.381 * std::cos(angle), 0.55 + 0.85 * v, 0.381 * std::sin(angle));
    },
    96, 96);
  return label.Cover(
    [](const Vertex& vertex)
    {
      const double height = vertex.Place[1];
      const bool line = (height > 0.62 && height < 0.65) || (height > 1.3 && height < 1.33);
      const bool title = height > 0.98 && height < 1.1 && std::abs(vertex.Place[0]) < 0.2;
      return line ? Paint{ 0.6, 0.45, 0.15 } : title ? Paint{ 0.35, 0.05, 0.08 } : Paint{ 0.95, 0.91, 0.8 };
    });
}
}

//------------------------------------------------------------------------------
// Glasses on tables, in many layers: rows 3 to 5 of figure 3 of Wavelet Transparency (2021).
void AddGlasses(const Input& input, const Specification& wanted, Scene& scene)
{
  const int count = wanted.GetInteger("count", 60, 1, 1000);
  const int seed = wanted.GetInteger("seed", 1, 1, 1000000);
  const int glassesOfTable = 15;
  const vtkVector3d eye(0, 2.5, 7);
  const Material tints[] = { Clear, Clear, Clear, GreenGlass,
    { "blue glass", { 0.01, 0.02, 0.05, 0.4 }, Color{ { 0.45, 0.7, 1 } } },
    { "amber glass", { 0.05, 0.025, 0.005, 0.4 }, Color{ { 1, 0.78, 0.4 } } } };
  std::map<std::string, std::pair<Material, Mesh>> meshes;
  const auto add = [&meshes](const Material& material, const Mesh& mesh)
  {
    auto& entry = meshes[material.Name];
    entry.first = material;
    entry.second.Append(mesh);
  };
  const Mesh kinds[] = { Revolve(WineGlass, 72, 3), Revolve(Tumbler, 72, 4) };
  const Mesh fillings[] = { Revolve(WineInGlass, 72, 4), Revolve(WineInTumbler, 72, 4) };
  Mesh tables;
  Random random(seed);
  for (int i = 0; i < count; ++i)
  {
    const int table = i / glassesOfTable;
    if (i % glassesOfTable == 0)
    {
      tables.Append(Table(2.2, 5, seed + table).Move(PlaceOfTable(table)));
    }
    const double angle = random.Next(0, 360);
    const int kind = random.Next(0, 1) < 0.65 ? 0 : 1;
    const Material& tint = tints[static_cast<int>(random.Next(0, 5.999))];
    const double filling = random.Next(0, 1);
    const vtkVector3d place = PlaceOfTable(table) + PlaceOnTable(i % glassesOfTable) + AboveTable;
    add(tint, Mesh(kinds[kind]).Turn(vtkVector3d(0, 1, 0), angle).Move(place));
    if (filling < 0.45 && std::string(tint.Name) == Clear.Name)
    {
      add(filling < 0.27 ? RedWine : WhiteWine, Mesh(fillings[kind]).Move(place));
    }
  }
  const int tableCount = (count - 1) / glassesOfTable + 1;
  scene.Parts.push_back(OpaquePart("tables", tables));
  const Part lamps = OpaquePart("lamps", Lamps(tableCount));
  lamps.Actor->GetProperty()->LightingOff(); // they shine
  scene.Parts.push_back(lamps);
  for (auto& entry : meshes)
  {
    scene.Parts.push_back(GlazedPart(input, entry.second.first, entry.second.second, eye, Bar));
  }
  Use({ eye, { 0, 0.8, -2 }, 34, { { 0.24, 0.17, 0.13 } }, { 0.2, 1, 0.3 }, 0.3 }, scene);
}

//------------------------------------------------------------------------------
// A bottle of wine: figure 2b.
void AddBottle(const Input& input, const Specification& wanted, Scene& scene)
{
  const bool labelled = wanted.GetChoice("label", { "no", "yes" }) == "yes";
  const vtkVector3d eye(0, 2.3, 8);
  const vtkVector3d glassPlace = AboveTable + vtkVector3d(1, 0, 0.35);
  Mesh opaque = Table(2.6, 5, 4);
  const Profile cork{ { 0, 0 }, { 0.09, 0 }, { 0.09, 0 }, { 0.1, 0.45 }, { 0.1, 0.45 }, { 0, 0.45 } };
  opaque.Append(Revolve(cork, 32, 3)
                  .Turn(vtkVector3d(0, 0, 1), 90)
                  .Turn(vtkVector3d(0, 1, 0), 25)
                  .Move(vtkVector3d(-0.55, 0.1, 0.9))
                  .Cover({ 0.78, 0.6, 0.4 }));
  if (labelled)
  {
    opaque.Append(Label());
  }
  scene.Parts.push_back(OpaquePart("table", opaque));
  Mesh bottle = Revolve(Bottle, 128, 4).Move(AboveTable);
  Mesh glass = Revolve(WineGlass, 128, 5).Move(glassPlace);
  Mesh wine = Revolve(WineInBottle, 128, 4).Move(AboveTable);
  wine.Append(Revolve(WineInGlass, 128, 5).Move(glassPlace));
  scene.Parts.push_back(GlazedPart(input, GreenGlass, bottle, eye, Daylight));
  scene.Parts.push_back(GlazedPart(input, RedWine, wine, eye, Daylight));
  scene.Parts.push_back(GlazedPart(input, Clear, glass, eye, Daylight));
  Use({ eye, { 0.25, 1.4, 0 }, 25, { { 0.86, 0.84, 0.8 } }, { -0.6, 1, 0.5 }, 0.3 }, scene);
}

//------------------------------------------------------------------------------
// What materials do: a ball that refracts and disperses, a frosted globe, and wine that absorbs by its thickness; after
// figures 1 and 6 of Wavelet Transparency (2021).
void AddMatter(const Input& input, const Specification& wanted, Scene& scene)
{
  const bool plain = wanted.GetChoice("materials", { "yes", "no" }) == "no";
  const auto add = [&](const char* name, const Mesh& mesh, const Color& transmission)
  {
    Part part = MakePart(name, mesh.ToPolyData(true));
    part.Actor->ForceTranslucentOn();
    part.Actor->GetProperty()->SetSpecular(0.6);
    part.Actor->GetProperty()->SetSpecularPower(80);
    SetLook(part, { { 0, 0, 0 } }, input.Opacity.value_or(1), input.Transmission.value_or(transmission));
    const auto material = vtkSmartPointer<vtkTranslucencyMaterial>::New();
    if (!plain)
    {
      vtkTranslucencyMaterial::SetMaterial(part.Actor, material);
    }
    scene.Parts.push_back(part);
    return material;
  };
  const auto cover = [](const Vertex& vertex)
  {
    const bool odd = (static_cast<int>(std::floor(2 * vertex.Place[0] + 0.013)) +
                       static_cast<int>(std::floor(2 * vertex.Place[1] + 0.013))) %
        2 !=
      0;
    return odd ? Paint{ 0.93, 0.9, 0.84 } : Paint{ 0.25, 0.36, 0.5 };
  };
  const vtkVector3d wall[4] = { vtkVector3d(-7, -0.5, -2.5), vtkVector3d(7, -0.5, -2.5), vtkVector3d(7, 6, -2.5),
    vtkVector3d(-7, 6, -2.5) };
  scene.Parts.push_back(OpaquePart("wall", Pane(wall, 560, 260).Cover(cover)));
  const vtkVector3d top[4] = { vtkVector3d(-7, 0, 3), vtkVector3d(7, 0, 3), vtkVector3d(7, 0, -2.5),
    vtkVector3d(-7, 0, -2.5) };
  scene.Parts.push_back(
    OpaquePart("table", Pane(top, 140, 55).Cover([](const Vertex& vertex) { return Wood(vertex.Place, 7); })));

  const auto ball = add("glass ball", Ball(0.8, 160).Move(vtkVector3d(-2, 0.801, 0)), { { 0.98, 1, 0.99 } });
  ball->SetIndexOfRefraction(1.5);
  ball->SetDispersion(0.2);
  ball->SetReflectance(0.04);
  const auto globe = add("frosted globe", Ball(0.8, 160).Move(vtkVector3d(0, 0.801, -0.2)), { { 0.93, 0.95, 0.97 } });
  globe->SetIndexOfRefraction(1.05);
  globe->SetDiffusion(0.09);
  globe->SetReflectance(0.04);
  const vtkVector3d place(2, 0.002, 0);
  const auto bottle = add("bottle", Revolve(Bottle, 128, 4).Move(place), { { 0.86, 0.95, 0.84 } });
  bottle->SetReflectance(0.04);
  const auto wine = add("wine", Revolve(WineInBottle, 128, 4).Move(place), { { 1, 1, 1 } });
  wine->SetAttenuationColor(0.75, 0.06, 0.15);
  wine->SetAttenuationDistance(0.5);
  wine->SetIndexOfRefraction(1.33);
  wine->SetReflectance(0.02);
  Use({ vtkVector3d(0.2, 2.2, 9), { 0.1, 1.25, 0 }, 25, { { 0.6, 0.65, 0.7 } }, { -0.3, 0.6, 1 }, 0.35 }, scene);
}
