// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's passes around translucent props: chains of passes, by name, of which the innermost draws the steps of a frame.
 */
#ifndef Chains_h
#define Chains_h

#include <vtkSequencePass.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

/// A pass that draws what another one gives it.
template <typename Pass>
vtkSmartPointer<Pass> Around(vtkRenderPass* inner)
{
  auto pass = vtkSmartPointer<Pass>::New();
  pass->SetDelegatePass(inner);
  return pass;
}

vtkSmartPointer<vtkSequencePass> Sequence(const std::vector<vtkRenderPass*>& passes);

struct Chain
{
  std::string Name;

  /// The passes around steps whose translucent pass is this one.
  std::function<vtkSmartPointer<vtkRenderPass>(vtkRenderPass* translucent)> Make;

  /// Between what two techniques draw alike but for rounding, in units of 1/255: more where a pass looks for edges.
  double Bound = 2;

  bool Nested = false; ///< whether one pass is around another one
};

void PrintTo(const Chain& chain, std::ostream* os);

/// Each of VTK's passes, and each around another one; vtkSSAOPass only within others and around the steps: VTK leaves
/// its positions undefined where the passes in it draw to framebuffers of their own.
std::vector<Chain> Chains();

#endif
