// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isosurfaces.h"

#include "Basics/Progress.h"
#include "Inputs.h"

#include "vtkContourFilter.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace
{
vtkDataArray* FindScalars(vtkDataSet* data)
{
  vtkPointData* arrays = data->GetPointData();
  if (arrays->GetScalars() && arrays->GetScalars()->GetNumberOfComponents() == 1)
  {
    return arrays->GetScalars();
  }
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1)
    {
      return array;
    }
  }
  return nullptr;
}

// Values above which a part of the points lies: a tenth for the first, one in two hundred for the last. Equal steps
// in value would be no use for data with a long tail, which most measurements have.
std::vector<double> ChooseValues(vtkDataArray* scalars, int levels)
{
  const vtkIdType mostSamples = 1000000;
  const vtkIdType count = scalars->GetNumberOfTuples();
  const vtkIdType step = std::max<vtkIdType>(1, count / mostSamples);
  std::vector<double> samples;
  for (vtkIdType i = 0; i < count; i += step)
  {
    const double value = scalars->GetComponent(i, 0);
    if (std::isfinite(value))
    {
      samples.push_back(value);
    }
  }
  std::sort(samples.begin(), samples.end());

  std::vector<double> values;
  for (int i = 0; i < levels && !samples.empty(); ++i)
  {
    const double part = 0.1 * std::pow(0.05, levels > 1 ? i / (levels - 1.0) : 0.5);
    const double value = samples[static_cast<std::size_t>((1 - part) * (samples.size() - 1))];
    const double before = values.empty() ? samples.front() : values.back();
    if (value > before)
    {
      values.push_back(value);
    }
  }
  if (values.empty() && !samples.empty() && samples.back() > samples.front())
  {
    values.push_back((samples.front() + samples.back()) / 2);
  }
  return values;
}

vtkSmartPointer<vtkPolyData> Extract(vtkDataSet* data, vtkDataArray* scalars, double value)
{
  if (auto* volume = vtkImageData::SafeDownCast(data))
  {
    vtkNew<vtkFlyingEdges3D> surface;
    surface->SetInputData(volume);
    surface->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, scalars->GetName());
    surface->SetValue(0, value);
    surface->ComputeScalarsOff();
    surface->Update();
    return surface->GetOutput();
  }
  vtkNew<vtkContourFilter> surface;
  surface->SetInputData(data);
  surface->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, scalars->GetName());
  surface->SetValue(0, value);
  surface->ComputeScalarsOff();
  surface->ComputeNormalsOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(surface->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

// From cool and thin outside to warm and thick inside.
Color ShellColor(double depth)
{
  const Color shells[] = { { { 0.27, 0.45, 0.77 } }, { { 0.25, 0.68, 0.67 } }, { { 0.93, 0.77, 0.32 } },
    { { 0.84, 0.27, 0.22 } } };
  const double position = 3 * depth;
  const int left = std::min(static_cast<int>(position), 2);
  Color color;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = shells[left][i] + (position - left) * (shells[left + 1][i] - shells[left][i]);
  }
  return color;
}
}

//------------------------------------------------------------------------------
int AddIsosurfaces(const Input& input, vtkDataSet* data, Scene& scene)
{
  vtkDataArray* scalars = FindScalars(data);
  if (!scalars)
  {
    return 0;
  }
  if (!scalars->GetName())
  {
    scalars->SetName("scalars"); // filters find an array by its name
  }
  std::vector<double> values = input.Isovalues.empty() ? ChooseValues(scalars, input.Levels) : input.Isovalues;
  std::sort(values.begin(), values.end());

  const std::string file = std::filesystem::path(input.Source).filename().string();
  Progress progress("isosurfaces of " + file, static_cast<int>(values.size()));
  int surfaces = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    std::ostringstream name;
    name << scalars->GetName() << " = " << values[i];
    progress.Step(name.str());
    const auto surface = Extract(data, scalars, values[i]);
    if (surface->GetNumberOfCells() == 0)
    {
      continue;
    }
    const double depth = values.size() > 1 ? i / (values.size() - 1.0) : 0.5;
    Part part = MakePart(input.Source + ", " + name.str(), surface);
    const Color color = input.Tint.value_or(ShellColor(depth));
    SetLook(part, color, input.Opacity.value_or(0.2 + 0.4 * depth), input.Transmission);
    scene.Parts.push_back(part);
    ++surfaces;
  }
  return surfaces;
}
