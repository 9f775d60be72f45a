// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Streamtubes.h"

#include "Basics/Failure.h"
#include "Basics/Progress.h"
#include "Inputs.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamTracer.h"
#include "vtkTubeFilter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace
{
// Of a cell's diagonal: short enough for tubes that bend smoothly.
constexpr double Step = 0.25;

// Each way from a seed; the length ends a line long before that, unless cells have no size.
constexpr vtkIdType MostSteps = 100000;

vtkDataArray* FindVectors(vtkDataSet* data)
{
  vtkPointData* arrays = data->GetPointData();
  if (arrays->GetVectors())
  {
    return arrays->GetVectors();
  }
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    const bool real = array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
    if (real && array->GetNumberOfComponents() == 3 && array != arrays->GetNormals())
    {
      return array;
    }
  }
  return nullptr;
}

std::vector<double> GetSpeeds(const std::string& source, vtkDataArray* vectors)
{
  std::vector<double> speeds(vectors->GetNumberOfTuples());
  for (std::size_t i = 0; i < speeds.size(); ++i)
  {
    double vector[3];
    vectors->GetTuple(static_cast<vtkIdType>(i), vector);
    // Not that of three arguments: libstdc++'s loses a nan between zeros.
    speeds[i] = std::hypot(std::hypot(vector[0], vector[1]), vector[2]);
    if (!std::isfinite(speeds[i]))
    {
      throw Failure(source + ": the length of vector " + std::to_string(i) + " is " + std::to_string(speeds[i]) +
        ", expected a finite number");
    }
  }
  return speeds;
}

vtkSmartPointer<vtkPolyData> ChooseSeeds(vtkDataSet* data, const std::vector<double>& speeds, double least, int most)
{
  std::vector<vtkIdType> fast;
  for (std::size_t i = 0; i < speeds.size(); ++i)
  {
    if (speeds[i] >= least && speeds[i] > 0)
    {
      fast.push_back(static_cast<vtkIdType>(i));
    }
  }
  const std::size_t count = std::min(fast.size(), static_cast<std::size_t>(most));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < count; ++i)
  {
    points->InsertNextPoint(data->GetPoint(fast[(2 * i + 1) * fast.size() / (2 * count)]));
  }
  auto seeds = vtkSmartPointer<vtkPolyData>::New();
  seeds->SetPoints(points);
  return seeds;
}

// The tracer makes a line for each way from a seed. Two tubes of them would have caps inside, where they meet: here
// they become one line. What has no length is left out, since no tube can be laid round it.
vtkSmartPointer<vtkPolyData> JoinAtSeeds(vtkPolyData* traced, vtkIdType seeds)
{
  std::vector<std::vector<vtkIdType>> lines(seeds);
  vtkDataArray* seedOf = traced->GetCellData()->GetArray("SeedIds");
  vtkNew<vtkIdList> half;
  for (vtkIdType i = 0; i < traced->GetNumberOfLines(); ++i)
  {
    traced->GetLines()->GetCellAtId(i, half);
    auto& line = lines.at(static_cast<std::size_t>(seedOf->GetComponent(i, 0)));
    std::reverse(line.begin(), line.end());
    line.insert(line.end(), half->begin(), half->end());
  }

  const auto coincide = [traced](vtkIdType a, vtkIdType b)
  {
    double first[3];
    double second[3];
    traced->GetPoint(a, first);
    traced->GetPoint(b, second);
    return std::equal(first, first + 3, second);
  };
  vtkNew<vtkCellArray> joined;
  for (auto& line : lines)
  {
    line.erase(std::unique(line.begin(), line.end(), coincide), line.end());
    if (line.size() > 1)
    {
      joined->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
    }
  }
  auto streamlines = vtkSmartPointer<vtkPolyData>::New();
  streamlines->SetPoints(traced->GetPoints());
  streamlines->SetLines(joined);
  return streamlines;
}

vtkSmartPointer<vtkPolyData> TraceStreamlines(
  vtkDataSet* data, const char* vectors, vtkPolyData* seeds, double leastSpeed, double mostLength)
{
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(data);
  tracer->SetSourceData(seeds);
  tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vectors);
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetIntegrationDirectionToBoth();
  tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(Step);
  tracer->SetMaximumPropagation(mostLength);
  tracer->SetMaximumNumberOfSteps(MostSteps);
  tracer->SetTerminalSpeed(leastSpeed);
  tracer->SetComputeVorticity(false);
  tracer->Update();
  return JoinAtSeeds(tracer->GetOutput(), seeds->GetNumberOfPoints());
}
}

//------------------------------------------------------------------------------
void AddStreamtubes(const Input& input, vtkDataSet* data, Scene& scene)
{
  vtkDataArray* vectors = data ? FindVectors(data) : nullptr;
  if (!vectors)
  {
    throw Failure(
      input.Source + ": has no vectors for streamtubes, expected a point array of three floating-point components");
  }
  if (!vectors->GetName())
  {
    vectors->SetName("vectors"); // filters find an array by its name
  }
  const Streamtubes& wanted = *input.Tubes;
  Progress progress("streamtubes");
  progress.Step(std::filesystem::path(input.Source).filename().string());
  const std::vector<double> speeds = GetSpeeds(input.Source, vectors);
  const double largest = *std::max_element(speeds.begin(), speeds.end());
  if (largest == 0)
  {
    throw Failure(input.Source + ": has no streamline, expected vectors other than 0");
  }
  const double least = wanted.Speed * largest;
  const double diagonal = data->GetLength();
  const auto streamlines = TraceStreamlines(
    data, vectors->GetName(), ChooseSeeds(data, speeds, least, wanted.Seeds), least, wanted.Length.value_or(diagonal));
  if (streamlines->GetNumberOfLines() == 0)
  {
    throw Failure(
      input.Source + ": has no streamline, expected vectors that stay inside the data for a part of a cell");
  }

  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(streamlines);
  tubes->SetRadius(wanted.Radius.value_or(diagonal / 200));
  tubes->SetNumberOfSides(wanted.Sides);
  tubes->CappingOn();
  tubes->Update();
  Part part = MakePart(input.Source + ", streamtubes", tubes->GetOutput());
  const Color color = input.Tint.value_or(DistinctColor(static_cast<int>(scene.Parts.size())));
  SetLook(part, color, input.Opacity.value_or(0.6), input.Transmission);
  scene.Parts.push_back(part);
}
