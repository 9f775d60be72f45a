// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAbsorbancePass
 * @brief   transparency by sums over the absorbance of a pixel's fragments
 *
 * The base of techniques that describe vis(z), the transmittance between the viewer and depth z, by a fixed number of
 * sums to which every fragment adds, whatever the order: Salvi, Montgomery, Lefohn 2011, "Adaptive Transparency",
 * sections 2 and 4, where they are FOMT and OSMT. A subclass gives the shaders of the sums: vtkFourierOpacityPass,
 * vtkOpacityShadowMapPass, vtkWaveletTransparencyPass, vtkMomentTransparencyPass.
 *
 * What adds up is absorbance, -ln(1 - opacity), at most ln(1024) a fragment: an opaque one hides what is behind it to a
 * quarter of 1/255. A fragment's own absorbance is taken out of the sums when it asks for its visibility, so that a
 * pixel's only fragment is exact. The total transmittance is the product of 1 - opacity, exact in any case.
 *
 * Memory Fixed: blended targets of floats, each pixel and sample the same, however many fragments there are:
 * 0. if Bounds is Fragments, the nearest and the farthest depth of a pixel (8 bytes);
 * 1. the sums (4 bytes each, or 2 where Precision is Half), in targets or in a buffer (Precision);
 * 2. the geometry once more: the fragments' colours, weighted with opacity and vis(z), with the total transmittance (16
 * bytes), and the weights (4 bytes);
 * 3. composite.
 *
 * Memory Variable (the default): one drawing of the geometry into the storage, and one full-screen pass that walks a
 * pixel's list for the bounds, the sums, and the colours. The sums are in registers and take no memory. The storage and
 * its options are used by Variable only. On a driver that has no storage buffers Variable draws as Fixed, after a
 * warning.
 *
 * Both draw the same picture, but for the rounding of stored colours. Volumes are divided at surfaces by Variable only.
 * Lists too long for a driver's loops (some 20,000 fragments of a pixel) are sorted and drawn exactly.
 *
 * Transmission colours (SetTransmissionColor): Variable sums the absorbances of red, green and blue each, and corrects
 * each channel. Light of what hides nothing is never more than all fragments give together. So does Fixed with
 * SharedExponent. In targets Fixed takes their mean: three times the terms, with three transmittances, fit into the 8
 * targets of a drawing for few terms only.
 * Documentation/Figures.md has errors and times, also of transmission colours.
 */
#ifndef vtkAbsorbancePass_h
#define vtkAbsorbancePass_h

