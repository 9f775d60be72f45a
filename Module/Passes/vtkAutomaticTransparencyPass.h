// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAutomaticTransparencyPass
 * @brief   draws by the best of the module's techniques that stays within a budget of time and of graphics memory
 *
 * Before each frame it chooses one of the techniques below, by what the last frames cost, and has that one draw it: the
 * picture is that one's, bit for bit, and GetStatistics() gives its numbers. Only the chosen technique's pass exists;
 * that of the one before is released with all its memory. GetChosen() and GetReason() tell the choice. The rules, and
 * why choices come to rest on a still scene, are in vtkTechniqueChooser.h.
 *
 * The candidates, the best first, with memory in bytes, per sample where a window has several:
 * - exact, adaptive:nodes=16: 16 per fragment, 4 per pixel, and 8 per sample in multi-sampled windows
 * - hybrid:layers=16: 216 per pixel
 * - adaptive:nodes=8: as exact
 * - hybrid:layers=8: 120 per pixel
 * - wavelet:memory=fixed:precision=half: 60 per pixel
 * - hybrid:layers=4: 72 per pixel
 * - weighted: 20 per pixel
 * Where the driver has no storage buffers:
 * - peel:method=bucket-sort: 256 per pixel
 * - wavelet:memory=fixed:rank=4: 156 per pixel
 * - wavelet:memory=fixed:precision=half: 60 per pixel
 * - weighted: 20 per pixel
 * Where a prop has a transmission colour, wavelet is left out, which would take the mean; where a body absorbs
 * (vtkTranslucencyMaterial), exact and adaptive are left. On a driver without storage buffers the choice is the same
 * with and without.
 *
 * The order of quality is that of the mean distance from the exact picture of three scenes (Documentation/Figures.md).
 * The time that is expected of a candidate, relative to exact, is that of a software rasterizer only until it has drawn
 * a few frames: on other drivers, one that turns out slower than expected is drawn for that long, and then left.
 *
 * Memory is kept in every frame: the chosen technique gets the budget as its limit (but for weighted, which has none),
 * and a frame that would pass it is drawn in tiles. That happens where more is drawn than was expected, in the first
 * frame of all, too: the next one goes by what was counted. If even weighted does not fit, it draws nevertheless. Time
 * is measured only if there is a budget for it, which waits for the GPU after each stage; either budget has fragments
 * counted, which waits for it once a frame.
 *
 * Volumes are divided at surfaces by exact and by adaptive in variable memory only, and drawn over them by the others.
 * CriticalSection holds for the chosen technique. Options of the techniques other than those in the table are at their
 * defaults.
 */
#ifndef vtkAutomaticTransparencyPass_h
#define vtkAutomaticTransparencyPass_h

#include "vtkSmartPointer.h" // for Delegate
#include "vtkTranslucencyPass.h"

#include <memory> // for Chooser
#include <string> // for GetChosen
#include <vector> // for LastView

VTK_ABI_NAMESPACE_BEGIN
class vtkFragmentCountingPass;
class vtkTechniqueChooser;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkAutomaticTransparencyPass : public vtkTranslucencyPass
{
public:
  static vtkAutomaticTransparencyPass* New();
  vtkTypeMacro(vtkAutomaticTransparencyPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What the translucent stages of a frame may take, in milliseconds; 0 (the default) for any time. Opaque geometry is
   * not counted. A negative value is an error and changes nothing.
   */
  void SetBudgetMilliseconds(double milliseconds);
  vtkGetMacro(BudgetMilliseconds, double);
  ///@}

  ///@{
  /**
   * The graphics memory that the pass may take, in MiB; 0 (the default) for any, up to the limits that the techniques
   * have by default. A negative value is an error and changes nothing.
   */
  void SetBudgetMebibytes(double mebibytes);
  vtkGetMacro(BudgetMebibytes, double);
  ///@}

  ///@{
  /**
   * An error that is as good as none, as a root mean square of all channels where 1 is the full range, 0 to 1; 0 by
   * default. Of the candidates expected to stay below it, the fastest comes first, then the slower ones, then the
   * others by quality. What is expected is the mean of the table above, not a bound: scenes that are deeper, or of
   * higher contrast, come out worse. Budgets come before it. A value outside is an error and changes nothing.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * The technique that drew the last frame, with its options, as the command writes it: "adaptive:nodes=8". Empty
   * before the first.
   */
  std::string GetChosen();

  /**
   * Why it was chosen, in one sentence with the numbers and the budgets. Empty before the first frame.
   */
  std::string GetReason();

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return !this->Delegate || this->Delegate->KeepsTransmissionColors(); }
  bool KeepsFragments() const override { return !this->Delegate || this->Delegate->KeepsFragments(); }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkAutomaticTransparencyPass();
  ~vtkAutomaticTransparencyPass() override;

  void RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass) override;
  bool RenderStages(vtkTranslucencyFrame&) override { return true; } // the chosen pass has frames of its own
  void ReleaseTechniqueResources(bool contextAlive) override;

  double BudgetMilliseconds = 0;
  double BudgetMebibytes = 0;
  double Tolerance = 0;

private:
  void SetNumber(const char* name, double& member, double value);
  vtkSmartPointer<vtkTranslucencyPass> NewDelegate(const std::string& technique);
  void FindCandidates(const vtkRenderState* state, vtkOpenGLRenderWindow* window);
  void Choose(const vtkRenderState* state);
  void Observe();

  std::unique_ptr<vtkTechniqueChooser> Chooser;
  vtkSmartPointer<vtkFragmentCountingPass> Counting;
  vtkSmartPointer<vtkTranslucencyPass> Delegate; // the chosen one
  std::string Chosen;
  std::string Reason;
  std::string Device;                  // that candidates were found for
  std::vector<vtkTypeUInt64> LastView; // its fingerprint
  double ListedPerCounted = 1;         // fragments in lists, to those of the query

  vtkAutomaticTransparencyPass(const vtkAutomaticTransparencyPass&) = delete;
  void operator=(const vtkAutomaticTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
