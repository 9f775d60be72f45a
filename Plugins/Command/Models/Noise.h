// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Smooth fields without a pattern, for what is turbulent.
 */
#ifndef Noise_h
#define Noise_h

#include "vtkVector.h"

/// Value noise: -1 to 1, of wavelengths of 1 and above.
double Noise(const vtkVector3d& place, int seed);

/// Four octaves of it, each of half the wavelength and half the height: about -1 to 1.
double Turbulence(const vtkVector3d& place, int seed);

/// The curl of three fields of noise: a flow that neither gathers nor thins what it carries (Bridson et al. 2007,
/// Curl-noise for procedural fluid flow).
vtkVector3d CurlNoise(const vtkVector3d& place, int seed);

#endif
