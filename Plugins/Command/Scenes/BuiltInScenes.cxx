// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInScenes.h"

#include "Basics/Failure.h"
#include "Basics/Specification.h"
#include "BuiltInParts.h"
#include "Inputs.h"

#include <string>
#include <vector>

namespace
{
struct BuiltInScene
{
  const char* Name;
  const char* Help;
  std::vector<std::string> Keys;
  void (*Add)(const Input& input, const Specification& wanted, Scene& scene);
};

const BuiltInScene BuiltInScenes[] = {
  { "scene:spheres", "overlapping spheres of 20,000 triangles, opacity 0.3 (count=40:seed=1)", { "count", "seed" },
    AddSpheres },
  { "scene:rectangles",
    "overlapping unlit rectangles, opacity 0.02 to 0.3, parallel projection "
    "(count=300:meshes=300:seed=1)",
    { "count", "meshes", "seed" }, AddRectangles },
  { "scene:smoke", "smoke about a ball (count=900:seed=1:sphere=opaque, or transparent)", { "count", "seed", "sphere" },
    AddSmoke },
  { "scene:glasses", "drinking glasses on tables, some tinted, some with wine (count=60:seed=1)", { "count", "seed" },
    AddGlasses },
  { "scene:foliage", "leaves with soft edges by a water, mist, pollen (count=1400:seed=1)", { "count", "seed" },
    AddFoliage },
  { "scene:car", "a car with tinted windows in fog (count=120:seed=1)", { "count", "seed" }, AddCar },
  { "scene:bottle", "a green bottle of red wine, and a glass of it (label=no, or yes)", { "label" }, AddBottle },
  { "scene:matter", "a glass ball, a frosted globe, a bottle of wine (materials=yes, or no)", { "materials" },
    AddMatter },
  { "scene:particles", "a fire behind smoke (count=900:seed=1)", { "count", "seed" }, AddParticles },
};
}

//------------------------------------------------------------------------------
bool AddBuiltInScene(const Input& input, Scene& scene)
{
  const std::string prefix = "scene:";
  if (input.Source.compare(0, prefix.size(), prefix) != 0)
  {
    return false;
  }
  const Specification wanted(input.Source.substr(prefix.size()));
  for (const BuiltInScene& builtIn : BuiltInScenes)
  {
    if (prefix + wanted.Name == builtIn.Name)
    {
      wanted.CheckKeys(builtIn.Keys);
      builtIn.Add(input, wanted, scene);
      return true;
    }
  }
  throw Failure("there is no scene '" + prefix + wanted.Name + "', expected one of: " + Listed(BuiltInSceneNames()));
}

//------------------------------------------------------------------------------
std::vector<std::string> BuiltInSceneNames()
{
  std::vector<std::string> names;
  for (const BuiltInScene& builtIn : BuiltInScenes)
  {
    names.emplace_back(builtIn.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
std::string BuiltInSceneHelp()
{
  std::string help;
  for (const BuiltInScene& builtIn : BuiltInScenes)
  {
    help += "  " + std::string(builtIn.Name) + "  " + builtIn.Help + "\n";
  }
  return help;
}
