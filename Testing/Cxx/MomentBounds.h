// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The least and the most mass that any distribution with given power moments has in front of a depth, by linear
 * programming: over masses at very many depths, nearer to each other around those that have some in the solution. It
 * knows no theory of moments, and shares nothing with the shaders that it judges.
 *
 * Depths are any numbers, and mass may lie at infinity, too. Moments are the sums of mass times depth^k, k from 0 to an
 * even number. depths are those at which mass may lie besides: a distribution that is known to have these moments,
 * where few have.
 */
#ifndef MomentBounds_h
#define MomentBounds_h

#include <vector>

struct MomentBound
{
  double Mass;
  std::vector<double> Slopes; // how it changes with each moment
};

MomentBound LeastInFront(const std::vector<double>& moments, const std::vector<double>& depths, double depth);

/// In front of a depth and at it.
MomentBound MostUpTo(const std::vector<double>& moments, const std::vector<double>& depths, double depth);

#endif
