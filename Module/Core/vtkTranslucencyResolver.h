// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyResolver
 *
 * Runs resolve shaders over squares of pixels of the current tile, which see the whole pixel or one sample of it
 * (Shaders/Common/Resolve.glsl).
 *
 * And runs shaders once for each cell of a storage.
 */
#ifndef vtkTranslucencyResolver_h
#define vtkTranslucencyResolver_h

#include "vtkTranslucencyFrame.h" // for Squares

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyResolver
{
public:
  vtkTranslucencyResolver(vtkTranslucencyResources& resources, vtkOpenGLRenderWindow* window,
    vtkTranslucencyGeometry& geometry, vtkTranslucencyFrameShaders& shaders);

  /// What vtkTranslucencyFrame::SetSample says.
  void SetSample(int sample, int among);
  int GetSample() const { return this->Sample; }

  /// Makes room for the colours of the tile's samples. False if there is no memory for it.
  bool ReserveSampleColors(int samples, int channels);

  /// Makes the program of a resolve ready. Null if it does not compile: the shaders know why.
  vtkShaderProgram* Prepare(const std::string& file, const vtkTranslucencyFrame::Defines& defines, int level);

  /// Draws the squares by a program that is ready, over what is there. The storage is null where fragments are not
  /// stored. Gives what is wrong, empty if nothing is.
  std::string Draw(vtkShaderProgram* program, const vtkTranslucencyFrame::Squares& squares,
    const vtkTranslucencyFrame::Uniforms& uniforms, vtkFragmentStorage* storage, vtkTranslucencyFrame::Blending over);

  /// Draws an invocation for each cell of the storage's tile; if most is above 1 again and again, that often at most,
  /// until all of them have been discarded.
  void DrawCells(vtkShaderProgram* program, vtkFragmentStorage& storage, vtkTypeInt64 most);

private:
  vtkTranslucencyResources& Resources;
  vtkOpenGLRenderWindow* Window;
  vtkTranslucencyGeometry& Geometry;
  vtkTranslucencyFrameShaders& Shaders;
  int Sample = vtkTranslucencyFrame::WholePixel;
  int Among = -1;
};
VTK_ABI_NAMESPACE_END

#endif
