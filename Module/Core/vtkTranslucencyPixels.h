// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyPixels
 *
 * A record of bounded size for each pixel, or for each sample of it, that a technique's shaders change fragment by
 * fragment.
 *
 * In buffers, under a critical section (Shaders/Common/Pixels.glsl): 4 * (words + 1) bytes a sample, and 4 a pixel
 * where the critical section is a spin lock. Or in colours that fragments fetch and draw again
 * (Shaders/Common/PixelTargets.glsl): 16 bytes for each four words, and 4, 8 or 16 for what is left of them.
 */
#ifndef vtkTranslucencyPixels_h
#define vtkTranslucencyPixels_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyBuffer.h"
#include "vtkTranslucencyTargets.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyPixels
{
public:
  /// What the records of a tile (x, y, width, height) take.
  struct Size
  {
    vtkTypeInt64 Counts = 0;
    vtkTypeInt64 Records = 0;
    vtkTypeInt64 Locks = 0;

    vtkTypeInt64 Sum() const { return this->Counts + this->Records + this->Locks; }
  };
  static Size GetSize(const std::array<int, 4>& tile, int samples, int words, bool locks);

  /// Makes room in buffers, with all counts 0, and all words if zeroed, and binds it. False if there is no memory for
  /// it.
  bool Begin(const Size& size, bool zeroed);

  /// A record in colours: its words, of which the first ones are EMPTY_NUMBER before stage 0. Later stages go on with
  /// what that has left. No words: it lies in buffers in any case.
  struct Fetched
  {
    int Words;
    int Empty;
  };

  /// How many colours have room for that many words, and what they take in a framebuffer.
  static int CountTargets(int words);
  static vtkTypeInt64 GetTargetBytes(int width, int height, int words);

  /// Makes room in colours. False if there is no memory for it.
  bool BeginTargets(int width, int height, int words);

  vtkTranslucencyTargets& GetTargets() { return this->Targets; }

  vtkTypeInt64 GetBytes() const;
  void Release(bool contextAlive = true);

private:
  vtkTranslucencyBuffer Counts;
  vtkTranslucencyBuffer Records;
  vtkTranslucencyBuffer Locks;
  vtkTranslucencyTargets Targets;
};
VTK_ABI_NAMESPACE_END

#endif
