// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyTransmission.h"

#include "vtkTranslucencyMaterial.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkNew.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPropCollection.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Whether a prop or one of its parts is emissive.
bool HoldsEmissive(vtkProp* prop)
{
  if (vtkActor::SafeDownCast(prop) || vtkTranslucencyTransmission::HasColor(prop))
  {
    return vtkTranslucencyTransmission::IsEmissive(prop);
  }
  vtkNew<vtkPropCollection> parts;
  prop->GetActors(parts);
  vtkCollectionSimpleIterator i;
  parts->InitTraversal(i);
  bool any = false;
  while (vtkProp* part = parts->GetNextProp(i))
  {
    any = any || vtkTranslucencyTransmission::IsEmissive(part);
  }
  return any;
}
}

//------------------------------------------------------------------------------
bool vtkTranslucencyTransmission::HasColor(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return keys && keys->Has(vtkTranslucencyPass::TRANSMISSION_COLOR());
}

//------------------------------------------------------------------------------
bool vtkTranslucencyTransmission::IsEmissive(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor ? vtkPointGaussianMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper && mapper->GetEmissive() && !HasColor(prop);
}

//------------------------------------------------------------------------------
vtkTranslucencyTransmission::Count vtkTranslucencyTransmission::CountProps(const vtkRenderState* state)
{
  Count result;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    double color[3];
    if (!vtkTranslucencyPass::GetTransmissionColor(prop, color))
    {
      result.Invalid = prop->GetClassName();
    }
    const bool emissive = HoldsEmissive(prop);
    const bool transmits = emissive || color[0] > 0 || color[1] > 0 || color[2] > 0;
    if (transmits && prop->HasTranslucentPolygonalGeometry())
    {
      ++result.Props;
      result.Emissive += emissive ? 1 : 0;
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkTranslucencyTransmission::SetColor(vtkProp* prop, const std::array<double, 3>& color)
{
  if (!prop)
  {
    vtkGenericWarningMacro(<< "SetTransmissionColor: the prop is null");
    return;
  }
  for (double channel : color)
  {
    if (!(channel >= 0 && channel <= 1))
    {
      vtkErrorWithObjectMacro(prop, << "the transmission colour is (" << color[0] << ", " << color[1] << ", "
                                    << color[2] << "), expected three numbers from 0 to 1");
      return;
    }
  }
  double before[3];
  if (HasColor(prop) && GetColor(prop, before) && std::equal(color.begin(), color.end(), before))
  {
    return;
  }
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Set(vtkTranslucencyPass::TRANSMISSION_COLOR(), color[0], color[1], color[2]);
  prop->Modified();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyTransmission::GetColor(vtkProp* prop, double color[3])
{
  const double* kept =
    HasColor(prop) ? prop->GetPropertyKeys()->Get(vtkTranslucencyPass::TRANSMISSION_COLOR()) : nullptr;
  const double unset = IsEmissive(prop) ? 1 : 0;
  bool valid = true;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = kept ? kept[i] : unset;
    valid = valid && color[i] >= 0 && color[i] <= 1;
    color[i] = color[i] > 0 ? std::min(color[i], 1.0) : 0; // NaN becomes 0
  }
  return valid;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyTransmission::DescribeLost(const vtkRenderState* state)
{
  const bool colors = CountProps(state).Props > 0;
  bool materials = false;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    materials = materials || vtkTranslucencyMaterial::GetMaterial(vtkTranslucencyProp(state, i));
  }
  return colors && materials ? " without transmission colours and materials"
    : colors                 ? " without transmission colours"
    : materials              ? " without materials"
                             : "";
}

//------------------------------------------------------------------------------
vtkTranslucencyTransmission::Kind vtkTranslucencyTransmission::Choose(
  vtkTranslucencyPass* pass, const vtkRenderState* state, const std::string& lacking)
{
  const Count transmitting = CountProps(state);
  if (!transmitting.Invalid.empty() && this->Invalid != transmitting.Invalid)
  {
    vtkErrorWithObjectMacro(pass, << "TRANSMISSION_COLOR of a " << transmitting.Invalid
                                  << " is not three numbers from 0 to 1; they are taken as the nearest ones that are");
  }
  this->Invalid = transmitting.Invalid;
  if (transmitting.Props == 0)
  {
    return Kind::None;
  }
  const bool keeps = pass->KeepsTransmissionColors();
  if (keeps && lacking.empty())
  {
    return Kind::Colored;
  }
  const std::string why = keeps ? "the driver lacks " + lacking : "as it is set, it keeps one transmittance, not three";
  if (this->Mean != why)
  {
    this->Mean = why;
    const std::string emissive = transmitting.Emissive > 0
      ? " (white for " + std::to_string(transmitting.Emissive) + " with emissive splats)"
      : "";
    vtkWarningWithObjectMacro(pass, << pass->GetClassName() << " takes the transmission colours of "
                                    << transmitting.Props << " props" << emissive << " by their mean: " << why);
  }
  return Kind::Mean;
}
VTK_ABI_NAMESPACE_END
