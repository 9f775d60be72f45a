// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyScene.h"

#include "vtkTranslucencyUnreached.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkTranslucencyScene::GetProps() const
{
  std::vector<vtkProp*> props;
  for (int i = 0; i < vtkTranslucencyPropCount(this->State); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(this->State, i);
    if (prop->HasTranslucentPolygonalGeometry() || this->Unreached.Has(prop))
    {
      props.push_back(prop);
    }
  }
  return props;
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkTranslucencyScene::GetDepthRange() const
{
  const std::array<double, 2> all{ { 0, 1 } };
  vtkCamera* camera = this->State->GetRenderer()->GetActiveCamera();
  const double* clipping = camera->GetClippingRange();
  vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
  double nearest = VTK_DOUBLE_MAX;
  double farthest = -VTK_DOUBLE_MAX;
  for (vtkProp* prop : this->GetProps())
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    const double* bounds = prop->GetBounds();
    if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
    {
      return all;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const double at[4] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)], 1 };
      const double distance = -view->MultiplyDoublePoint(at)[2];
      nearest = std::min(nearest, distance);
      farthest = std::max(farthest, distance);
    }
  }
  if (nearest > farthest)
  {
    return all;
  }
  const auto linear = [clipping](double distance)
  { return std::clamp((distance - clipping[0]) / (clipping[1] - clipping[0]), 0.0, 1.0); };
  return { { linear(nearest), linear(farthest) } };
}
