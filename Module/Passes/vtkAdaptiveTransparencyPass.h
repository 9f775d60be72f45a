/**
 * @class   vtkAdaptiveTransparencyPass
 * @brief   adaptive transparency: a visibility function of few nodes a pixel
 *
 * Salvi, Montgomery, Lefohn 2011, "Adaptive Transparency".
 *
 * In variable memory (section 4.1, the default):
 * 1. Gather: all translucent fragments into the storage (one linked list a pixel).
 * 2. Resolve, one full-screen pass that walks a pixel's list twice:
 *    - each fragment is inserted into the visibility function vis(z), a front-to-back list of at most NodeCount nodes, each
 *      a depth and the transmittance behind it (sections 3.2, 3.3). When there are more fragments than nodes, the node whose
 *      removal changes the area under vis(z) least is removed (Eq. 7), see NodeRemoval.
 *    - each fragment's colour is weighted with its opacity and vis at its depth, and summed (Eq. 2).
 *
 * With no more fragments than nodes the picture is that of vtkABufferPass. Fragments are inserted in the order of the list:
 * the last drawn first. The picture depends slightly on that order once nodes are removed; where a driver does not keep the
 * drawing order, two runs may differ by as much. Measured between two random orders of the actors, root mean square of all
 * channels where 1 is the full range, beside the distance from the exact picture:
 *
 * | nodes | 300 rectangles, to 29 deep | 40 spheres, to 50 deep     |
 * | ----- | -------------------------- | -------------------------- |
 * | 8     | 0.0029 (from exact 0.0147) | 0.0017 (from exact 0.0062) |
 * | 16    | 0.0003 (from exact 0.0012) | 0.0002 (from exact 0.0007) |
 * | 32    | 0                          | 0                          |
 *
 * Fragments of equal depth are put one behind the other in the order of the list. Nodes live in registers only: NodeCount changes
 * no memory.
 *
 * The error of a pixel is estimated by the areas that its removals have lost (Eq. 7), summed, over the distance in window depth between its nearest
 * and its farthest fragment: at least the mean error of transmittance there, 0 to 1, and 0 with no more fragments than nodes. Show draws it, and
 * Tolerance gives pixels more nodes until it is small. It ranks pixels well: with 4 or 8 nodes, its rank correlation with the difference from the
 * exact picture is 0.87 to 0.94 on the frog and on 300 rectangles (with linear depths the same, without the distance no more). It is no bound of
 * a colour: surfaces that lie close together have little area between them, and may differ in colour by all there is. Between coincident
 * ones there is none at all: without a Tolerance, the estimate does not see what their merging costs.
 *
 * From 4 nodes on, at 400x300 (frog 640x360; the differences of 300 rectangles 800x600): mean nodes of a pixel, root mean square and largest of all
 * channels' differences from exact in percent of the full range, time where plain blending is 1 (software rasterizer with two busy cores; exact:
 * 1.2 and 4.1):
 *
 * |               | frog's tissues, to 24 deep | 1200 rectangles, to 73 deep | 300 rectangles, to 24 |
 * | Tolerance     | nodes, RMS, largest, time  | nodes, RMS, largest, time   | nodes, RMS, largest   |
 * | ------------- | -------------------------- | --------------------------- | --------------------- |
 * | 0             | to 4, 1.95, 36, 1.2        | to 4, 14.9, 41, 3.2         | to 4, 4.90, 24        |
 * | 0.03          | 3.7, 1.49, 36, 1.1         | 9.7, 4.70, 22, 5.4          | 5.4, 2.33, 20         |
 * | 0.01          | 4.2, 1.01, 31, 1.2         | 13.7, 1.80, 9, 6.4          | 6.5, 1.25, 10         |
 * | 0.001         | 5.0, 0.67, 25, 1.3         | 24.5, 0.36, 5, 8.5          | 8.1, 0.28, 5          |
 * | 0.0001        | 5.2, 0.56, 25, 1.2         | 28.0, 0.19, 4, 10.4         | 8.3, 0.14, 5          |
 * | 0, 64 nodes   | all, 0, 0, 1.3             | all, 0.00, 0.4, 5.2         | all, 0, 0             |
 *
 * So a tolerance saves nodes, and registers with them; time it costs, for each step draws anew. From the default's 16 nodes on, 0.001 costs none
 * on the frog, and 1.6 times as long as without on the 1200 rectangles (0.34 and 5 percent from exact instead of 1.65 and 9).
 *
 * In fixed memory (section 4), 6 bytes a node and 20 more (with transmission colours 16 and 52), a pixel and sample, however many fragments there are:
 * 1. Visibility: the geometry is drawn, and each fragment inserted into the function of its pixel, under a critical section.
 * 2. Shading: the geometry is drawn again, and each fragment's colour weighted with its opacity and vis at its depth; blending sums it
 *    up, and multiplies the total transmittance (16 bytes a pixel and sample).
 * 3. Composite.
 * Fragments are inserted as they are drawn, the first drawn first. A function is read and written for each fragment, which takes longer than
 * keeping them all, except where they would not fit into the memory there is. Volumes are drawn over the surfaces.
 */
