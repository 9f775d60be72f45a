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
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Bounds = vtkTranslucencyPropBounds::Bounds;

std::array<std::array<double, 4>, 8> GetCorners(const Bounds& bounds)
{
  std::array<std::array<double, 4>, 8> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners[corner] = { { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)], 1 } };
  }
  return corners;
}
}

//------------------------------------------------------------------------------
std::array<float, 4> vtkTranslucencyScene::GetClipping(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    return { { 1, 1, 0, 0 } };
  }
  const double* range = camera->GetClippingRange();
  return { { static_cast<float>(range[0]), static_cast<float>(range[1]), 0, 0 } };
}

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
// For a point (x, y, -1) the projection P gives P00 x - P02 of the picture, from -1 to 1, where it is no parallel one.
std::array<float, 4> vtkTranslucencyScene::GetRays(vtkRenderer* renderer, const std::array<int, 4>& viewport)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  std::array<float, 4> rays{ { 0, 0, 0, 0 } };
  if (!camera->GetParallelProjection())
  {
    vtkMatrix4x4* projection = camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
    for (int i = 0; i < 2; ++i)
    {
      const double scale = projection->GetElement(i, i);
      const double pixels = viewport[i + 2];
      rays[i] = static_cast<float>(2 / pixels / scale);
      rays[i + 2] = static_cast<float>((-1 - 2 * viewport[i] / pixels + projection->GetElement(i, 2)) / scale);
    }
  }
  return rays;
}

//------------------------------------------------------------------------------
std::vector<Bounds> vtkTranslucencyScene::GetBounds() const
{
  std::vector<vtkProp*> props = this->GetProps();
  props.erase(
    std::remove_if(props.begin(), props.end(), [](vtkProp* prop) { return !prop->GetVisibility(); }), props.end());
  return this->Kept.Get(props);
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
  for (const Bounds& bounds : this->GetBounds())
  {
    if (!vtkMath::AreBoundsInitialized(bounds.data()))
    {
      return all;
    }
    for (const auto& corner : GetCorners(bounds))
    {
      const double distance = -view->MultiplyDoublePoint(corner.data())[2];
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

//------------------------------------------------------------------------------
std::vector<std::array<double, 4>> vtkTranslucencyScene::GetBoxes(const std::array<int, 4>& viewport) const
{
  const std::array<double, 4> all{ { static_cast<double>(viewport[0]), static_cast<double>(viewport[1]),
    static_cast<double>(viewport[0] + viewport[2]), static_cast<double>(viewport[1] + viewport[3]) } };
  vtkRenderer* renderer = this->State->GetRenderer();
  vtkMatrix4x4* projection =
    renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  std::vector<std::array<double, 4>> boxes;
  for (const Bounds& bounds : this->GetBounds())
  {
    std::array<double, 4> box{ { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
    bool isBefore = vtkMath::AreBoundsInitialized(bounds.data());
    for (const auto& corner : GetCorners(bounds))
    {
      const double* at = projection->MultiplyDoublePoint(corner.data());
      isBefore = isBefore && at[3] > 0;
      for (int axis = 0; axis < 2; ++axis)
      {
        const double pixel = viewport[axis] + (at[axis] / at[3] + 1) / 2 * viewport[2 + axis];
        isBefore = isBefore && std::isfinite(pixel);
        box[axis] = std::min(box[axis], pixel);
        box[2 + axis] = std::max(box[2 + axis], pixel);
      }
    }
    boxes.push_back(isBefore ? box : all);
  }
  return boxes;
}
VTK_ABI_NAMESPACE_END
