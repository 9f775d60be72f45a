// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkABufferPass
 * @brief   exact translucency: every fragment is kept, ordered and blended
 *
 * The reference solution of Salvi et al. 2011, "Adaptive Transparency", after Carpenter 1984 and Yang et al. 2010.
 *
 * 1. Gather: all translucent fragments into the storage (one linked list a pixel).
 * 2. Resolve, one of
 *    - Recursive (Eq. 3): order a pixel's fragments by depth, then blend them, front to back. Up to 32 fragments are
 * sorted in registers by a sorting network; longer lists are cut into such runs, which are merged: n log n steps.
 *    - Iterative (Eq. 2): each fragment is weighted with the transmittance of all that lie in front of it, found by
 * walking the list and without sorting: n^2 steps. Slower for deep pixels; here as the paper's second reference.
 *
 * Fragments of equal depth are blended in the order in which they were drawn, the later in front of the earlier, where
 * the driver keeps that order; elsewhere in a fixed order of their contents. Either way each run gives the same
 * picture. Sums and products are held in 32-bit floats, whatever the framebuffer has.
 */
#ifndef vtkABufferPass_h
#define vtkABufferPass_h

#include "vtkFragmentListPass.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkABufferPass : public vtkFragmentListPass
{
public:
  static vtkABufferPass* New();
  vtkTypeMacro(vtkABufferPass, vtkFragmentListPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ResolveType
  {
    Recursive = 0,
    Iterative = 1
  };

  ///@{
  /**
   * How the fragments of a pixel become its colour: Recursive (the default) or Iterative. Another value is an error and
   * changes nothing.
   */
  void SetResolve(int resolve);
  vtkGetMacro(Resolve, int);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return true; }

protected:
  vtkABufferPass() = default;
  ~vtkABufferPass() override = default;

  bool ResolveLists(vtkTranslucencyFrame& frame) override;

  int Resolve = Recursive;

private:
  vtkABufferPass(const vtkABufferPass&) = delete;
  void operator=(const vtkABufferPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
