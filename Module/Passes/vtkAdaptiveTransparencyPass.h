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
 * In fixed memory (section 4), 8 bytes a node and 20 more, a pixel and sample, however many fragments there are:
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
   * What a pixel's error may be, as its estimate tells (see above), 0 to 1. 0, the default, sets no limit: every pixel has NodeCount nodes. Else
   * pixels start with NodeCount nodes, and those with a larger estimate are drawn anew with twice as many, up to 64, and then exactly, by sorting
   * their fragments. The smaller NodeCount is, the fewer nodes most pixels take. Only where Memory is Variable: in fixed memory a pixel can't be
   * drawn anew. Together with that, or outside its range, a value is an error and changes nothing.
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
  bool ResolveLists(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int NodeCount = 16;
  int NodeRemoval = Underestimate;
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
