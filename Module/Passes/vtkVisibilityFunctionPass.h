// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVisibilityFunctionPass
 * @brief   a technique that weights each fragment by its pixel's visibility function
 *
 * What the techniques share that describe vis(z), the transmittance between the viewer and depth z, in bounded room and
 * sum the fragments by it (Salvi, Montgomery, Lefohn 2011, "Adaptive Transparency", Eq. 2). There are two ways to know
 * the function before the first fragment is weighted: to keep the fragments, or to draw them again.
 */
#ifndef vtkVisibilityFunctionPass_h
#define vtkVisibilityFunctionPass_h

#include "vtkFragmentListPass.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkVisibilityFunctionPass : public vtkFragmentListPass
{
public:
  vtkTypeMacro(vtkVisibilityFunctionPass, vtkFragmentListPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MemoryType
  {
    Variable = 0,
    Fixed = 1
  };

  ///@{
  /**
   * Variable (the default): all fragments are kept, in the storage, and resolved in the end. Fixed: nothing is kept of
   * a fragment but what it does to the functions and the colours, and the geometry is drawn twice or more often:
   * options of the storage then do nothing (UsesInFixedMemory names exceptions), and drawing warns of those that are
   * not at their defaults. What the other one holds is released. Another value is an error and changes nothing.
   */
  virtual void SetMemory(int memory);
  vtkGetMacro(Memory, int);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsFragments() const override { return this->Memory == Variable; }

  /**
   * Whether an option of the fragment lists, by its name of a property, is used where Memory is Fixed.
   */
  virtual bool UsesInFixedMemory(const std::string& name) const;

protected:
  vtkVisibilityFunctionPass() = default;
  ~vtkVisibilityFunctionPass() override = default;

  /**
   * The option memory.
   */
  vtkTranslucencyOption GetMemoryOption();

  /**
   * RenderStages where Memory is Fixed; where it is Variable, lists are gathered and ResolveLists draws them.
   */
  virtual bool RenderFixed(vtkTranslucencyFrame& frame) = 0;

  bool RenderStages(vtkTranslucencyFrame& frame) override;

  int Memory = Variable;

private:
  vtkVisibilityFunctionPass(const vtkVisibilityFunctionPass&) = delete;
  void operator=(const vtkVisibilityFunctionPass&) = delete;

  void WarnOfUnusedOptions();

  std::string UnusedOptions; // those that were warned of
};
VTK_ABI_NAMESPACE_END

#endif
