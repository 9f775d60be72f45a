// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyOpaqueDepth
 *
 * A copy of the depth buffer with the opaque geometry, for shaders that give their fragments a depth of their own: the
 * depth test comes too late for what they store. Made once a frame, when the first shader asks for it.
 */
#ifndef vtkTranslucencyOpaqueDepth_h
#define vtkTranslucencyOpaqueDepth_h

#include "vtkSmartPointer.h"
#include "vtkTranslucencyABINamespace.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

class vtkTranslucencyOpaqueDepth
{
public:
  /// Nothing is captured yet.
  void BeginFrame(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport);

  bool IsCaptured() const { return this->Captured; }

  /// Copies the depth of the viewport and activates it. False if that fails.
  bool Capture();

  /// Activates the copy, and captures it if it is not yet. False if that fails.
  bool Use();

  /// Binds the copy to a texture unit of its own, and puts back what was bound there.
  void Activate();
  void Deactivate();
  int GetUnit() const { return this->Unit; }

  /// VTK's objects follow their window by themselves.
  void Release();

private:
  void Reserve(int width, int height, unsigned int framebuffer);

  vtkOpenGLRenderWindow* Window = nullptr; // of the frame
  std::array<int, 4> Viewport{ { 0, 0, 0, 0 } };
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  int Bits = 0;
  bool Captured = false;
  int Unit = 0;
  int UnitBefore = 0;
};
VTK_ABI_NAMESPACE_END

#endif
