// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is drawn, before any window exists: the actors, how they are lit, and from where they are seen.
 */
#ifndef Scene_h
#define Scene_h

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

using Vector3 = std::array<double, 3>;

/// Red, green and blue in 0..1, as a screen shows them.
using Color = std::array<double, 3>;

struct Part
{
  std::string Name;
  vtkSmartPointer<vtkActor> Actor; ///< with its mapper; each technique draws a copy of it
};

struct Light
{
  enum class Kind
  {
    Headlight, ///< shines from the eye
    Camera,    ///< position relative to the camera, which looks along -z from (0, 0, 1)
    Scene,     ///< position in the scene
  };
  Kind Type = Kind::Headlight;
  Vector3 Position{ { 0, 0, 1 } };
  Vector3 Target{ { 0, 0, 0 } };
  Color Tint{ { 1, 1, 1 } };
  double Intensity = 1;
};

/// What is not set is chosen so that the whole scene is seen.
struct View
{
  std::optional<Vector3> Direction; ///< from the eye to the scene's centre
  std::optional<Vector3> Position;
  std::optional<Vector3> Target;
  std::optional<Vector3> Up;
  std::optional<double> Angle;  ///< degrees, of the height of the picture
  std::optional<double> Height; ///< of the picture, in the scene's units: parallel projection
  double Azimuth = 0;           ///< degrees
  double Elevation = 0;         ///< degrees
  double Zoom = 1;
};

/// What is seen where nothing is drawn: nothing, too, where there is no colour.
using Background = std::optional<Color>;

struct Scene
{
  std::vector<Part> Parts;
  std::vector<Light> Lights; ///< none: a headlight
  View Eye;
  std::optional<Background> Behind; ///< not set: as a built-in scene wants it, else white
  std::array<int, 2> Size{ { 1280, 720 } };
  int Samples = 1; ///< of a pixel
};

/// The surface with an actor of its own; throws Failure, with the name, if it has no cells or points that are not
/// finite.
Part MakePart(const std::string& name, vtkPolyData* surface);

/// Throws Failure as MakePart does.
void CheckSurface(const std::string& name, vtkPolyData* surface);

Background BackgroundOf(const Scene& scene);

/// Gives a part its colour, its opacity and what it lets through of what lies behind it.
void SetLook(const Part& part, const Color& color, double opacity, const std::optional<Color>& transmission);

/// Polygons of all parts as triangles.
long long CountTriangles(const Scene& scene);

/// "#rrggbb" or a name that HTML knows; throws Failure otherwise. What names the setting in the message.
Color ParseColor(const std::string& what, const std::string& text);

/// The same, or "transparent".
Background ParseBackground(const std::string& what, const std::string& text);

/// The index-th of a series of colours that are easy to tell apart.
Color DistinctColor(int index);

#endif
