// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Glass as colours and opacities of a mesh, for one eye: what it mirrors, more of it the more it is seen from the side
 * (Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering), and what it swallows, more of it where the
 * way through it is longer. Drawn without lights, it is the same by every technique, also where that has no lights'
 * gloss.
 */
#ifndef Glaze_h
#define Glaze_h

#include "Mesh.h"

#include <vector>

struct Lamp
{
  vtkVector3d Direction; ///< to it, a unit vector
  double Cosine;         ///< of the angle from its middle to its edge
  Paint Glow;            ///< may be above 1
};

/// What surfaces mirror.
struct Surroundings
{
  Paint Below;
  Paint Level;
  Paint Above;
  std::vector<Lamp> Lamps;
};

/// body: the colour and the opacity of the glass itself where it is seen from the front.
void Glaze(Mesh& mesh, const vtkVector3d& eye, const Paint& body, const Surroundings& surroundings);

#endif
