// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyMaterial.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTranslucencyMaterial);
vtkInformationKeyRestrictedMacro(vtkTranslucencyMaterial, MATERIAL, ObjectBase, "vtkTranslucencyMaterial");

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AttenuationColor: " << this->AttenuationColor[0] << " " << this->AttenuationColor[1] << " "
     << this->AttenuationColor[2] << "\n";
  os << indent << "AttenuationDistance: " << this->AttenuationDistance << "\n";
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetMaterial(vtkProp* prop, vtkTranslucencyMaterial* material)
{
  if (!prop)
  {
    vtkGenericWarningMacro(<< "SetMaterial: the prop is null");
    return;
  }
  if (GetMaterial(prop) == material)
  {
    return;
  }
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  if (material)
  {
    prop->GetPropertyKeys()->Set(MATERIAL(), material);
  }
  else
  {
    prop->GetPropertyKeys()->Remove(MATERIAL());
  }
  prop->Modified();
}

//------------------------------------------------------------------------------
vtkTranslucencyMaterial* vtkTranslucencyMaterial::GetMaterial(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys ? vtkTranslucencyMaterial::SafeDownCast(keys->Get(MATERIAL())) : nullptr;
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetAttenuationColor(double red, double green, double blue)
{
  for (const double channel : { red, green, blue })
  {
    if (!(channel > 0 && channel <= 1))
    {
      vtkErrorMacro(<< "AttenuationColor is (" << red << ", " << green << ", " << blue
                    << "), expected three numbers above 0 and up to 1");
      return;
    }
  }
  const double color[3] = { red, green, blue };
  if (!std::equal(color, color + 3, this->AttenuationColor))
  {
    std::copy(color, color + 3, this->AttenuationColor);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetAttenuationDistance(double distance)
{
  if (!(distance > 0))
  {
    vtkErrorMacro(<< "AttenuationDistance is " << distance << ", expected a number above 0");
    return;
  }
  if (this->AttenuationDistance != distance)
  {
    this->AttenuationDistance = distance;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::GetAbsorption(double absorption[3])
{
  for (int i = 0; i < 3; ++i)
  {
    absorption[i] = -std::log(this->AttenuationColor[i]) / this->AttenuationDistance;
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMaterial::Absorbs()
{
  double absorption[3];
  this->GetAbsorption(absorption);
  return absorption[0] > 0 || absorption[1] > 0 || absorption[2] > 0;
}
VTK_ABI_NAMESPACE_END
