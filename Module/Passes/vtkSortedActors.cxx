// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSortedActors.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSortedPolygons.h"
#include "vtkTexture.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
struct vtkSortedActors::Sorted
{
  vtkWeakPointer<vtkActor> Of;
  vtkWeakPointer<vtkMapper> OfMapper;
  vtkTimeStamp Copied; // the mapper's settings
  vtkNew<vtkSortedPolygons> Filter;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  bool Used = true;
};

namespace
{
/// The direction of the view in the actor's own coordinates: distances along it order points as their depths do.
void FindDirection(vtkActor* actor, vtkCamera* camera, bool nearestFirst, double direction[3])
{
  double view[3];
  camera->GetDirectionOfProjection(view);
  const vtkMatrix4x4* matrix = actor->GetMatrix();
  for (int column = 0; column < 3; ++column)
  {
    direction[column] = 0;
    for (int row = 0; row < 3; ++row)
    {
      direction[column] += matrix->GetElement(row, column) * view[row];
    }
    direction[column] *= nearestFirst ? -1 : 1;
  }
}
}

//------------------------------------------------------------------------------
vtkSortedActors::vtkSortedActors() = default;
vtkSortedActors::~vtkSortedActors() = default;

//------------------------------------------------------------------------------
std::string vtkSortedActors::GetObstacle(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper)
  {
    return prop->GetClassName();
  }
  // Its subclasses draw something else than the polygons.
  static const std::string plain = vtkNew<vtkPolyDataMapper>()->GetClassName();
  if (mapper->GetClassName() != plain)
  {
    return mapper->GetClassName();
  }
  // The technique has to know such an actor as the one that it is: vtkTranslucencyUnreached.
  return actor->GetShaderProperty()->HasFragmentShaderCode() ? "actors with a fragment shader of their own" : "";
}

//------------------------------------------------------------------------------
vtkActor* vtkSortedActors::Sort(vtkProp* prop, vtkCamera* camera, bool nearestFirst)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor->GetMapper();
  auto found = std::find_if(this->Kept.begin(), this->Kept.end(),
    [=](const auto& kept) { return kept->Of == actor && kept->OfMapper == mapper; });
  if (found == this->Kept.end())
  {
    found = this->Kept.insert(found, std::make_unique<Sorted>());
    (*found)->Of = actor;
    (*found)->OfMapper = mapper;
    (*found)->Actor->ForceTranslucentOn();
    (*found)->Actor->SetMapper((*found)->Mapper);
  }
  Sorted& sorted = **found;
  sorted.Used = true;

  actor->ComputeMatrix();
  double direction[3];
  FindDirection(actor, camera, nearestFirst, direction);
  sorted.Filter->SetDirection(direction); // sorts anew only if it has changed
  if (sorted.Copied < mapper->GetMTime())
  {
    sorted.Mapper->vtkPolyDataMapper::ShallowCopy(
      mapper); // its OpenGL override warns of properties that it copies itself
    sorted.Mapper->StaticOff();
    sorted.Filter->SetInputConnection(mapper->GetInputConnection(0, 0));
    sorted.Mapper->SetInputConnection(sorted.Filter->GetOutputPort());
    sorted.Copied.Modified();
  }
  vtkActor* standIn = sorted.Actor;
  standIn->SetProperty(actor->GetProperty());
  standIn->SetBackfaceProperty(actor->GetBackfaceProperty());
  standIn->SetTexture(actor->GetTexture());
  standIn->SetShaderProperty(actor->GetShaderProperty());
  standIn->SetUserMatrix(actor->GetMatrix());
  if (actor->GetPropertyKeys())
  {
    standIn->SetPropertyKeys(actor->GetPropertyKeys());
  }
  return standIn;
}

//------------------------------------------------------------------------------
void vtkSortedActors::ForgetUnused()
{
  this->Kept.erase(std::remove_if(this->Kept.begin(), this->Kept.end(), [](const auto& kept) { return !kept->Used; }),
    this->Kept.end());
  for (const auto& kept : this->Kept)
  {
    kept->Used = false;
  }
}

//------------------------------------------------------------------------------
void vtkSortedActors::Clear()
{
  this->Kept.clear();
}
VTK_ABI_NAMESPACE_END
