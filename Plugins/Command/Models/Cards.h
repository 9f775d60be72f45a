// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Quads with a colour, an opacity and the whole of a texture each: particles and leaves, as one mesh.
 */
#ifndef Cards_h
#define Cards_h

#include "Mesh.h"

class vtkTexture;

/// From one corner along two sides. Channels of the colour are 0 to 255, and cut to integers.
struct Card
{
  vtkVector3d Corner;
  vtkVector3d Right;
  vtkVector3d Up;
  std::array<double, 4> Color;
};

struct Cards
{
  std::vector<Card> All;

  void Add(const vtkVector3d& center, const vtkVector3d& right, const vtkVector3d& up, const Paint& paint);

  /// A square that faces the eye, turned by radians in its plane. Its sides are twice the radius.
  void AddFacing(const vtkVector3d& eye, const vtkVector3d& center, double radius, double turn, const Paint& paint);

  /// With texture coordinates, and colours of four components.
  vtkSmartPointer<vtkPolyData> ToPolyData() const;
};

/// White, opaque in the middle and clear from the inscribed circle on.
vtkSmartPointer<vtkTexture> SoftDisc();

/// White as well, but torn: a puff of smoke.
vtkSmartPointer<vtkTexture> Puff(int seed);

/// Some leaves on a twig: most of it is clear or opaque, with soft edges a texel or two wide.
vtkSmartPointer<vtkTexture> Leaves(int seed);

#endif
