// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyStatistics
 * @brief   what the last frame of a vtkTranslucencyPass drew and what it cost
 *
 * Counts hold for the last frame of one renderer. Times are taken if vtkTranslucencyPass::MeasureTimes is on.
 */
#ifndef vtkTranslucencyStatistics_h
#define vtkTranslucencyStatistics_h

#include "vtkObject.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <string> // for Fallback

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyStatistics : public vtkObject
{
public:
  static vtkTranslucencyStatistics* New();
  vtkTypeMacro(vtkTranslucencyStatistics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Translucent fragments that were stored, all tiles together.
  vtkGetMacro(Fragments, vtkTypeInt64);
  vtkSetMacro(Fragments, vtkTypeInt64);

  /// The most fragments that one pixel holds.
  vtkGetMacro(DeepestPixel, vtkTypeInt64);
  vtkSetMacro(DeepestPixel, vtkTypeInt64);

  /// Bytes of graphics memory that the pass and its storage have allocated.
  vtkGetMacro(Bytes, vtkTypeInt64);
  vtkSetMacro(Bytes, vtkTypeInt64);

  /// Parts into which the viewport was cut to stay within the memory limit; 1 if it fitted.
  vtkGetMacro(Tiles, int);
  vtkSetMacro(Tiles, int);

  /// How often the translucent props were drawn: once a tile, and again where the storage had to grow.
  vtkGetMacro(GeometryPasses, int);
  vtkSetMacro(GeometryPasses, int);

  /// Full-screen (or full-tile) passes.
  vtkGetMacro(ScreenPasses, int);
  vtkSetMacro(ScreenPasses, int);

  /// Shaders of mappers that were built anew; 0 from the second frame of a static scene on.
  vtkGetMacro(ShaderBuilds, int);
  vtkSetMacro(ShaderBuilds, int);

  /// Milliseconds in the gather and in the resolve stage; negative if they were not measured.
  vtkGetMacro(GatherTime, double);
  vtkSetMacro(GatherTime, double);
  vtkGetMacro(ResolveTime, double);
  vtkSetMacro(ResolveTime, double);

  /// Empty, or what was drawn instead of the technique: "peeling" or "blending".
  vtkGetMacro(Fallback, std::string);
  vtkSetMacro(Fallback, std::string);

  /// Everything back to what it is before the first frame.
  void Reset();

  /// Everything as in others.
  void Copy(vtkTranslucencyStatistics* others);

protected:
  vtkTranslucencyStatistics() = default;
  ~vtkTranslucencyStatistics() override = default;

  vtkTypeInt64 Fragments = 0;
  vtkTypeInt64 DeepestPixel = 0;
  vtkTypeInt64 Bytes = 0;
  int Tiles = 0;
  int GeometryPasses = 0;
  int ScreenPasses = 0;
  int ShaderBuilds = 0;
  double GatherTime = -1;
  double ResolveTime = -1;
  std::string Fallback;

private:
  vtkTranslucencyStatistics(const vtkTranslucencyStatistics&) = delete;
  void operator=(const vtkTranslucencyStatistics&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
