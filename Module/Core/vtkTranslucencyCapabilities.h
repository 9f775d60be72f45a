// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  vtkTranslucencyCapabilities
 *
 * What the driver behind a render window can do, probed once for each window. Extensions are tested, not versions:
 * a driver that reports OpenGL 3.3 may still offer storage buffers, and one that reports 4.3 may have them switched
 * off. What a driver has its compiler may still refuse in shaders of VTK's version of GLSL: one is compiled for trial
 * (Shaders/Common/Trial.glsl), and what is refused is missing.
 */
#ifndef vtkTranslucencyCapabilities_h
#define vtkTranslucencyCapabilities_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"
#include "vtkType.h"

#include <set>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

struct VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyCapabilities
{
  /// What every technique needs and the driver lacks, as extension names separated by ", "; empty if nothing. Some
  /// techniques need no more: those that draw to targets.
  std::string MissingForTargets;

  /// What fragment storage needs, in the same way.
  std::string MissingForStorage;

  /// What coverage masks need and the driver lacks, in the same way.
  std::string MissingForSamples;

  /// Whether several buffers can be drawn to at once, each with a blending of its own; if not, the geometry is drawn
  /// for each blending (vtkTranslucencyDrawings).
  bool BlendsBuffersApart = false;

  /// Whether a shader can run once for each sample of a pixel, as it does where it reads targets of several samples; if
  /// not, what it draws is drawn for each sample (vtkTranslucencyDrawings).
  bool ShadesSamples = false;

  /// What blending with a transmittance of red, green and blue each needs, in the same way.
  std::string MissingForTransmission;

  /// What records of pixels in colours need that fragments fetch, in the same way; and the most colours that a fragment
  /// can draw.
  std::string MissingForFetch;
  int MaximumTargets = 0;

  /// Textures that a fragment shader can read: GL_MAX_TEXTURE_IMAGE_UNITS. OpenGL 3.3 promises 16.
  int TextureUnits = 0;

  /// The extension by which a fragment shader can have a pixel to itself, in the order of drawing; empty if the driver
  /// has none.
  std::string Interlock;

  /// What shaders need that try an atomic operation again until it succeeds, in the same way: to know helper
  /// invocations, which get undefined results from atomic operations and might try for ever.
  std::string MissingForRetries;

  /// True where one of Mesa's software rasterizers draws, where a test that the hardware of a GPU does for nothing
  /// takes its time.
  bool Software = false;

  /// True if fragments of one pixel reach their shader's side effects in the order in which they were drawn: see
  /// IsRasterizer. With TRANSLUCENCY_DRAW_ORDER=any in the environment nobody does: what a GPU would draw, and the
  /// tests of that where there is none.
  bool KeepsDrawOrder = false;

  /// Whether GL_RENDERER is that of one of Mesa's software rasterizers itself, llvmpipe or softpipe. They bin
  /// primitives into tiles and shade each tile in order by one thread. GPUs do not promise that, nor does OpenGL on top
  /// of another interface (zink, virgl), although those have the name of what is below in theirs: it may be llvmpipe,
  /// but which of its promises are left is up to two drivers. There, as on a GPU, only an interlock orders fragments.
  static bool IsRasterizer(const std::string& renderer);

  /// The largest storage block that a shader may see, in bytes: GL_MAX_SHADER_STORAGE_BLOCK_SIZE. llvmpipe itself says
  /// 128 MiB there, but tests addresses against the buffer that is bound, of up to 2 GiB (tried with Mesa 22.3): a
  /// picture of 32 million fragments is drawn once instead of in five tiles.
  /// TestMemoryLimit.BlocksAreAsLargeAsTheDriverCanAddress fails where that isn't so.
  vtkTypeInt64 MaximumBlockBytes = 0;

  /// The most texels of a buffer that a shader may fetch: GL_MAX_TEXTURE_BUFFER_SIZE, 2^27 with most drivers.
  vtkTypeInt64 MaximumTexels = 0;

  /// Graphics memory as the driver reports it (NVX_gpu_memory_info, ATI_meminfo), in MiB; 0 if it does not.
  double ReportedMemoryMiB = 0;

  /// Bytes that may be taken where the user has given a limit in MiB, or 0: then a quarter of what the driver reports,
  /// or 2 GiB.
  double GetLimitBytes(double mebibytes) const;

  /// The driver's own words, GL_RENDERER.
  std::string Renderer;

  /// Probes the window's context, which must be current.
  static vtkTranslucencyCapabilities Probe(vtkOpenGLRenderWindow* window);

  /// Those that a driver of this version of OpenGL has, and nothing beyond it.
  static vtkTranslucencyCapabilities OfVersion(int major, int minor);

private:
  void FindMissing(const std::set<std::string>& extensions);
};
VTK_ABI_NAMESPACE_END

#endif
