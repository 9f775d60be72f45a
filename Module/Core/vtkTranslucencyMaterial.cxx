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
  os << indent << "EmissionColor: " << this->EmissionColor[0] << " " << this->EmissionColor[1] << " "
     << this->EmissionColor[2] << "\n";
  os << indent << "GrazingOpacity: " << this->GrazingOpacity << "\n";
  os << indent << "GrazingExponent: " << this->GrazingExponent << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "IndexOfRefraction: " << this->IndexOfRefraction << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "Diffusion: " << this->Diffusion << "\n";
  os << indent << "Dispersion: " << this->Dispersion << "\n";
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
void vtkTranslucencyMaterial::SetEmissionColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  if (!std::all_of(color, color + 3, [](double channel) { return channel >= 0 && std::isfinite(channel); }))
  {
    vtkErrorMacro(<< "EmissionColor is (" << red << ", " << green << ", " << blue
                  << "), expected three finite numbers of 0 or more");
    return;
  }
  if (!std::equal(color, color + 3, this->EmissionColor))
  {
    std::copy(color, color + 3, this->EmissionColor);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetNumber(const char* name, double& member, double value, double least, double most)
{
  if (!(value >= least && value <= most))
  {
    vtkErrorMacro(<< name << " is " << value << ", expected a number from " << least << " to " << most);
  }
  else if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetGrazingOpacity(double opacity)
{
  this->SetNumber("GrazingOpacity", this->GrazingOpacity, opacity, 0, 1);
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetGrazingExponent(double exponent)
{
  this->SetNumber("GrazingExponent", this->GrazingExponent, exponent, 0, 1000);
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetReflectance(double reflectance)
{
  this->SetNumber("Reflectance", this->Reflectance, reflectance, 0, 1);
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetIndexOfRefraction(double index)
{
  this->SetNumber("IndexOfRefraction", this->IndexOfRefraction, index, 1, 100);
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetThickness(double thickness)
{
  this->SetNumber("Thickness", this->Thickness, thickness, 0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetDiffusion(double diffusion)
{
  this->SetNumber("Diffusion", this->Diffusion, diffusion, 0, 1);
}

//------------------------------------------------------------------------------
void vtkTranslucencyMaterial::SetDispersion(double dispersion)
{
  this->SetNumber("Dispersion", this->Dispersion, dispersion, 0, 1);
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

//------------------------------------------------------------------------------
bool vtkTranslucencyMaterial::Emits()
{
  return this->EmissionColor[0] > 0 || this->EmissionColor[1] > 0 || this->EmissionColor[2] > 0;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMaterial::ChangesBackground()
{
  return this->IndexOfRefraction > 1 || this->Diffusion > 0;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMaterial::DependsOnAngle()
{
  return this->GrazingExponent > 0 || this->Reflectance > 0;
}
VTK_ABI_NAMESPACE_END
