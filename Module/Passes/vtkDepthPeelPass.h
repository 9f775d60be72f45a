// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthPeelPass
 * @brief   depth peeling: the layers of the picture from drawings of the geometry, one or some after the other
 *
 * The picture is exact when all layers have been peeled, in memory that doesn't depend on how many there are; the time
 * is that of drawing the geometry as often as it takes. Layers are composited in 32-bit floats, so that thousands of
 * them add up right. Fragments of a pixel that have the very same depth are one layer, in which later drawn ones are
 * put over earlier ones: none is lost. The methods:
 * - FrontToBack: Everitt, "Interactive order-independent transparency" (NVIDIA 2001). The nearest layer is drawn first.
 * - Dual: Bavoil and Myers, "Order independent transparency with dual depth peeling" (NVIDIA 2008). Each drawing takes
 * off the nearest and the farthest layer.
 * - BucketSort: Liu, Huang, Liu and Wu, "Efficient depth peeling via bucket sort" (HPG 2009). Each drawing takes off up
 * to 32 of the nearest layers.
 *
 * The first two find the depths of the next layers in the drawing that takes off the last ones, by blending with
 * GL_MAX, as Bavoil and Myers do: L layers take L + 2 drawings from front to back, and L / 2 + 2 from both sides, of
 * which the last finds nothing left.
 *
 * Stages of these:
 * 1. Peel: of each pixel, colours of the fragments at the depths that the drawing before has found, and the depths of
 * the next (20 bytes a pixel and sample; Dual 40).
 * 2. Merge, over the screen: these layers are put behind those that have been peeled from the front, and in front of
 * those from the back (20 bytes a pixel and sample; Dual 40). Stages 1 and 2 are repeated until no fragment is left,
 * which an occlusion query tells, or as often as Layers says.
 * 3. Tail, if fragments are left and Tail is Average: one more drawing adds them up, into the memory of stage 1.
 * 4. Composite.
 *
 * BucketSort divides the depths of each pixel evenly into buckets, and all fragments find theirs at once, without being
 * compared to those of the others. The paper's buckets are the channels of eight 32-bit float buffers, with room for 32
 * depths but not for their colours in floats, and hold one depth each (or two): where more of a pixel's fragments fall
 * into one bucket, only what lies in front of them is right. Here they are records of pixels in a storage buffer,
 * changed under a critical section: 8 buckets of 4 layers each, with depth and colour (in half floats), so that the
 * drawing that finds a layer takes it off, too. What finds no room in its bucket, and all that is behind it, waits for
 * the next drawing. A drawing takes off no less than 4 layers, whatever the depths, if there are as many. The next one
 * divides what is left, from its nearest depth on, into buckets as long as the layers just peeled suggest
 * (Shaders/Peel/MergeBuckets.glsl), and whatever is farther goes to the last one: this does what the paper's second
 * method does by a histogram, without a drawing to find it.
 *
 * Where the driver has no storage buffers BucketSort draws to targets, as the paper does, in another way: six of a
 * pixel's layers are listed by their depths and taken off in a drawing, the three nearest and the three farthest, while
 * blending with GL_MAX finds the next ones in four buckets, of which each keeps its nearest and its farthest depth. A
 * bucket is not an interval of depths but takes depths by a hash: nothing has to be known of how they are spread, and
 * what one drawing has put into a bucket another one parts (Shaders/Peel/LayerLists.glsl, MergeLists.glsl). 32 layers
 * at random depths take 8 to 9 drawings, where Dual takes 18; a fragment draws 128 bytes, where with Dual it draws 40.
 * With Layers set it is the six nearest that are listed. It takes 256 bytes a pixel and sample, whatever MemoryLimit
 * says, and the mean of transmission colours.
 *
 * Stages of BucketSort:
 * 1. Gather: fragments go to the buckets, or if their pixel has given all Layers and Tail is Average, to its tail (420
 * bytes a pixel and sample, with transmission colours 556).
 * 2. Merge, over the screen: the layers that are right are put behind those that have been peeled, and the buckets are
 * made ready for what is left. Stages 1 and 2 are repeated until nothing is left, which an occlusion query tells.
 * 3. Composite.
 *
 * Transmission colours: BucketSort keeps three transmittances, the others take the mean: blending to several
 * buffers at once has no way to put coincident fragments over each other channel by channel.
 *
 * Documentation/Figures.md has drawings and times of the methods.
 */
