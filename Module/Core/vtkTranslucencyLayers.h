// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyLayers
 *
 * Fragments of what is drawn by shaders that can't be changed: one of each pixel and sample at a time, in the order of
 * drawing.
 *
 * The stencil buffer counts the fragments of each pixel (or sample); only the one whose number is asked for passes its
 * test. Its colour, as the shader gave it, and its depth stay in two textures. This is the stencil routing of Myers and
 * Bavoil, "Stencil routed A-buffer" (SIGGRAPH sketches 2007), without its samples in the place of layers, so that
 * multi-sampled windows keep theirs: everything is drawn once for each layer. It needs nothing of the shader, and ends
 * when the driver has counted all fragments.
 *
 * 24 bytes a pixel and sample.
 */
#ifndef vtkTranslucencyLayers_h
#define vtkTranslucencyLayers_h

#include "vtkTranslucencyABINamespace.h"
#include "vtkType.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkTranslucencyShaderWatch;

class vtkTranslucencyLayers
{
public:
  vtkTranslucencyLayers() = default;
  vtkTranslucencyLayers(const vtkTranslucencyLayers&) = delete;
  vtkTranslucencyLayers& operator=(const vtkTranslucencyLayers&) = delete;

  /// The stencil buffer counts no further: layers 0 to 254.
  static constexpr int Most = 255;

  /// False if there is no memory for it.
  bool Reserve(int width, int height, int samples);

  /// Keeps the layer of that number of what a function draws, within the scissor rectangle. False if there is none, and
  /// no further one; the layer Most has all that are beyond. Whatever the drawing asks of blending and masks is
  /// overruled.
  bool Draw(
    vtkOpenGLRenderWindow* window, vtkTranslucencyShaderWatch* watch, int layer, const std::function<void()>& draw);

  /// Textures of the last layer drawn, for texelFetch: colours, with an opacity of 0 where there is no fragment, and
  /// depths.
  unsigned int GetColors() const { return this->Colors; }
  unsigned int GetDepths() const { return this->Depths; }

  /// GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE.
  unsigned int GetTarget() const;

  vtkTypeInt64 GetBytes() const;

  /// Deletes everything; where the context is gone it is only forgotten.
  void Release(bool contextAlive);

private:
  unsigned int Framebuffer = 0;
  unsigned int Colors = 0;
  unsigned int Depths = 0;
  int Width = 0;
  int Height = 0;
  int Samples = 0;
};
VTK_ABI_NAMESPACE_END

#endif
