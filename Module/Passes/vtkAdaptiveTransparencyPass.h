// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveTransparencyPass
 * @brief   adaptive transparency: a visibility function of few nodes a pixel
 *
 * Salvi, Montgomery, Lefohn 2011, "Adaptive Transparency".
 *
 * In variable memory (section 4.1, the default):
 * 1. Gather: all translucent fragments into the storage (one linked list a pixel).
 * 2. Resolve, one full-screen pass that walks a pixel's list twice:
 *    - each fragment is inserted into the visibility function vis(z), a front-to-back list of at most NodeCount nodes,
 * each a depth and the transmittance behind it (sections 3.2, 3.3). When there are more fragments than nodes, the node
 * whose removal changes the area under vis(z) least is removed (Eq. 7), see NodeRemoval.
 *    - each fragment's colour is weighted with its opacity and vis at its depth, and summed (Eq. 2); the sum is
 * corrected (AlphaCorrection).
 *
 * AlphaCorrection, on by default, goes past the paper. A node's step that is removed moves to the node k in front, so
 * that the fragments between that and the next node are all seen through t[k], which they hide together. Their weights
 * fall short of what they hide: 200 quads of one colour and opacity .05 come out 228 of 255 with 8 nodes. So in a pixel
 * that has lost nodes
 * - a fragment without a node is seen through sqrt(t[k-1] * t[k]), which is right in the middle of several of one
 * opacity, but through no less than t[k] / (1 - opacity), since it does not hide itself, and no more than t[k-1].
 * Fragments with nodes see what they saw. With the other rules of NodeRemoval, whose steps move to the farther node,
 * too, all do,
 * - the sum is multiplied by (1 - total transmittance) / (sum of the weights), each channel by its own (the alpha
 * correction of Enderton, Sintorn, Shirley, Luebke 2010, "Stochastic Transparency"): the weights of exact visibilities
 * add up to that. And the area that a removal loses counts as wider by 1/256 of the distance from the first node to the
 * last: else nearly coincident fragments, between which there is no area, lose all their nodes but one, whatever they
 * hide.
 *
 * Visibility still never rises with depth, the total transmittance is exact, and a pixel with no more fragments than
 * nodes is what it was, bit for bit. Documentation/Adaptive.md has what else was tried, Documentation/Figures.md how
 * far pictures are from the exact one.
 *
 * With no more fragments than nodes the picture is that of vtkABufferPass. Fragments are inserted in the order of the
 * list: the last drawn first. The picture depends slightly on that order once nodes are removed; where a driver does
 * not keep the drawing order, two runs may differ by as much.
 *
 * Fragments of equal depth are put one behind the other in the order of the list. Nodes live in registers only:
 * NodeCount changes no memory.
 *
 * The error of a pixel is estimated by the areas that its removals have lost (Eq. 7, with their own widths), summed,
 * over the distance in window depth between its nearest and its farthest fragment: at least the mean error of
 * transmittance there, 0 to 1, and 0 with no more fragments than nodes. Show draws it, and Tolerance gives pixels more
 * nodes until it is small. It is an estimate of the function, whatever AlphaCorrection then makes of it, and ranks
 * pixels well: with 4 or 8 nodes, its rank correlation with the difference of the uncorrected picture from the exact
 * one is 0.87 to 0.94 on the frog and on 300 rectangles (with linear depths the same, without the distance no more);
 * with that of the corrected picture, which is about a tenth of it, 0.76 and 0.78 with 4 nodes, 0.46 and 0.65 with 8.
 * It is no bound of a colour: surfaces that lie close together have little area between them, and may differ in colour
 * by all there is. Between coincident ones there is none at all: without a Tolerance, the estimate does not see what
 * their merging costs.
 *
 * So a tolerance saves nodes, and registers with them; time it costs, for each step draws anew.
 *
 * In fixed memory (section 4), 6 bytes a node and 24 more (with transmission colours 16 and 52), a pixel and sample,
 * however many fragments there are:
 * 1. Visibility: the geometry is drawn, and each fragment inserted into the function of its pixel, under a critical
 * section.
 * 2. Shading: the geometry is drawn again, and each fragment's colour weighted with its opacity and vis at its depth;
 * blending (see below) sums it up, and multiplies the total transmittance (16 bytes a pixel and sample), and sums the
 * weights for AlphaCorrection (4 bytes; with transmission colours there is room for them).
 * 3. Composite.
 * Fragments are inserted as they are drawn, the first drawn first. A function is read and written for each fragment,
 * which takes longer than keeping them all, except where they would not fit into the memory there is. Volumes are drawn
 * over the surfaces.
 *
 * Where functions and sums lie: in colours that a fragment fetches, changes and draws again, under the conditions of
 * vtkMultiLayerAlphaBlendingPass, with up to 17 nodes and without transmission colours. Else functions lie in storage
 * buffers under a critical section, and sums are blended. The picture is the same; the software rasterizer takes twice
 * as long for that.
 */
