// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyBackground
 *
 * The opaque picture as it is seen through surfaces that refract or diffuse (vtkTranslucencyMaterial).
 *
 * It is changed before a technique draws over it: so every technique shows these effects, and none knows of them. The
 * opaque picture is copied; the surfaces are drawn once, and add up by how much they displace and blur each pixel
 * (Shaders/Background/Gather.glsl); a full-screen pass then draws these pixels anew from the copy
 * (Shaders/Background/Change.glsl). What the technique draws multiplies that with what the surfaces let through.
 *
 * It takes the copy and 32 bytes a pixel and sample, and two drawings of those props' geometry, the technique's among
 * them, whose text takes turns in their shaders.
 */
#ifndef vtkTranslucencyBackground_h
#define vtkTranslucencyBackground_h

#include "vtkTranslucencyShader.h" // for Uniforms
#include "vtkTranslucencyTargets.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkTranslucencyFrame;
class vtkTranslucencyOpaqueDepth;

class vtkTranslucencyBackground
{
public:
  vtkTranslucencyBackground() = default;
  vtkTranslucencyBackground(const vtkTranslucencyBackground&) = delete;
  vtkTranslucencyBackground& operator=(const vtkTranslucencyBackground&) = delete;

  /// Of a picture that another pass may have changed already.
  void BeginFrame(bool changed) { this->Changed = changed; }
  bool IsChanged() const { return this->Changed; }

  /// Changes the picture, unless it is, where a frame's props ask for it: at its first tile, before anything is
  /// composited. False if a stage failed, which the frame has reported.
  bool Change(vtkTranslucencyFrame& frame, vtkTranslucencyOpaqueDepth& opaque);

  /// What Gather.glsl is given for a prop.
  static vtkTranslucencyShader::Uniforms GetUniforms(vtkProp* prop);

  vtkTypeInt64 GetBytes() const;

  /// Deletes everything; where the context is gone it is only forgotten.
  void Release(bool contextAlive);

private:
  void ReleasePicture(bool contextAlive);
  bool Copy(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport, bool levels);

  bool Changed = false;
  vtkTranslucencyTargets Bends;
  unsigned int Framebuffer = 0; // of the copy
  unsigned int Picture = 0;
  unsigned int Format = 0;
  std::array<int, 2> Size{ { 0, 0 } };
};
VTK_ABI_NAMESPACE_END

#endif
