// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Noise.h"

#include "Vectors.h"

#include <cmath>
#include <cstdint>

namespace
{
// A number of -1 to 1 for each point of the lattice: integers only, so that all machines have the same.
double LatticeValue(std::int32_t x, std::int32_t y, std::int32_t z, int seed)
{
  std::uint32_t mixed = static_cast<std::uint32_t>(x) * 0x8da6b343U + static_cast<std::uint32_t>(y) * 0xd8163841U +
    static_cast<std::uint32_t>(z) * 0xcb1ab31fU + static_cast<std::uint32_t>(seed) * 0x9e3779b9U;
  mixed = (mixed ^ (mixed >> 15)) * 0x2c1b3c6dU;
  mixed = (mixed ^ (mixed >> 12)) * 0x297a2d39U;
  mixed ^= mixed >> 15;
  return mixed / 2147483647.5 - 1;
}

double Fade(double t)
{
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double Mix(double a, double b, double t)
{
  return a + (b - a) * t;
}
}

//------------------------------------------------------------------------------
double Noise(const vtkVector3d& place, int seed)
{
  std::int32_t cell[3];
  double part[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double floor = std::floor(place[axis]);
    cell[axis] = static_cast<std::int32_t>(floor);
    part[axis] = Fade(place[axis] - floor);
  }
  double layers[2];
  for (int z = 0; z < 2; ++z)
  {
    double rows[2];
    for (int y = 0; y < 2; ++y)
    {
      rows[y] = Mix(LatticeValue(cell[0], cell[1] + y, cell[2] + z, seed),
        LatticeValue(cell[0] + 1, cell[1] + y, cell[2] + z, seed), part[0]);
    }
    layers[z] = Mix(rows[0], rows[1], part[1]);
  }
  return Mix(layers[0], layers[1], part[2]);
}

//------------------------------------------------------------------------------
double Turbulence(const vtkVector3d& place, int seed)
{
  double sum = 0;
  for (int octave = 0; octave < 4; ++octave)
  {
    const double scale = 1 << octave;
    sum += Noise(place * scale, seed + octave) / scale;
  }
  return sum;
}

//------------------------------------------------------------------------------
vtkVector3d CurlNoise(const vtkVector3d& place, int seed)
{
  const double step = 0.01;
  double slopes[3][3]; // of each field along each axis
  for (int field = 0; field < 3; ++field)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      vtkVector3d after = place;
      vtkVector3d before = place;
      after[axis] += step;
      before[axis] -= step;
      slopes[field][axis] = (Noise(after, seed + 17 * field) - Noise(before, seed + 17 * field)) / (2 * step);
    }
  }
  return vtkVector3d(slopes[2][1] - slopes[1][2], slopes[0][2] - slopes[2][0], slopes[1][0] - slopes[0][1]);
}
