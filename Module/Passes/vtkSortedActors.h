// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSortedActors
 *
 * Stand-ins for actors, with the polygons of their data sorted along the view. The actors, their mappers and their data
 * are left as they are, and so keep their shaders and buffers; what is sorted is kept until the view's direction, the
 * data or the transformation changes.
 */
#ifndef vtkSortedActors_h
#define vtkSortedActors_h

#include "vtkTranslucencyABINamespace.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkCamera;
class vtkProp;

class vtkSortedActors
{
public:
  vtkSortedActors();
  ~vtkSortedActors();
  vtkSortedActors(const vtkSortedActors&) = delete;
  vtkSortedActors& operator=(const vtkSortedActors&) = delete;

  /// Empty if the prop's polygons can be sorted, else what of it can't: the mapper's class, or its own.
  static std::string GetObstacle(vtkProp* prop);

  /// The actor with its polygons sorted, nearest first or farthest first. The prop has no obstacle.
  vtkActor* Sort(vtkProp* prop, vtkCamera* camera, bool nearestFirst);

  /// Forgets what wasn't asked for since this was last called.
  void ForgetUnused();

  void Clear();

private:
  struct Sorted;
  std::vector<std::unique_ptr<Sorted>> Kept;
};
VTK_ABI_NAMESPACE_END

#endif