#ifndef vtkDepthPeelPass_h
#define vtkDepthPeelPass_h

#include "vtkTranslucencyPass.h"

#include <memory> // for Peeling, Buckets, Lists

VTK_ABI_NAMESPACE_BEGIN
class vtkBucketPeeling;
class vtkImageData;
class vtkLayerPeeling;
class vtkListPeeling;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkDepthPeelPass : public vtkTranslucencyPass
{
public:
  static vtkDepthPeelPass* New();
  vtkTypeMacro(vtkDepthPeelPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    FrontToBack = 0,
    Dual = 1,
    BucketSort = 2
  };

  enum TailType
  {
    Drop = 0,
    Average = 1
  };

  ///@{
  /**
   * FrontToBack, Dual (the default: it needs half as many drawings), or BucketSort (far fewer, in far more memory).
   * Another value is an error and changes nothing.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * The most layers to peel, up to 65536; 0 (the default) peels until nothing is left. From front to back and with
   * BucketSort, these are the nearest; Dual takes one half from the front and one from the back, and one more where the
   * number is odd. Another value is an error and changes nothing.
   */
  void SetLayers(int layers);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * What is done with fragments that are left after so many layers, behind the nearest ones, and with Dual in front of
   * the farthest ones: Drop, or Average (the default): drawn in their place as one layer, of their mean colour,
   * weighted by opacity, that lets through exactly what they let through. Another value is an error and changes
   * nothing.
   */
  void SetTail(int tail);
  vtkGetMacro(Tail, int);
  ///@}

  ///@{
  /**
   * The most graphics memory that BucketSort's buckets may take, in MiB; pictures for which that is not enough are
   * drawn in tiles. 0 (the default) means a quarter of what the driver reports, or 2048 where it reports nothing. A
   * negative value is an error and changes nothing.
   */
  void SetMemoryLimit(double mebibytes);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /**
   * Whether the layers of each frame are kept as images, from front to back only. Off by default: it reads each back
   * from the GPU.
   */
  vtkSetMacro(KeepLayers, bool);
  vtkGetMacro(KeepLayers, bool);
  vtkBooleanMacro(KeepLayers, bool);
  ///@}

  /**
   * How many layers of the last frame were kept: 0 if KeepLayers is off or Method is not FrontToBack.
   */
  int GetNumberOfKeptLayers();

  /**
   * A layer that was kept, the nearest is 0: of each pixel of the renderer's viewport, colour and opacity of its
   * fragment of that number, in bytes (red, green, blue, alpha; colour not multiplied by opacity), all 0 where it has
   * none. Of a multi-sampled window, the mean of the pixel's samples. It is valid until the next frame. Another index
   * is an error and gives null.
   */
  vtkImageData* GetKeptLayer(int index);

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return this->Method == BucketSort && this->HasStorage; }

protected:
  vtkDepthPeelPass();
  ~vtkDepthPeelPass() override;

  bool UsesStorage(const vtkTranslucencyCapabilities& capabilities) const override;
  std::string FindMissing(const vtkTranslucencyCapabilities& capabilities) const override;
  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int Method = Dual;
  int Layers = 0;
  int Tail = Average;
  double MemoryLimit = 0;
  bool KeepLayers = false;

private:
  bool MemoryLimitWarned = false;
  std::unique_ptr<vtkLayerPeeling> Peeling;  // FrontToBack and Dual
  std::unique_ptr<vtkBucketPeeling> Buckets; // BucketSort
  std::unique_ptr<vtkListPeeling> Lists;     // BucketSort without storage buffers

  vtkDepthPeelPass(const vtkDepthPeelPass&) = delete;
  void operator=(const vtkDepthPeelPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
