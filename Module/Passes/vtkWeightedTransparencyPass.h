// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWeightedTransparencyPass
 * @brief   weighted sum, weighted average and weighted blended transparency
 *
 * Sums over the fragments of a pixel in which their order does not matter, in one drawing of the geometry: fast, of
 * bounded memory, the same on every driver, and only as right as the weights. The methods:
 * - Sum: Meshkin, "Sort-independent alpha blending" (GDC 2007). Dark where opacities add up to more than 1.
 * - Average: Bavoil and Myers, "Order independent transparency with dual depth peeling" (NVIDIA 2008). Exact for one
 * layer, and for any number of layers of equal colour and opacity.
 * - Blended (the default): McGuire and Bavoil, "Weighted blended order-independent transparency" (JCGT 2013), Eq. 6.
 * What shows through is exact; of colours, near ones count more.
 *
 * Transmission colours are kept: red, green and blue have opacities, and so weights, of their own. Where all fragments
 * hide next to nothing of a channel, their light adds up; Blended adds the sum of opacities times the weighted mean of
 * their colours, which is what its equation tends to.
 *
 * Stages:
 * 1. Gather: blending adds to a buffer of opacity-weighted colour and the sum of opacities or weights (16 bytes a pixel
 * and sample). Average counts fragments besides, and Blended multiplies for the product of 1 - opacity (4 bytes). With
 * transmission colours they take 32 bytes, and 48 if the method is Blended.
 * 2. Composite: the sums become a colour.
 */
#ifndef vtkWeightedTransparencyPass_h
#define vtkWeightedTransparencyPass_h

#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyTargets.h" // for Sums

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkWeightedTransparencyPass : public vtkTranslucencyPass
{
public:
  static vtkWeightedTransparencyPass* New();
  vtkTypeMacro(vtkWeightedTransparencyPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    Sum = 0,
    Average = 1,
    Blended = 2
  };

  enum WeightFunctionType
  {
    Equation7 = 0,
    Equation8 = 1,
    Equation9 = 2,
    Equation10 = 3
  };

  ///@{
  /**
   * Which sums: Sum, Average or Blended (the default). Another value is an error and changes nothing.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * How the weight falls with depth if Method is Blended: the equation of the 2013 paper. Equations 7, 8 and 9 take the
   * distance; 10 (the default) takes the depth in the window and falls evenly. Of the four it takes the least time, and
   * is near the best (Documentation/Figures.md).
   *
   * Another value is an error and changes nothing.
   */
  void SetWeightFunction(int function);
  vtkGetMacro(WeightFunction, int);
  ///@}

  ///@{
  /**
   * The distances to which the near and the far clipping plane are mapped for equations 7 to 9, which were made for 0.1
   * to 500 (the defaults): a smaller range weights near and far more alike. A value that is not positive is an error
   * and changes nothing.
   */
  void SetDepthNear(double distance);
  vtkGetMacro(DepthNear, double);
  void SetDepthFar(double distance);
  vtkGetMacro(DepthFar, double);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return true; }

protected:
  vtkWeightedTransparencyPass() = default;
  ~vtkWeightedTransparencyPass() override;

  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int Method = Blended;
  int WeightFunction = Equation10;
  double DepthNear = 0.1;
  double DepthFar = 500;

private:
  vtkTranslucencyTargets Sums;

  vtkWeightedTransparencyPass(const vtkWeightedTransparencyPass&) = delete;
  void operator=(const vtkWeightedTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
