// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Module/Shaders/Fourier, OpacityShadowMap and Wavelet, compiled as C++: the text that the GPU runs, once for each number of
 * terms that CMakeLists.txt lists and of channels.
 */
#ifndef AbsorbanceShader_h
#define AbsorbanceShader_h

#include <string>
#include <vector>

/// Its depth is relative, 0 to 1.
struct Absorber
{
  float Depth;
  float Alpha;
};

struct AbsorbanceVariant
{
  std::string Technique; // Fourier, Slices or Wavelet
  int Terms;             // pairs of cosine and sine, slices, or the rank
  int Channels;
  std::vector<float> (*GetVisibilities)(
    const std::vector<Absorber>&); // of each, in its last channel; what hides in the others is different
};

/// All that were compiled.
const std::vector<AbsorbanceVariant>& AbsorbanceVariants();

#endif
