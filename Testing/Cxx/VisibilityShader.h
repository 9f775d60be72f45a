// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Module/Shaders/Adaptive, compiled as C++: the text that the GPU runs, once for each number of nodes, rule of removal
 * and with or without alpha correction, as CMakeLists.txt lists.
 */
#ifndef VisibilityShader_h
#define VisibilityShader_h

#include "Reference.h"

#include <memory>
#include <string>
#include <vector>

class VisibilityShader
{
public:
  virtual ~VisibilityShader() = default;
  virtual void Insert(float depth, float alpha) = 0;

  /// A fragment of the pixel that does not cover the sample.
  virtual void InsertUncovered() = 0;

  /// For all fragments in the order of their insertion, as the resolve asks.
  virtual float TransmittanceBefore(float depth) = 0;

  /// The same with alpha correction, before the sum is scaled.
  virtual float VisibilityAt(float depth, float alpha) = 0;

  /// The sum of weights that have colours, scaled if nodes were removed.
  virtual float GetCorrected(float color, float weights) const = 0;

  /// The nodes in use.
  virtual std::vector<Reference::Node> GetNodes() const = 0;

  /// Of its error (ESTIMATE_ERROR).
  virtual float GetEstimate() const = 0;

  /// The transmittance behind everything.
  virtual float GetTotal() const = 0;
};

struct VisibilityVariant
{
  int NodeCount;
  Reference::Removal Rule;
  bool Corrected;
  std::unique_ptr<VisibilityShader> (*New)();

  std::string GetName() const;
};

/// All that were compiled.
const std::vector<VisibilityVariant>& VisibilityVariants();

#endif
