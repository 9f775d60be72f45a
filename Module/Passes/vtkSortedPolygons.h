// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSortedPolygons
 * @brief   the cells of polygonal data in the order of their centroids along a direction, farthest first
 *
 * A centroid is the mean of a cell's points; a strip is one cell. Vertices, lines, polygons and strips are sorted
 * apart, since mappers draw one kind after the other; cells of one depth stay in their order. The points are the
 * input's, and the cells' data go with the cells. VTK's own vtkDepthSortPolyData is not in every distribution of VTK,
 * takes more time, and gives data to the wrong cells where there are several kinds.
 */
#ifndef vtkSortedPolygons_h
#define vtkSortedPolygons_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTranslucencyABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkSortedPolygons : public vtkPolyDataAlgorithm
{
public:
  static vtkSortedPolygons* New();
  vtkTypeMacro(vtkSortedPolygons, vtkPolyDataAlgorithm);

  ///@{
  /// Towards what is far, in the data's own coordinates and of any length. (0, 0, 1) by default.
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

protected:
  vtkSortedPolygons() = default;
  ~vtkSortedPolygons() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  double Direction[3] = { 0, 0, 1 };

private:
  vtkSortedPolygons(const vtkSortedPolygons&) = delete;
  void operator=(const vtkSortedPolygons&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
