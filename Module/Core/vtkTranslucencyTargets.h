// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyTargets
 *
 * Floating-point colour buffers that a technique draws into with blending, and reads in a later stage; or integer ones,
 * of which fragments fetch what earlier ones have drawn (Shaders/Common/PixelTargets.glsl).
 *
 * They cover the framebuffer that the opaque geometry was drawn to, have as many samples, and share its depth buffer
 * while they are drawn to: nothing is copied, and fragments behind opaque geometry are rejected before they are shaded.
 * Where a technique writes depth, they have a depth buffer of their own, a copy of that one: the opaque depth is never
 * changed.
 *
 * OpenGL objects are made by Reserve and used within the frame; the owner calls Release.
 */
#ifndef vtkTranslucencyTargets_h
#define vtkTranslucencyTargets_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyTargets
{
public:
  /// 32-bit floats, 16-bit ones, or unsigned integers of 32 bits, a pixel and sample.
  enum class Format
  {
    Float1,
    Float2,
    Float4,
    Half1,
    Half2,
    Half4,
    Word1,
    Word2,
    Word4
  };

  /// The format of this many floats or words: 1, 2 or 4.
  static Format Floats(int count);
  static Format Halves(int count);
  static Format Words(int count);

  vtkTranslucencyTargets() = default;
  vtkTranslucencyTargets(const vtkTranslucencyTargets&) = delete;
  vtkTranslucencyTargets& operator=(const vtkTranslucencyTargets&) = delete;

  /// Makes buffers of these formats (at most 8). False if there is no memory for them.
  bool Reserve(int width, int height, int samples, const std::vector<Format>& formats);

  /// Makes them what is drawn to, with the depth buffer of the framebuffer that was, or with a copy of it, made within
  /// the scissor rectangle. Gives what is wrong, empty if nothing is.
  std::string Bind(vtkOpenGLRenderWindow* window, bool copyDepth = false);

  /// Sets the first ones to a value, within the scissor rectangle; words to its bits. They have to be bound.
  void Clear(const std::array<float, 4>& value, int count);

  /// The same for one of them.
  void Clear(int index, const std::array<float, 4>& value);

  /// What one of them holds within a rectangle (x, y, width, height), four floats a pixel, row by row from the bottom:
  /// the mean of a pixel's samples. They must not be bound. Empty if the driver can't.
  std::vector<float> Read(int index, const std::array<int, 4>& rectangle, vtkOpenGLRenderWindow* window) const;

  /// Makes the framebuffer that was bound before Bind what is drawn to.
  void Unbind();

  /// Fills a buffer of words, the only one, of one sample.
  void Write(const std::vector<unsigned int>& words);

  /// GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE, and the texture's name.
  unsigned int GetTarget() const;
  unsigned int GetTexture(int index) const { return this->Textures[index]; }
  int GetCount() const { return static_cast<int>(this->Textures.size()); }

  /// Bytes as allocated.
  vtkTypeInt64 GetBytes() const;

  /// Deletes everything; where the context is gone it is only forgotten.
  void Release(bool contextAlive = true);

private:
  void ReserveDepth(unsigned int format);

  vtkOpenGLRenderWindow* Window = nullptr; // while bound
  unsigned int Framebuffer = 0;
  unsigned int Depth = 0; // a renderbuffer
  unsigned int DepthFormat = 0;
  std::vector<unsigned int> Textures;
  std::vector<Format> Formats;
  int Width = 0;
  int Height = 0;
  int Samples = 0;
};
VTK_ABI_NAMESPACE_END

#endif
