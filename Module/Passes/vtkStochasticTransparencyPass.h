// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStochasticTransparencyPass
 * @brief   stochastic transparency: visibility from random depth samples, right on average, with noise
 *
 * Enderton et al., "Stochastic transparency" (I3D 2010), in its depth-based variant with alpha correction, as Salvi et
 * al. implement it (2011, section 4). A fragment covers a random part, as large as its opacity, of the depth samples of
 * its pixel; the share of samples in which nothing nearer lies is the visibility that it is weighted with. Needs no
 * order, memory is bounded, any number of fragments is right on average. What shows through is exact, and so is the
 * colour where one fragment, or fragments of one colour, lie in a pixel; elsewhere there is noise, which falls with the
 * square root of DepthSamples and of the frames that Accumulate averages.
 *
 * Stages:
 * 1. Depths: each fragment chooses its samples and writes its depth to them (4 bytes a sample, for each pixel and
 * sample of the window).
 * 2. Colours: each fragment is weighted with its visibility; blending sums colours, multiplies what shows through (16
 * bytes), and, for the alpha correction, sums weights (4 bytes).
 * 3. Composite: the sums become a colour.
 * Each of the first two draws the geometry once; with more than 32 samples both run twice, each time with half of them.
 *
 * The samples lie in the channels of floating-point buffers, four in each, which blending keeps at their minimum. The
 * papers take the samples of a multi-sampled depth buffer. This way
 * - there can be any number, whatever the hardware offers, and 32 are filled in one drawing: a multi-sampled depth
 * buffer of 4 or 8 samples needs one for each 4 or 8;
 * - visibility is kept for whole pixels, as by Salvi et al., and in a multi-sampled window for each of its samples,
 * whose edges stay smooth;
 * - software rasterizers are spared several samples a pixel, which cost 2.7 times a drawing with one.
 *
 * Transmission colours (SetTransmissionColor) are taken by their mean, and so Accumulate comes nearer to the exact
 * picture of the means. Depth samples of each channel (McGuire and Enderton 2011, "Colored stochastic shadow maps")
 * would be three times as many: more drawings of the geometry from 12 on, and three transmittances that are multiplied
 * in a buffer of their own. Of 300 rectangles with colours from 0 to 0.9 the picture is off by 4.85 % (root mean square
 * of all channels in percent of the full range), without colours by 1.6 %; the time is the same.
 *
 * Randomness is a hash of the pixel, the seed, and the fragment's depth and colour: the same picture every time, in any
 * order of drawing. The price: fragments of the same depth and colour in one pixel, as of two identical surfaces, cover
 * the same samples, and hide what lies behind them like one (but what shows through all is exact).
 */
#ifndef vtkStochasticTransparencyPass_h
#define vtkStochasticTransparencyPass_h

#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyTargets.h" // for Depths and Sums

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkStochasticTransparencyPass : public vtkTranslucencyPass
{
public:
  static vtkStochasticTransparencyPass* New();
  vtkTypeMacro(vtkStochasticTransparencyPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Depth samples of a pixel: a multiple of 4 up to 32, or of 8 up to 64; 8 by default. Another value is an error and
   * changes nothing.
   */
  void SetDepthSamples(int samples);
  vtkGetMacro(DepthSamples, int);
  ///@}

  ///@{
  /**
   * Which random numbers are taken, 0 (the default) or more. A negative value is an error and changes nothing.
   */
  void SetSeed(int seed);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Whether a pixel's colours are scaled to the opacity that they have together, which is known exactly (the alpha
   * correction of the 2010 paper). On by default: much less noise, for a bias that disappears with more samples or
   * frames. Off, each frame is right on average.
   */
  void SetAlphaCorrection(bool correction);
  vtkGetMacro(AlphaCorrection, bool);
  vtkBooleanMacro(AlphaCorrection, bool);
  ///@}

  ///@{
  /**
   * The frames over which a still view is refined, 1 (the default: each frame stands for itself) to 65536. Frame i
   * after a change takes the random numbers of Seed + i, and shows the mean of the frames so far; when all are there
   * the geometry is no longer drawn. Whatever the picture depends on starts it anew: camera, lights, window, props,
   * their data, properties and transforms, options of this pass. Another value is an error and changes nothing.
   */
  void SetAccumulate(int frames);
  vtkGetMacro(Accumulate, int);
  ///@}

  /**
   * How many frames the picture that was drawn last is the mean of.
   */
  vtkGetMacro(AccumulatedFrames, int);

  std::vector<vtkTranslucencyOption> GetOptions() override;

protected:
  vtkStochasticTransparencyPass() = default;
  ~vtkStochasticTransparencyPass() override;

  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int DepthSamples = 8;
  int Seed = 0;
  bool AlphaCorrection = true;
  int Accumulate = 1;

private:
  bool StartFrame(vtkTranslucencyFrame& frame);
  bool DrawRound(vtkTranslucencyFrame& frame, int round);

  // A drawing has at most 8 buffers of 4 samples: more are drawn in rounds.
  int GetRounds() const;
  int GetSamplesOfRound() const { return this->DepthSamples / this->GetRounds(); }

  vtkTranslucencyTargets Depths;
  vtkTranslucencyTargets Sums;
  std::vector<unsigned int> Patterns; // the table of Shaders/Stochastic/Mask.glsl
  vtkTranslucencyTargets PatternTable;
  int AccumulatedFrames = 0;
  std::vector<vtkTypeUInt64> Accumulated; // what the frames in Sums are of

  vtkStochasticTransparencyPass(const vtkStochasticTransparencyPass&) = delete;
  void operator=(const vtkStochasticTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
