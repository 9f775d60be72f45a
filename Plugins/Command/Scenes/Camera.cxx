// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Camera.h"

#include "Scene.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Margin = 0.05; // of the picture, on each side

vtkBoundingBox BoundsOf(const Scene& scene)
{
  vtkBoundingBox bounds;
  for (const Part& part : scene.Parts)
  {
    bounds.AddBounds(part.Actor->GetBounds());
  }
  return bounds;
}

// The part of the view plane at distance 1 that the scene covers.
struct Extent
{
  double Least[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double Most[2] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };

  double Center(int axis) const { return (this->Least[axis] + this->Most[axis]) / 2; }
  double Half(int axis) const { return (this->Most[axis] - this->Least[axis]) / 2; }
};

Extent Project(const Scene& scene, vtkCamera* camera)
{
  Extent extent;
  vtkNew<vtkMatrix4x4> toView;
  for (const Part& part : scene.Parts)
  {
    vtkMatrix4x4::Multiply4x4(camera->GetViewTransformMatrix(), part.Actor->GetMatrix(), toView);
    auto* surface = vtkPolyData::SafeDownCast(part.Actor->GetMapper()->GetInputDataObject(0, 0));
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double point[4] = { 0, 0, 0, 1 };
      surface->GetPoint(i, point);
      toView->MultiplyPoint(point, point);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double place = point[axis] / -point[2];
        extent.Least[axis] = std::min(extent.Least[axis], place);
        extent.Most[axis] = std::max(extent.Most[axis], place);
      }
    }
  }
  return extent;
}

// Moves the eye, and what it looks at, within the plane that it sees.
void Pan(double right, double up, vtkCamera* camera)
{
  vtkMatrix4x4* view = camera->GetViewTransformMatrix();
  Vector3 position;
  Vector3 target;
  camera->GetPosition(position.data());
  camera->GetFocalPoint(target.data());
  for (int i = 0; i < 3; ++i)
  {
    const double step = right * view->GetElement(0, i) + up * view->GetElement(1, i);
    position[i] += step;
    target[i] += step;
  }
  camera->SetPosition(position.data());
  camera->SetFocalPoint(target.data());
}

// Narrows or widens the view until the scene fills it; centres it, unless the scene says what to look at.
void Fit(const Scene& scene, double aspect, vtkCamera* camera)
{
  Extent extent = Project(scene, camera);
  for (int step = 0; step < 2 && !scene.Eye.Target; ++step) // perspective: the first step is not quite right
  {
    const double distance = camera->GetDistance();
    Pan(extent.Center(0) * distance, extent.Center(1) * distance, camera);
    extent = Project(scene, camera);
  }
  double half[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    half[axis] = extent.Half(axis) + std::abs(extent.Center(axis));
  }
  const double needed = std::max(half[1], half[0] / aspect) / (1 - 2 * Margin);
  if (needed > 0)
  {
    camera->SetViewAngle(2 * vtkMath::DegreesFromRadians(std::atan(needed)));
  }
}
}

//------------------------------------------------------------------------------
void SetUpCamera(const Scene& scene, double aspect, vtkCamera* camera)
{
  const View& view = scene.Eye;
  const vtkBoundingBox bounds = BoundsOf(scene);
  Vector3 center;
  bounds.GetCenter(center.data());
  const Vector3 oblique{ { -0.42, -0.34, -0.84 } }; // shows depth, whatever is seen
  Vector3 direction = view.Direction.value_or(oblique);
  vtkMath::Normalize(direction.data());
  const Vector3 target = view.Target.value_or(center);
  const double angle = view.Angle.value_or(30);
  const double radius = std::max(bounds.GetDiagonalLength() / 2, 1e-6);
  const double distance = radius / std::sin(vtkMath::RadiansFromDegrees(angle / 2));

  camera->SetViewAngle(angle);
  camera->SetFocalPoint(target.data());
  if (view.Position)
  {
    camera->SetPosition(view.Position->data());
  }
  else
  {
    camera->SetPosition(
      target[0] - distance * direction[0], target[1] - distance * direction[1], target[2] - distance * direction[2]);
  }
  camera->SetViewUp(view.Up.value_or(Vector3{ { 0, 1, 0 } }).data());
  camera->Azimuth(view.Azimuth);
  camera->Elevation(view.Elevation);
  camera->OrthogonalizeViewUp();
  if (view.Height)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*view.Height / 2);
  }
  else if (!view.Position && !view.Angle)
  {
    Fit(scene, aspect, camera);
  }
  camera->Zoom(view.Zoom);
}
