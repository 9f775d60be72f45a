// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMultiLayerAlphaBlendingPass
 * @brief   multi-layer alpha blending: the nearest layers of a pixel, and all others merged into the last
 *
 * Salvi and Vaidyanathan, "Multi-layer alpha blending" (I3D 2014), in one drawing of the geometry. A pixel keeps Layers
 * layers, front to back; a fragment goes to its place among them, and if there is then one too many, the two farthest
 * are blended into one. Exact where no more than Layers surfaces lie behind each other; beyond, wrong where a fragment
 * comes later that belongs between two that were merged. What shows through is always right.
 *
 * Tail says what else can become of what does not find room: vtkKBufferPass leaves it out, vtkHybridTransparencyPass
 * averages it.
 *
 * Transmission colours are kept: a layer has a transmittance of red, green and blue each, and all of the above holds
 * for each of them.
 *
 * Stages:
 * 1. Gather: layers are inserted, and what is too much goes to the tail (12 bytes a layer and sample, 8 if ColorFormat
 * is RGBA8; 20 more if Tail is Average; with transmission colours 4 more a layer, and 36 more).
 * 2. Composite: the layers one behind the other, and the tail behind them.
 *
 * Where layers lie: in colours that a fragment fetches, changes and draws again, as in Bavoil's k-buffer, but in the
 * order of drawing and without races, where the driver has GL_EXT_shader_framebuffer_fetch, the window has one sample a
 * pixel, CriticalSection is Automatic, and 8 colours of 16 bytes have room for them: up to 10 layers, 16 as RGBA8,
 * fewer with a tail or transmission colours. Else in storage buffers under a critical section, with 4 bytes more a
 * sample. The picture is the same; the software rasterizer takes three times as long for buffers.
 */
#ifndef vtkMultiLayerAlphaBlendingPass_h
#define vtkMultiLayerAlphaBlendingPass_h

#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyPixels.h" // for Pixels

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkMultiLayerAlphaBlendingPass : public vtkTranslucencyPass
{
public:
  static vtkMultiLayerAlphaBlendingPass* New();
  vtkTypeMacro(vtkMultiLayerAlphaBlendingPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Layers of a pixel, 1 to 32; 4 by default. Another value is an error and changes nothing.
   */
  void SetLayers(int layers);
  vtkGetMacro(Layers, int);
  ///@}

  enum TailType
  {
    Merge = 0,
    Drop = 1,
    Average = 2
  };

  ///@{
  /**
   * What becomes of the farthest fragment where there are more than Layers: it is blended into the last layer (Merge,
   * the default), left out (Drop: what lies behind shows through too much), or added to the opacity-weighted mean of
   * all such (Average: what shows through stays right). Another value is an error and changes nothing.
   */
  void SetTail(int tail);
  vtkGetMacro(Tail, int);
  ///@}

  enum ColorFormatType
  {
    HalfFloat = 0,
    RGBA8 = 1
  };

  ///@{
  /**
   * How a layer's colour and what it lets through are kept: HalfFloat (the default, 8 bytes: keeps opacities below
   * 1/255 and colours above 1) or RGBA8 (4 bytes: each channel rounded to 1/255; where Tail is Merge, again with each
   * fragment that is merged). Another value is an error and changes nothing.
   */
  void SetColorFormat(int format);
  vtkGetMacro(ColorFormat, int);
  ///@}

  ///@{
  /**
   * The most graphics memory that the layers may take, in MiB; pictures for which that is not enough are drawn in
   * tiles. 0 (the default) means a quarter of what the driver reports, or 2048 where it reports nothing. A negative
   * value is an error and changes nothing.
   */
  void SetMemoryLimit(double mebibytes);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return true; }

protected:
  vtkMultiLayerAlphaBlendingPass() = default;
  explicit vtkMultiLayerAlphaBlendingPass(int tail);
  ~vtkMultiLayerAlphaBlendingPass() override;

  bool UsesStorage(const vtkTranslucencyCapabilities& capabilities) const override;
  std::string FindMissing(const vtkTranslucencyCapabilities& capabilities) const override;
  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  const int DefaultTail = Merge;
  int Tail = Merge;
  int Layers = 4;
  int ColorFormat = HalfFloat;
  double MemoryLimit = 0;

private:
  vtkTranslucencyPixels Pixels;

  vtkMultiLayerAlphaBlendingPass(const vtkMultiLayerAlphaBlendingPass&) = delete;
  void operator=(const vtkMultiLayerAlphaBlendingPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
