// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelVolume.h"

#include "Basics/Failure.h"
#include "Basics/Progress.h"
#include "Inputs.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDiscreteFlyingEdges3D.h"
#include "vtkImageConstantPad.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleMeshPointNormals.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace
{
// More different values than this are measurements, not labels.
constexpr std::size_t MostLabels = 64;

struct Box
{
  std::array<int, 6> Extent{ { VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN } };

  void Add(int x, int y, int z)
  {
    const int position[] = { x, y, z };
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Extent[2 * axis] = std::min(this->Extent[2 * axis], position[axis]);
      this->Extent[2 * axis + 1] = std::max(this->Extent[2 * axis + 1], position[axis]);
    }
  }

  double Volume() const
  {
    double volume = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      volume *= this->Extent[2 * axis + 1] - this->Extent[2 * axis] + 1;
    }
    return volume;
  }
};

using Boxes = std::map<long long, Box>;

// Where each value lies; stops once there are too many values for labels.
struct FindBoxes
{
  template <typename Array>
  void operator()(Array* scalars, const int* extent, Boxes& boxes)
  {
    const auto values = vtk::DataArrayValueRange<1>(scalars);
    auto value = values.begin();
    for (int z = extent[4]; z <= extent[5]; ++z)
    {
      for (int y = extent[2]; y <= extent[3] && boxes.size() <= MostLabels; ++y)
      {
        Box* box = nullptr;
        long long label = 0;
        for (int x = extent[0]; x <= extent[1]; ++x, ++value)
        {
          const auto here = static_cast<long long>(*value);
          if (!box || here != label)
          {
            label = here;
            box = &boxes[label];
          }
          box->Add(x, y, z);
        }
      }
    }
  }
};

// Empty if the scalars can't be labels.
Boxes GetBoxes(vtkImageData* volume)
{
  Boxes boxes;
  vtkDataArray* scalars = volume->GetPointData()->GetScalars();
  if (scalars && scalars->GetNumberOfComponents() == 1)
  {
    using Dispatch = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>;
    Dispatch::Execute(scalars, FindBoxes{}, volume->GetExtent(), boxes);
  }
  if (boxes.size() > MostLabels)
  {
    boxes.clear();
  }
  return boxes;
}

// The surface of one label: closed also where the label touches the volume's border.
vtkSmartPointer<vtkPolyData> ExtractLabel(vtkImageData* volume, long long label, const Box& box, int smoothing)
{
  int extent[6];
  for (int i = 0; i < 6; ++i)
  {
    extent[i] = box.Extent[i] + (i % 2 ? 1 : -1);
  }
  vtkNew<vtkImageConstantPad> part;
  part->SetInputData(volume);
  part->SetOutputWholeExtent(extent);
  part->SetConstant(0);

  vtkNew<vtkDiscreteFlyingEdges3D> surface;
  surface->SetInputConnection(part->GetOutputPort());
  surface->SetValue(0, static_cast<double>(label));
  surface->ComputeNormalsOff();
  surface->ComputeScalarsOff();

  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(surface->GetOutputPort());
  smooth->SetNumberOfIterations(smoothing);
  smooth->SetPassBand(0.02);
  smooth->NormalizeCoordinatesOn();
  smooth->FeatureEdgeSmoothingOff();
  smooth->NonManifoldSmoothingOn();

  vtkNew<vtkTriangleMeshPointNormals> normals;
  normals->SetInputConnection(smoothing > 0 ? smooth->GetOutputPort() : surface->GetOutputPort());
  normals->Update();
  return normals->GetOutput();
}

// What surrounds much is thin, so that what lies inside is seen.
double DefaultOpacity(const Box& box, double largest)
{
  return 0.65 - 0.5 * std::cbrt(box.Volume() / largest);
}

// The labels to show: those that the input names, or all.
Boxes Select(const Input& input, const Boxes& boxes)
{
  Boxes selected;
  for (const auto& [label, style] : input.Labels)
  {
    const auto found = boxes.find(label);
    if (found == boxes.end() || label == 0)
    {
      throw Failure(input.Source + ": has no label " + std::to_string(label) + ", expected one between " +
        std::to_string(boxes.begin()->first) + " and " + std::to_string(boxes.rbegin()->first) +
        " other than 0, the background");
    }
    selected.insert(*found);
  }
  if (selected.empty())
  {
    selected = boxes;
    selected.erase(0);
  }
  return selected;
}
}

//------------------------------------------------------------------------------
bool IsLabelVolume(vtkImageData* volume)
{
  return !GetBoxes(volume).empty();
}

//------------------------------------------------------------------------------
void AddLabels(const Input& input, vtkImageData* volume, Scene& scene)
{
  const Boxes all = GetBoxes(volume);
  if (all.empty())
  {
    throw Failure(input.Source + ": is not a label volume, expected integer scalars of at most " +
      std::to_string(MostLabels) + " different values");
  }
  const Boxes boxes = Select(input, all);
  if (boxes.empty())
  {
    throw Failure(input.Source + ": has no label but 0, the background");
  }
  double largest = 0;
  for (const auto& [label, box] : boxes)
  {
    largest = std::max(largest, box.Volume());
  }

  const std::string file = std::filesystem::path(input.Source).filename().string();
  Progress progress("surfaces of " + file, static_cast<int>(boxes.size()));
  int index = 0;
  for (const auto& [label, box] : boxes)
  {
    const auto named = input.Labels.find(label);
    const LabelStyle style = named != input.Labels.end() ? named->second : LabelStyle();
    const std::string name = style.Name.empty() ? "label " + std::to_string(label) : style.Name;
    progress.Step(name);
    Part part = MakePart(input.Source + ", " + name, ExtractLabel(volume, label, box, input.Smoothing));
    const Color color = style.Tint ? *style.Tint : input.Tint.value_or(DistinctColor(index));
    SetLook(part, color, style.Opacity ? *style.Opacity : input.Opacity.value_or(DefaultOpacity(box, largest)),
      style.Transmission ? style.Transmission : input.Transmission);
    scene.Parts.push_back(part);
    ++index;
  }
}
