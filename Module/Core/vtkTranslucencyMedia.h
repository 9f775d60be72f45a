// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyMedia
 *
 * What absorbs between surfaces (vtkTranslucencyMaterial), for the shaders of a frame.
 *
 * A fragment of a surface that bounds a body carries the number of what fills it, and which side it is
 * (Shaders/Absorption/Medium.glsl). When all fragments of a tile are stored and in order,
 * Shaders/Absorption/Absorb.glsl goes through each pixel's list and gives every fragment what was absorbed before it:
 * they are ordinary fragments from then on, so that every technique that keeps them draws absorption, and none knows of
 * it. That takes sorting and one full-screen pass, in frames in which anything absorbs only.
 */
#ifndef vtkTranslucencyMedia_h
#define vtkTranslucencyMedia_h

#include "vtkTranslucencyShader.h" // for Uniforms

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderState;
class vtkRenderer;
class vtkTranslucencyPass;

class vtkTranslucencyMedia
{
public:
  /// Whether a prop's matrix makes back faces of its front faces.
  static bool IsMirrored(vtkProp* prop);

  /// The translucent props that absorb.
  static int CountProps(const vtkRenderState* state);

  /// Numbers what a state's props are filled with. Whether there is anything that the technique can draw; says what
  /// can't be drawn, once.
  bool Choose(vtkTranslucencyPass* pass, const vtkRenderState* state, const std::string& lacking);

  /// What a prop's fragments carry: the number, and in the next bit whether front faces are back faces; 0 for nothing.
  int GetNumber(vtkProp* prop) const;

  /// What Absorb.glsl is given, for a picture in that rectangle of the window.
  vtkTranslucencyShader::Uniforms GetUniforms(vtkRenderer* renderer, const std::array<int, 4>& picture) const;

private:
  using Absorption = std::array<double, 3>;

  std::vector<Absorption> Absorptions; // number 1 is the first
  std::string Said;                    // what was last said
};
VTK_ABI_NAMESPACE_END

#endif
