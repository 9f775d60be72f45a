// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVFramebuffer
 * @brief   a framebuffer that passes draw into in place of the one that is bound
 *
 * It has colour and depth. The depths have the format of those of the framebuffer that is bound when it is allocated,
 * since OpenGL hands them over between two of one format only.
 */
#ifndef vtkPVFramebuffer_h
#define vtkPVFramebuffer_h

#include <array>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

class vtkPVFramebuffer
{
public:
  /// The format of the colours of the framebuffer that is bound: GL_RGBA8, GL_RGBA16, GL_RGBA16F or GL_RGBA32F.
  static unsigned int GetBoundColorFormat();

  /// The framebuffer that is bound to be drawn to.
  static unsigned int GetBound();

  /// With 0 samples it is not multi-sampled. What is allocated so already is left alone. It does not stay bound.
  void Allocate(vtkOpenGLRenderWindow* window, int width, int height, int samples, unsigned int colorFormat);

  /// In the context that it was allocated in.
  void Free();

  /// OpenGL's name, 0 before Allocate().
  unsigned int GetName() const { return this->Allocated[0]; }

  /// Copies colours, depths or both (GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT) of an area (x, y, width, height) between
  /// framebuffers, which stay bound to be read and drawn to.
  static void Copy(vtkOpenGLState* state, unsigned int from, unsigned int to, const int* area, unsigned int parts);

private:
  std::array<unsigned int, 3> Allocated{ { 0, 0, 0 } };    // framebuffer, colour, depth
  std::array<unsigned int, 5> Layout{ { 0, 0, 0, 0, 0 } }; // width, height, samples, formats of colour and depth
};

#endif