#ifndef vtkAdaptiveTransparencyPass_h
#define vtkAdaptiveTransparencyPass_h

#include "vtkTranslucencyPixels.h"  // for Functions
#include "vtkTranslucencyTargets.h" // for Colors
#include "vtkVisibilityFunctionPass.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkAdaptiveTransparencyPass : public vtkVisibilityFunctionPass
{
public:
  static vtkAdaptiveTransparencyPass* New();
  vtkTypeMacro(vtkAdaptiveTransparencyPass, vtkVisibilityFunctionPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum NodeRemovalType
  {
    Underestimate = 0,
    Overestimate = 1,
    Mixed = 2
  };

  ///@{
  /**
   * Nodes of the visibility function, 1 to 64, 16 by default. A value outside is an error and changes nothing.
   */
  void SetNodeCount(int count);
  vtkGetMacro(NodeCount, int);
  ///@}

  ///@{
  /**
   * How a node leaves a full visibility function (section 3.2, Figure 4):
   * - Underestimate (the default): its step moves to the nearer neighbour, which keeps the total transmittance exact.
   * - Overestimate: its step moves to the farther neighbour.
   * - Mixed: whichever of the two loses less area, node by node; can look noisy (Figure 5).
   * Another value is an error and changes nothing.
   */
  void SetNodeRemoval(int removal);
  vtkGetMacro(NodeRemoval, int);
  ///@}

  ///@{
  /**
   * Whether fragments without nodes weigh by means, the weights of a pixel's fragments are scaled to add up to what
   * they hide, and areas count as a little wider (see above). On by default; off is the paper (Eq. 2 and 7).
   */
  void SetAlphaCorrection(bool correction);
  vtkGetMacro(AlphaCorrection, bool);
  vtkBooleanMacro(AlphaCorrection, bool);
  ///@}

  ///@{
  /**
   * What a pixel's error may be, as its estimate tells (see above), 0 to 1. 0, the default, sets no limit: every pixel
   * has NodeCount nodes. Else pixels start with NodeCount nodes, and those with a larger estimate are drawn anew with
   * twice as many, up to 64, and then exactly, by sorting their fragments. The smaller NodeCount is, the fewer nodes
   * most pixels take. Only where Memory is Variable: in fixed memory a pixel can't be drawn anew. Together with that,
   * or outside its range, a value is an error and changes nothing. Pixels in which fragments coincide and that have
   * more of them than nodes are drawn exactly.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  void SetMemory(int memory) override;
  ///@}

  enum ShowType
  {
    Picture = 0,
    Error = 1,
    Nodes = 2
  };

  ///@{
  /**
   * What is drawn where there are translucent fragments:
   * - Picture (the default).
   * - Error: the estimate of each pixel's error, in greys. Black is 0, white the Tolerance, or DefaultWhite where there
   * is none, and more.
   * - Nodes: how many nodes each pixel uses, in greys. Black is 0, white 64, or that the pixel is drawn exactly, by
   * sorting. Both hide the opaque picture, which would look like an error; where there are no translucent fragments it
   * stays, to tell where one is. Another value is an error and changes nothing.
   */
  void SetShow(int show);
  vtkGetMacro(Show, int);
  static constexpr double DefaultWhite = 0.1;
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return true; }

protected:
  vtkAdaptiveTransparencyPass() = default;
  ~vtkAdaptiveTransparencyPass() override;

  std::string FindMissing(const vtkTranslucencyCapabilities& capabilities) const override;
  bool RenderFixed(vtkTranslucencyFrame& frame) override;
  bool UsesInFixedMemory(const std::string& name) const override;
  bool ResolveLists(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int NodeCount = 16;
  int NodeRemoval = Underestimate;
  bool AlphaCorrection = true;
  double Tolerance = 0;
  int Show = Picture;

private:
  vtkTranslucencyFrame::Defines GetDefines(int nodes) const;
  vtkTranslucencyFrame::Defines GetCorrection() const;
  vtkTranslucencyFrame::Uniforms GetWhite() const;
  bool ResolveToTolerance(vtkTranslucencyFrame& frame, const vtkTranslucencyFrame::Squares& squares);
  bool ResolveExactly(vtkTranslucencyFrame& frame);

  vtkTranslucencyPixels Functions; // in fixed memory
  vtkTranslucencyTargets Colors;

  vtkAdaptiveTransparencyPass(const vtkAdaptiveTransparencyPass&) = delete;
  void operator=(const vtkAdaptiveTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
