// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencySurfaces
 *
 * What materials do to their surfaces (vtkTranslucencyMaterial), for the shaders of mappers:
 * Shaders/Surface/Shade.glsl. The text is there in frames in which a prop has such a material only.
 */
#ifndef vtkTranslucencySurfaces_h
#define vtkTranslucencySurfaces_h

#include "vtkTranslucencyShader.h" // for Uniforms

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderState;

class vtkTranslucencySurfaces
{
public:
  /// Whether any prop of a state has a material that changes its surfaces.
  static bool HasAny(const vtkRenderState* state);

  /// What the text is given for a prop.
  static vtkTranslucencyShader::Uniforms GetUniforms(vtkProp* prop);

  /// Makes a transmission colour its cube where the prop's material disperses, as the paper has it.
  static void Disperse(vtkProp* prop, double color[3]);

  /// The normal in a mapper's shader, as the text wants it. Where there is none it warns, if the prop's material asks
  /// for angles.
  static std::string FindNormal(const std::string& fragmentShader, vtkProp* prop);
};
VTK_ABI_NAMESPACE_END

#endif
