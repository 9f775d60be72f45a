// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Module/Shaders/Fourier, OpacityShadowMap, Wavelet and Moment, compiled as C++: the text that the GPU runs, once for
 * each number of terms that CMakeLists.txt lists, of channels, and for sums in 32 bits, in 16, and with a shared
 * exponent.
 */
#ifndef AbsorbanceShader_h
#define AbsorbanceShader_h

#include "Reference.h"

#include <string>
#include <vector>

/// Its depth is relative, 0 to 1. Alpha is that of the last channel.
struct Absorber
{
  float Depth;
  float Alpha;
  std::vector<float> Others = {}; // of the two first channels; empty: 1 - Alpha, and 0
};

struct AbsorbanceVariant
{
  std::string Technique; // Fourier, Slices, Wavelet or Moment
  int Terms;             // pairs of cosine and sine, slices, the rank, or vtkMomentTransparencyPass::Moments
  int Channels;
  bool Half;   // sums in 16 bits
  bool Shared; // sums of 9 bits, with an exponent for all channels

  /// Of each, in its last channel; what hides in the others is different. Overestimation is that of moments.
  std::vector<float> (*GetVisibilities)(const std::vector<Absorber>& absorbers, float overestimation);

  std::vector<float> operator()(const std::vector<Absorber>& absorbers, float overestimation = 0.25f) const
  {
    return this->GetVisibilities(absorbers, overestimation);
  }
};

/// All that were compiled.
const std::vector<AbsorbanceVariant>& AbsorbanceVariants();

/// The variant of one channel, or with a shared exponent that of three.
AbsorbanceVariant FindVariant(const std::string& technique, int terms, bool half, bool shared);

/// What the variant of one channel says that a pixel's fragments see.
Reference::Visibilities TextOf(const std::string& technique, int terms, bool half);

#endif
