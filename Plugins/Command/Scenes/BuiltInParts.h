// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the built-in scenes are made of, and the functions that make each.
 */
#ifndef BuiltInParts_h
#define BuiltInParts_h

#include "Scene.h"

#include "vtkVector.h"

class vtkTexture;
struct Cards;
struct Input;
struct Mesh;
struct Specification;

/// Lit, whatever the input says of its look.
Part OpaquePart(const std::string& name, const Mesh& mesh);

/// Not lit: its colours are what is seen. The input's opacity multiplies its own.
Part TranslucentPart(const Input& input, const std::string& name, const Mesh& mesh,
  const std::optional<Color>& transmission = std::nullopt);

/// The same with quads. texture may be null.
Part CardPart(const Input& input, const std::string& name, const Cards& cards, vtkTexture* texture);

/// How a built-in scene is meant to be seen.
struct Setting
{
  vtkVector3d Eye;
  vtkVector3d Target;
  double Angle; ///< degrees, of the height of the picture
  Color Behind;
  vtkVector3d Sun;  ///< the way to a far light
  double Headlight; ///< intensity; that of the far light is the rest of 1
};

/// What the scene file or the command line has not set already.
void Use(const Setting& setting, Scene& scene);

void AddSpheres(const Input& input, const Specification& wanted, Scene& scene);
void AddRectangles(const Input& input, const Specification& wanted, Scene& scene);
void AddSmoke(const Input& input, const Specification& wanted, Scene& scene);
void AddParticles(const Input& input, const Specification& wanted, Scene& scene);
void AddGlasses(const Input& input, const Specification& wanted, Scene& scene);
void AddBottle(const Input& input, const Specification& wanted, Scene& scene);
void AddMatter(const Input& input, const Specification& wanted, Scene& scene);
void AddFoliage(const Input& input, const Specification& wanted, Scene& scene);
void AddCar(const Input& input, const Specification& wanted, Scene& scene);

#endif
