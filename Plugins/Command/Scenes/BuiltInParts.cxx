// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInParts.h"

#include "Inputs.h"
#include "Models/Cards.h"
#include "Models/Mesh.h"

#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

namespace
{
Part MakeColoredPart(const std::string& name, vtkPolyData* surface)
{
  Part part = MakePart(name, surface);
  part.Actor->GetMapper()->ScalarVisibilityOn();
  return part;
}

Vector3 ToVector3(const vtkVector3d& v)
{
  return { { v[0], v[1], v[2] } };
}

Part MakeUnlitPart(
  const Input& input, const std::string& name, vtkPolyData* surface, const std::optional<Color>& transmission)
{
  Part part = MakeColoredPart(name, surface);
  part.Actor->GetProperty()->LightingOff();
  part.Actor->ForceTranslucentOn();
  SetLook(part, { { 1, 1, 1 } }, input.Opacity.value_or(1), input.Transmission ? input.Transmission : transmission);
  return part;
}
}

//------------------------------------------------------------------------------
Part OpaquePart(const std::string& name, const Mesh& mesh)
{
  Part part = MakeColoredPart(name, mesh.ToPolyData(true));
  part.Actor->ForceOpaqueOn();
  return part;
}

//------------------------------------------------------------------------------
Part TranslucentPart(
  const Input& input, const std::string& name, const Mesh& mesh, const std::optional<Color>& transmission)
{
  return MakeUnlitPart(input, name, mesh.ToPolyData(false), transmission);
}

//------------------------------------------------------------------------------
Part CardPart(const Input& input, const std::string& name, const Cards& cards, vtkTexture* texture)
{
  Part part = MakeUnlitPart(input, name, cards.ToPolyData(), std::nullopt);
  part.Actor->SetTexture(texture);
  return part;
}

//------------------------------------------------------------------------------
void Use(const Setting& setting, Scene& scene)
{
  View& eye = scene.Eye;
  if (!eye.Position && !eye.Target && !eye.Direction && !eye.Angle && !eye.Height)
  {
    eye.Position = ToVector3(setting.Eye);
    eye.Target = ToVector3(setting.Target);
    eye.Angle = setting.Angle;
  }
  if (!scene.Behind)
  {
    scene.Behind = Background(setting.Behind);
  }
  if (scene.Lights.empty())
  {
    Light headlight;
    headlight.Intensity = setting.Headlight;
    Light sun;
    sun.Type = Light::Kind::Scene;
    sun.Position = ToVector3(setting.Sun);
    sun.Intensity = 1 - setting.Headlight;
    scene.Lights = { headlight, sun };
  }
}
