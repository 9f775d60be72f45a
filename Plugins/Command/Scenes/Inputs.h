// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a user names as input, and how it becomes parts of a scene.
 */
#ifndef Inputs_h
#define Inputs_h

#include "Scene.h"

#include "vtkTranslucencyMaterial.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// One label of a label volume.
struct LabelStyle
{
  std::string Name;
  std::optional<Color> Tint;
  std::optional<double> Opacity;
  std::optional<Color> Transmission;
};

/// Tubes round streamlines. What is not set is chosen by the size of the data. Lengths are in the file's units.
struct Streamtubes
{
  int Seeds = 100;              ///< streamlines, where as many points are fast enough
  double Speed = 0.1;           ///< of the largest: seeds are as fast or faster, lines end where it is slower
  std::optional<double> Length; ///< a line's most each way from its seed
  std::optional<double> Radius;
  int Sides = 12;
};

/// One input and how it is to look. What is not set is chosen by what the input holds.
struct Input
{
  enum class Meaning
  {
    Automatic, ///< labels if the scalars are integers of few values, else isosurfaces
    Labels,
    Isosurfaces,
  };

  std::string Source; ///< a file, or the name of a built-in scene: "scene:spheres:count=40"
  std::optional<Color> Tint;
  std::optional<double> Opacity;
  std::optional<Color> Transmission; ///< what surfaces let through of what lies behind them; by default nothing
  vtkSmartPointer<vtkTranslucencyMaterial> Material; ///< of all parts; null for what the input has
  Meaning Volume = Meaning::Automatic;
  std::vector<double> Isovalues;
  int Levels = 4;                         ///< isosurfaces where no Isovalues are given
  int Smoothing = 12;                     ///< iterations on the surfaces of labels
  std::map<long long, LabelStyle> Labels; ///< if there are any, only these are shown
  std::optional<Streamtubes> Tubes;       ///< shown in place of surfaces
};

/// Reads the input and appends its parts to the scene; throws Failure.
void AddInput(const Input& input, Scene& scene);

/// The suffixes that are read, for messages and help: ".vtp .vtu ...".
std::string InputSuffixes();

#endif
