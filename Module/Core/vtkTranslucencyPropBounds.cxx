// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyPropBounds.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkMath.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
std::vector<vtkTranslucencyPropBounds::Bounds> vtkTranslucencyPropBounds::Get(const std::vector<vtkProp*>& props)
{
  std::vector<Bounds> all;
  std::unordered_map<vtkProp*, Known> known;
  for (vtkProp* prop : props)
  {
    const Origin from = GetOrigin(prop);
    const auto last = this->Last.find(prop);
    Known& now = known[prop];
    if (from.Data && last != this->Last.end() && last->second.From.Data == from.Data &&
      last->second.From.Time == from.Time)
    {
      now = last->second;
    }
    else
    {
      now.Value = Ask(prop);
      now.From = GetOrigin(prop); // not before: asking may make new data
    }
    all.push_back(now.Value);
  }
  this->Last.swap(known);
  return all;
}

//------------------------------------------------------------------------------
vtkTranslucencyPropBounds::Origin vtkTranslucencyPropBounds::GetOrigin(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper || mapper->GetTotalNumberOfInputConnections() != 1)
  {
    return {};
  }
  auto* data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return data ? Origin{ data, std::max({ actor->GetMTime(), mapper->GetMTime(), data->GetMTime() }) } : Origin{};
}

//------------------------------------------------------------------------------
vtkTranslucencyPropBounds::Bounds vtkTranslucencyPropBounds::Ask(vtkProp* prop)
{
  Bounds bounds;
  vtkMath::UninitializeBounds(bounds.data());
  if (const double* asked = prop->GetBounds())
  {
    std::copy_n(asked, bounds.size(), bounds.begin());
  }
  return bounds;
}
VTK_ABI_NAMESPACE_END
