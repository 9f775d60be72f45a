// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The visibility function of one pixel: what part of a surface is seen at each depth of its ray, by the fragments that
 * lie there, and as techniques have it.
 *
 * A technique's is measured by drawing, so that every technique is measured alike, with all its options: the pixel's
 * fragments become black quads across a picture of floats, in each column of which one more quad shines, of an
 * opacity so low that it hides nothing. What is seen of its light is the visibility at its depth.
 */
#ifndef Probe_h
#define Probe_h

#include "Techniques/Techniques.h"

#include "vtkStorageSimulator.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

class vtkCamera;

/// A place on the ray: its window depth, and its distance from the viewer's plane in the scene's units.
struct ProbeDepth
{
  double Window;
  double Distance;
};

struct ProbeFragment
{
  ProbeDepth Depth;
  double Opacity;
  double Transmittance; ///< of it and all in front of it
};

struct ProbeRow
{
  TechniqueChoice Technique;
  std::string Help;
  std::string Fallback;           ///< what was drawn instead, if the driver could not run it
  std::vector<double> Visibility; ///< at each of Depths
};

struct Probe
{
  std::string Title;
  std::vector<std::string> Inputs;
  std::array<int, 2> Size{ { 0, 0 } };
  std::array<int, 2> Pixel{ { 0, 0 } }; ///< from the lower left corner
  std::string Driver;
  std::vector<ProbeFragment> Fragments; ///< the nearest first
  std::vector<ProbeDepth> Depths;       ///< the nearest first: those of all fragments, and others between
  std::vector<double> Exact;            ///< at each of Depths, of all fragments in front of it
  std::vector<ProbeRow> Rows;
};

/// The fragments of one pixel, in the order of drawing. Throws Failure, with the scene's title, if it has none.
std::vector<vtkStorageSimulator::Fragment> TakePixel(const std::vector<vtkStorageSimulator::Fragment>& fragments,
  const std::array<int, 2>& pixel, const std::string& title);

/// Fills in Fragments, Depths and Exact: of one pixel's fragments, drawn with this camera. Of count depths, evenly
/// spread from the first fragment to the last, those are left out that coincide with a fragment's.
void AddExact(const std::vector<vtkStorageSimulator::Fragment>& fragments, vtkCamera* camera, int count, Probe& probe);

/// Fills in the Visibility and Fallback of all Rows, and Driver. fragments are in the order of drawing.
void MeasureRows(const std::vector<vtkStorageSimulator::Fragment>& fragments, vtkCamera* camera, Probe& probe);

/// How far the techniques are from the exact function, one line each.
std::string ToText(const Probe& probe);

/// Throws Failure unless probes of the file's suffix can be written: .json, with everything, or .csv.
void CheckProbeSuffix(const std::string& file);

/// As the file's suffix says.
std::string ToFile(const Probe& probe, const std::string& file);

#endif
