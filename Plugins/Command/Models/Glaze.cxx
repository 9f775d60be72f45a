// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Glaze.h"

#include "Vectors.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double FrontReflectance = 0.05; // of glass in air, one side

double SmoothStep(double low, double high, double value)
{
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

vtkVector3d LightFrom(const vtkVector3d& direction, const Surroundings& surroundings)
{
  const double height = direction[1];
  const Paint sky = Blend(
    surroundings.Level, height < 0 ? surroundings.Below : surroundings.Above, SmoothStep(0, 0.6, std::abs(height)));
  vtkVector3d light(sky.Red, sky.Green, sky.Blue);
  for (const Lamp& lamp : surroundings.Lamps)
  {
    const double soft = (1 - lamp.Cosine) * 0.5; // vertices lie too far apart for a sharp edge
    const double share = SmoothStep(lamp.Cosine - soft, lamp.Cosine + soft, direction.Dot(lamp.Direction));
    light = light + vtkVector3d(lamp.Glow.Red, lamp.Glow.Green, lamp.Glow.Blue) * share;
  }
  return light;
}
}

//------------------------------------------------------------------------------
void Glaze(Mesh& mesh, const vtkVector3d& eye, const Paint& body, const Surroundings& surroundings)
{
  mesh.Cover(
    [&](const Vertex& vertex)
    {
      const vtkVector3d view = (vertex.Place - eye).Normalized();
      const double along = view.Dot(vertex.Normal);
      const double cosine = std::abs(along); // both sides mirror
      const double mirrored = FrontReflectance + (1 - FrontReflectance) * std::pow(1 - cosine, 5);
      const vtkVector3d light = LightFrom(view - vertex.Normal * (2 * along), surroundings) * mirrored;
      const double swallowed = 1 - std::pow(1 - body.Opacity, 1 / std::max(cosine, 0.25));
      const double brightest = std::max({ light[0], light[1], light[2] });
      // Of what is behind, as much is left as is neither mirrored nor swallowed; but no colour is above 1.
      const double opacity =
        std::clamp(std::max(1 - (1 - mirrored) * (1 - swallowed), brightest + swallowed * 0.5), 1e-3, 1.0);
      return Paint{ (light[0] + swallowed * body.Red) / opacity, (light[1] + swallowed * body.Green) / opacity,
        (light[2] + swallowed * body.Blue) / opacity, opacity };
    });
}
