// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyGLState
 *
 * OpenGL's state as it was when this object was made comes back when it goes, whichever way the scope is left.
 *
 * What vtkOpenGLState caches is saved and restored through it, so that the cache stays true; the rest (shader program,
 * vertex array, buffer bindings) is asked of OpenGL.
 */
#ifndef vtkTranslucencyGLState_h
#define vtkTranslucencyGLState_h

#include "vtkTranslucencyABINamespace.h"

#include <array>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkOpenGLState;

class vtkTranslucencyGLState
{
public:
  /// storage: whether the driver has storage and uniform buffers that could have to be put back.
  vtkTranslucencyGLState(vtkOpenGLRenderWindow* window, bool storage);
  ~vtkTranslucencyGLState();

  /// GL_VIEWPORT as it was: x, y, width, height.
  const std::array<int, 4>& GetViewport() const { return this->Viewport; }

  /// GL_SCISSOR_BOX as it was, or the viewport where the scissor test was off.
  std::array<int, 4> GetScissor() const;

  /// The name of the framebuffer that is drawn to.
  static unsigned int GetDrawFramebuffer();

  /// Blends as VTK blends translucent props.
  static void UsePlainBlending(vtkOpenGLState* state);

  vtkTranslucencyGLState(const vtkTranslucencyGLState&) = delete;
  vtkTranslucencyGLState& operator=(const vtkTranslucencyGLState&) = delete;

private:
  struct BufferBinding
  {
    unsigned int Target;
    unsigned int Index;
    int Buffer;
    long long Start;
    long long Size;
  };

  vtkOpenGLRenderWindow* Window;
  std::array<int, 4> Viewport;
  std::array<int, 4> Scissor;
  std::array<int, 4> BlendFunction;
  std::array<int, 2> BlendEquation;
  std::array<unsigned char, 4> ColorMask;
  std::array<float, 4> ClearColor;
  float PointSize;
  bool ProgramPointSize;
  float LineWidth;
  unsigned char DepthMask;
  int DepthFunction;
  int CulledFaces;
  int ActiveTexture;
  int Program;
  int VertexArray;
  std::vector<std::pair<unsigned int, bool>> Enabled;
  std::vector<std::pair<unsigned int, int>> Buffers;
  std::vector<BufferBinding> IndexedBuffers;
};
VTK_ABI_NAMESPACE_END

#endif
