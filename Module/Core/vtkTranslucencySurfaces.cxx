// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencySurfaces.h"

#include "vtkTranslucencyMaterial.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkProp.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkTranslucencySurfaces::HasAny(const vtkRenderState* state)
{
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(vtkTranslucencyProp(state, i));
    if (material && (material->DependsOnAngle() || material->Emits()))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
vtkTranslucencyShader::Uniforms vtkTranslucencySurfaces::GetUniforms(vtkProp* prop)
{
  using Vector = vtkTranslucencyShader::Vector;
  Vector emission{ { 0, 0, 0, 0 } };
  Vector angles{ { 1, 0, 0, 0 } };
  if (vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(prop))
  {
    std::copy_n(material->GetEmissionColor(), 3, emission.begin());
    const double reflectance = material->GetReflectance();
    const double numbers[] = { material->GetGrazingOpacity(), material->GetGrazingExponent(), reflectance,
      reflectance > 0 ? 1.0 : 0.0 };
    std::copy_n(numbers, 4, angles.begin());
  }
  return { { "surfaceEmission", emission }, { "surfaceAngles", angles } };
}

//------------------------------------------------------------------------------
void vtkTranslucencySurfaces::Disperse(vtkProp* prop, double color[3])
{
  vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(prop);
  if (material && material->GetDispersion() > 0 && material->GetIndexOfRefraction() > 1)
  {
    std::transform(color, color + 3, color, [](double channel) { return channel * channel * channel; });
  }
}

//------------------------------------------------------------------------------
std::string vtkTranslucencySurfaces::FindNormal(const std::string& fragmentShader, vtkProp* prop)
{
  const std::string normal = "normalVCVSOutput";
  if (fragmentShader.find(normal) != std::string::npos)
  {
    return normal;
  }
  vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(prop);
  if (material && (material->DependsOnAngle() || material->GetIndexOfRefraction() > 1))
  {
    vtkWarningWithObjectMacro(prop, << "the material depends on the angle, but " << prop->GetClassName()
                                    << " is drawn without normals, as without lighting: it is drawn as if it faced "
                                       "the viewer");
  }
  return "vec3(0.0)";
}
VTK_ABI_NAMESPACE_END