#include "vtkTranslucencyOption.h"  // for Technique
#include "vtkTranslucencyPixels.h"  // for Words
#include "vtkTranslucencyTargets.h" // for DepthBounds, Terms, Colors
#include "vtkVisibilityFunctionPass.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkAbsorbancePass : public vtkVisibilityFunctionPass
{
public:
  vtkTypeMacro(vtkAbsorbancePass, vtkVisibilityFunctionPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundsType
  {
    Fragments = 0,
    Props = 1
  };

  ///@{
  /**
   * The range of depths over which the sums are spread, the smaller the better they tell fragments apart:
   * - Fragments (the default): that of the pixel's fragments, as in the paper. With Fixed it takes one more drawing of
   * the geometry.
   * - Props: that of the boxes around all translucent props, the same for the whole picture. Fragments outside, such as
   *   those of points drawn as spheres, count as being at its ends.
   * Another value is an error and changes nothing.
   */
  void SetBounds(int bounds);
  vtkGetMacro(Bounds, int);
  ///@}

  enum PrecisionType
  {
    Single = 0,
    Half = 1,
    SharedExponent = 2
  };

  ///@{
  /**
   * What Memory Fixed holds the sums in:
   * - Single (the default): blended targets of 32-bit floats.
   * - Half: the same of 16-bit floats, which take half the room and are rounded at each fragment.
   * - SharedExponent, of techniques whose sums are never negative (wavelets and slices): words in a buffer, to which
   *   fragments add by atomic operations. Where props have transmission colours, a word holds the sums of red, green
   * and blue, in 9 bits each with an exponent of 5 that they share, which is rounded at each fragment; else a float.
   * The drawing for the sums draws no colours, and touches only those that a fragment adds to. Where the driver has no
   *   storage buffers, or does not tell helper invocations, Single is taken, after a warning.
   * Variable, which has the sums in registers, warns of all but Single. Another value is an error and changes nothing.
   */
  void SetPrecision(int precision);
  vtkGetMacro(Precision, int);
  ///@}

  enum DepthWarpType
  {
    Linear = 0,
    Logarithmic = 1
  };

  ///@{
  /**
   * How depths are spread over the range, which says where fragments are told apart best:
   * - Linear (the default): evenly, by the distance from the viewer's plane.
   * - Logarithmic: evenly by the distance's logarithm, so that what is near is told apart better than what is far
   *   (Muenstermann, Krumpen, Klein, Peters 2018, section 3.1). In parallel projections it is Linear.
   * Another value is an error and changes nothing.
   */
  void SetDepthWarp(int warp);
  vtkGetMacro(DepthWarp, int);
  ///@}

  ///@{
  /**
   * Whether a pixel's colour is scaled so that the weights of its fragments add up to 1 - total transmittance, as those
   * of exact visibilities do (the alpha correction of Enderton, Sintorn, Shirley, Luebke 2010, "Stochastic
   * Transparency"). On by default: without, approximate visibilities make a picture too dark or too bright, not only
   * mix its colours wrongly. Off is the paper's sum (Eq. 2).
   */
  void SetAlphaCorrection(bool correction);
  vtkGetMacro(AlphaCorrection, bool);
  vtkBooleanMacro(AlphaCorrection, bool);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return this->KeepsFragments() || this->HasWords; }
  bool KeepsFragments() const override { return this->Superclass::KeepsFragments() && this->HasStorage; }

protected:
  /**
   * A technique: the option that says which sums it has, by a number, and its shaders.
   */
  struct Sums
  {
    vtkTranslucencyOption Number; ///< without Get and Set
    std::string Folder;           ///< of the shaders: Gather.glsl, Resolve.glsl, ResolveShort.glsl
    std::string Define;           ///< by which they know the number
    bool Negative = true;         ///< whether sums may be
  };
  explicit vtkAbsorbancePass(const Sums& sums);
  ~vtkAbsorbancePass() override;

  /**
   * The property that is the option.
   */
  void SetSums(int number);

  /**
   * The number of sums, 1 to 32, or 64.
   */
  virtual int GetTermCount() const { return this->Number; }

  bool UsesInFixedMemory(const std::string& name) const override;
  bool UsesStorage(const vtkTranslucencyCapabilities& capabilities) const override;
  std::string FindMissing(const vtkTranslucencyCapabilities& capabilities) const override;
  void RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass) override;
  bool RenderFixed(vtkTranslucencyFrame& frame) override;
  bool ResolveLists(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int Number;
  int Bounds = Fragments;
  int Precision = Single;
  int DepthWarp = Linear;
  bool AlphaCorrection = true;

  /**
   * Uniforms of the shaders; a subclass adds its own.
   */
  virtual vtkTranslucencyFrame::Uniforms GetValues(const vtkTranslucencyFrame& frame) const;

private:
  const Sums Technique;

  vtkTranslucencyFrame::Defines GetDefines(int precision) const;
  std::string FindMissingForWords(const vtkTranslucencyCapabilities& capabilities) const;
  std::string FindConflict(const vtkTranslucencyCapabilities& capabilities) const;
  bool DrawTerms(
    vtkTranslucencyFrame& frame, const vtkTranslucencyFrame::Gathering& gathering, vtkTranslucencyFrame::Stage& stage);
  std::vector<int> GetTermFormats() const;
  int GetTermVectors() const;
  vtkTranslucencyFrame::Defines GetCorrection() const;

  vtkTranslucencyTargets DepthBounds;
  std::array<vtkTranslucencyTargets, 2> Terms; // of a drawing each
  vtkTranslucencyPixels Words;
  bool HasWords = false; // whether the sums of what is being drawn lie there
  vtkTranslucencyTargets Colors;
  std::string Warning; // the last one, of how Memory and what else was asked for don't go together

  vtkAbsorbancePass(const vtkAbsorbancePass&) = delete;
  void operator=(const vtkAbsorbancePass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
