// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSortedPolygons.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSortedPolygons);

namespace
{
std::vector<double> FindDepths(vtkPolyData* data, const double direction[3])
{
  std::vector<double> depths(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    double point[3];
    data->GetPoint(static_cast<vtkIdType>(i), point);
    depths[i] = vtkMath::Dot(point, direction);
  }
  return depths;
}

/// The farthest cell first. Adds their numbers in the data to order, which has those of the kinds before.
vtkSmartPointer<vtkCellArray> Sort(
  vtkCellArray* cells, const std::vector<double>& depths, std::vector<vtkIdType>& order)
{
  const auto first = static_cast<vtkIdType>(order.size());
  const vtkIdType count = cells->GetNumberOfCells();
  std::vector<std::pair<double, vtkIdType>> keys(static_cast<std::size_t>(count));
  vtkIdType size;
  const vtkIdType* points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    cells->GetCellAtId(i, size, points);
    double sum = 0;
    for (vtkIdType j = 0; j < size; ++j)
    {
      sum += depths[points[j]];
    }
    const double depth = sum / static_cast<double>(size);
    keys[i] = { std::isnan(depth) ? 0 : -depth, i }; // a NaN would have no place in an order
  }
  std::sort(keys.begin(), keys.end());

  auto sorted = vtkSmartPointer<vtkCellArray>::New();
  sorted->AllocateExact(count, cells->GetNumberOfConnectivityIds());
  for (const auto& key : keys)
  {
    cells->GetCellAtId(key.second, size, points);
    sorted->InsertNextCell(size, points);
    order.push_back(first + key.second);
  }
  return sorted;
}
}

//------------------------------------------------------------------------------
int vtkSortedPolygons::RequestData(
  vtkInformation* vtkNotUsed(request), vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);

  const std::vector<double> depths = FindDepths(input, this->Direction);
  std::vector<vtkIdType> order;
  order.reserve(static_cast<std::size_t>(input->GetNumberOfCells()));
  const auto sort = [&](vtkCellArray* cells)
  { return cells->GetNumberOfCells() > 0 ? Sort(cells, depths, order) : nullptr; };
  output->SetVerts(sort(input->GetVerts()));
  output->SetLines(sort(input->GetLines()));
  output->SetPolys(sort(input->GetPolys()));
  output->SetStrips(sort(input->GetStrips()));

  vtkCellData* data = output->GetCellData();
  data->Initialize();
  data->CopyAllOn();
  data->CopyAllocate(input->GetCellData(), static_cast<vtkIdType>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    data->CopyData(input->GetCellData(), order[i], static_cast<vtkIdType>(i));
  }
  return 1;
}
VTK_ABI_NAMESPACE_END
