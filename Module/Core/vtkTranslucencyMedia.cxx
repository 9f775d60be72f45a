// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyMedia.h"

#include "Absorption/MediumNumbers.glsl"
#include "vtkTranslucencyMaterial.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
vtkTranslucencyMaterial* GetMedium(vtkProp* prop)
{
  vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(prop);
  return material && material->Absorbs() ? material : nullptr;
}

bool IsBody(vtkProp* prop)
{
  return GetMedium(prop) && prop->HasTranslucentPolygonalGeometry();
}
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMedia::IsMirrored(vtkProp* prop)
{
  return prop->GetMatrix() && prop->GetMatrix()->Determinant() < 0;
}

//------------------------------------------------------------------------------
int vtkTranslucencyMedia::CountProps(const vtkRenderState* state)
{
  int props = 0;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    props += IsBody(vtkTranslucencyProp(state, i)) ? 1 : 0;
  }
  return props;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMedia::Choose(vtkTranslucencyPass* pass, const vtkRenderState* state, const std::string& lacking)
{
  this->Absorptions.clear();
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    Absorption absorption;
    if (IsBody(prop))
    {
      GetMedium(prop)->GetAbsorption(absorption.data());
      if (std::find(this->Absorptions.begin(), this->Absorptions.end(), absorption) == this->Absorptions.end())
      {
        this->Absorptions.push_back(absorption);
      }
    }
  }
  const int props = CountProps(state);
  std::string wrong;
  if (props > 0 && !(pass->KeepsFragments() && pass->KeepsTransmissionColors()))
  {
    wrong = "it keeps not all fragments, expected a technique that does, such as exact, adaptive, wavelet or moment in "
            "variable memory";
  }
  else if (props > 0 && !lacking.empty())
  {
    wrong = "the driver lacks " + lacking;
  }
  else if (this->Absorptions.size() > MOST_MEDIA)
  {
    wrong = "they have " + std::to_string(this->Absorptions.size()) + " different attenuations, expected at most " +
      std::to_string(MOST_MEDIA);
  }
  if (!wrong.empty())
  {
    this->Absorptions.clear();
    if (this->Said != wrong)
    {
      vtkErrorWithObjectMacro(
        pass, << pass->GetClassName() << " draws " << props << " props without their attenuation: " << wrong);
    }
  }
  this->Said = wrong;
  return !this->Absorptions.empty();
}

//------------------------------------------------------------------------------
int vtkTranslucencyMedia::GetNumber(vtkProp* prop) const
{
  vtkTranslucencyMaterial* medium = this->Absorptions.empty() ? nullptr : GetMedium(prop);
  if (!medium)
  {
    return 0;
  }
  Absorption absorption;
  medium->GetAbsorption(absorption.data());
  const auto found = std::find(this->Absorptions.begin(), this->Absorptions.end(), absorption);
  if (found == this->Absorptions.end())
  {
    return 0;
  }
  return static_cast<int>(found - this->Absorptions.begin()) + 1 + (IsMirrored(prop) ? MEDIUM_FRONT : 0);
}

//------------------------------------------------------------------------------
vtkTranslucencyShader::Uniforms vtkTranslucencyMedia::GetUniforms(
  vtkRenderer* renderer, const std::array<int, 4>& picture) const
{
  using Vector = vtkTranslucencyShader::Vector;
  vtkTranslucencyShader::Uniforms values;
  for (std::size_t i = 0; i < this->Absorptions.size(); ++i)
  {
    Vector& absorption =
      std::get<Vector>(values["absorptionOf[" + std::to_string(i + 1) + "]"] = Vector{ { 0, 0, 0, 0 } });
    std::copy(this->Absorptions[i].begin(), this->Absorptions[i].end(), absorption.begin());
  }
  const float across = 2.0f / picture[2];
  const float up = 2.0f / picture[3];
  values["unprojectPicture"] = Vector{ { across, up, -1 - across * picture[0], -1 - up * picture[1] } };
  vtkNew<vtkMatrix4x4> unproject;
  unproject->DeepCopy(
    renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  unproject->Invert();
  for (int column = 0; column < 4; ++column)
  {
    Vector numbers;
    for (int row = 0; row < 4; ++row)
    {
      numbers[row] = static_cast<float>(unproject->GetElement(row, column));
    }
    values["unprojectColumn[" + std::to_string(column) + "]"] = numbers;
  }
  return values;
}
VTK_ABI_NAMESPACE_END