#ifndef vtkAdaptiveTransparencyPass_h
#define vtkAdaptiveTransparencyPass_h

#include "vtkTranslucencyPixels.h"  // for Functions
#include "vtkTranslucencyTargets.h" // for Colors
#include "vtkVisibilityFunctionPass.h"

#include <string>

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
   * Whether the colour of a pixel that has lost nodes is scaled so that the weights of its fragments add up to 1 - total transmittance, as those of
   * exact visibilities do (see above). On by default; off is the paper's sum (Eq. 2).
   */
  void SetAlphaCorrection(bool correction);
  vtkGetMacro(AlphaCorrection, bool);
  vtkBooleanMacro(AlphaCorrection, bool);
  ///@}

  ///@{
  /**
   * What a pixel's error may be, as its estimate tells (see above), 0 to 1. 0, the default, sets no limit: every pixel has NodeCount nodes. Else
   * pixels start with NodeCount nodes, and those with a larger estimate are drawn anew with twice as many, up to 64, and then exactly, by sorting
   * their fragments. The smaller NodeCount is, the fewer nodes most pixels take. Only where Memory is Variable: in fixed memory a pixel can't be
   * drawn anew. Together with that, or outside its range, a value is an error and changes nothing. Pixels in which fragments coincide and that have
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
   * - Error: the estimate of each pixel's error, in greys. Black is 0, white the Tolerance, or DefaultWhite where there is none, and more.
   * - Nodes: how many nodes each pixel uses, in greys. Black is 0, white 64, or that the pixel is drawn exactly, by sorting.
   * Both hide the opaque picture, which would look like an error; where there are no translucent fragments it stays, to tell where one is. Another
   * value is an error and changes nothing.
   */
  void SetShow(int show);
  vtkGetMacro(Show, int);
  static constexpr double DefaultWhite = 0.1;
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  std::string GetMissing(vtkOpenGLRenderWindow* window) override;
  bool KeepsTransmissionColors() const override { return true; }

protected:
  vtkAdaptiveTransparencyPass() = default;
  ~vtkAdaptiveTransparencyPass() override;

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
  vtkTranslucencyFrame::Uniforms GetWhite() const;
  bool ResolveToTolerance(vtkTranslucencyFrame& frame, const vtkTranslucencyFrame::Squares& squares);
  bool ResolveExactly(vtkTranslucencyFrame& frame);

  vtkTranslucencyPixels Functions; // in fixed memory
  vtkTranslucencyTargets Colors;

  vtkAdaptiveTransparencyPass(const vtkAdaptiveTransparencyPass&) = delete;
  void operator=(const vtkAdaptiveTransparencyPass&) = delete;
};

#endif
