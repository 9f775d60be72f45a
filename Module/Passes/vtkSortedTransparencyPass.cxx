// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSortedTransparencyPass.h"

#include "vtkSortedActors.h"
#include "vtkTranslucencyOption.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkProp3D.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <limits>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSortedTransparencyPass);

namespace
{
const char* const Orders[] = { "Object", "Centroid", "Backface" };
const char* const Operators[] = { "Over", "Under" };

/// Of the centre of its bounds; what has no bounds counts as nearest.
double FindDepth(vtkProp* prop, vtkCamera* camera)
{
  const double* bounds = prop->GetBounds();
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return -std::numeric_limits<double>::infinity();
  }
  double view[3];
  camera->GetDirectionOfProjection(view);
  double depth = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    depth += view[axis] * (bounds[2 * axis] + bounds[2 * axis + 1]) / 2;
  }
  return depth;
}

/// Whether the prop's transformation turns its polygons inside out.
bool IsMirrored(vtkProp* prop)
{
  auto* placed = vtkProp3D::SafeDownCast(prop);
  if (!placed)
  {
    return false;
  }
  placed->ComputeMatrix();
  return placed->GetMatrix()->Determinant() < 0;
}
}

//------------------------------------------------------------------------------
vtkSortedTransparencyPass::vtkSortedTransparencyPass()
  : Actors(new vtkSortedActors)
{
}

//------------------------------------------------------------------------------
vtkSortedTransparencyPass::~vtkSortedTransparencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkSortedTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << Orders[this->Order] << "\n";
  os << indent << "Operator: " << Operators[this->Operator] << "\n";
}

//------------------------------------------------------------------------------
void vtkSortedTransparencyPass::SetOrder(int order)
{
  vtkTranslucencyOption::SetProperty(this, vtkSortedTransparencyPass::GetOptions(), "Order", this->Order, order);
}

//------------------------------------------------------------------------------
void vtkSortedTransparencyPass::SetOperator(int which)
{
  vtkTranslucencyOption::SetProperty(this, vtkSortedTransparencyPass::GetOptions(), "Operator", this->Operator, which);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkSortedTransparencyPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "Order", "order", Kind::Choice, Object, 0, 2, { "object", "centroid", "backface" },
             "what is sorted: whole objects, the polygons of each as well, or objects with the back faces of each "
             "before its front faces",
             [this] { return this->GetOrder(); }, [this](double value) { this->SetOrder(static_cast<int>(value)); } },
    { "Operator", "operator", Kind::Choice, Over, 0, 1, { "over", "under" },
      "over blends back to front into the window, under front to back into floats, which are rounded once",
      [this] { return this->GetOperator(); }, [this](double value) { this->SetOperator(static_cast<int>(value)); } } };
}

//------------------------------------------------------------------------------
// Back to front.
std::vector<vtkTranslucencyFrame::Part> vtkSortedTransparencyPass::SortParts(const vtkTranslucencyFrame& frame)
{
  using Faces = vtkTranslucencyFrame::Faces;
  vtkCamera* camera = frame.GetRenderer()->GetActiveCamera();
  std::vector<std::pair<double, vtkProp*>> props;
  for (vtkProp* prop : frame.GetProps())
  {
    props.emplace_back(FindDepth(prop, camera), prop);
  }
  std::stable_sort(props.begin(), props.end(), [](const auto& a, const auto& b) { return a.first > b.first; });

  std::vector<vtkTranslucencyFrame::Part> parts;
  std::set<std::string> unsorted;
  for (const auto& [depth, prop] : props)
  {
    if (this->Order == Backface)
    {
      const bool mirrored = IsMirrored(prop);
      for (Faces faces : { mirrored ? Faces::Front : Faces::Back, mirrored ? Faces::Back : Faces::Front })
      {
        parts.push_back({ prop, static_cast<int>(faces), faces });
      }
      continue;
    }
    const std::string obstacle = this->Order == Centroid ? vtkSortedActors::GetObstacle(prop) : "";
    if (!obstacle.empty())
    {
      unsorted.insert(obstacle);
    }
    const bool sorts = this->Order == Centroid && obstacle.empty();
    parts.push_back(
      { sorts ? this->Actors->Sort(prop, camera, this->Operator == Under) : prop, static_cast<int>(Faces::All) });
  }
  this->Actors->ForgetUnused();
  this->WarnOf(unsorted);
  return parts;
}

//------------------------------------------------------------------------------
// Once, as long as they are the same.
void vtkSortedTransparencyPass::WarnOf(const std::set<std::string>& unsorted)
{
  std::string names;
  for (const std::string& name : unsorted)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty() && names != this->Unsorted)
  {
    vtkWarningMacro(
      << "the polygons of " << names
      << " are not sorted, only the objects: expected actors with a vtkPolyDataMapper and its own shaders");
  }
  this->Unsorted = names;
}

//------------------------------------------------------------------------------
bool vtkSortedTransparencyPass::RenderStages(vtkTranslucencyFrame& frame)
{
  const int targets = this->Operator == Under ? frame.GetChannels() : 1;
  const vtkTranslucencyFrame::Gathering gathering{ "Sorted/Gather.glsl",
    { { "SORTED_TARGETS", std::to_string(targets) } }, targets };
  vtkTranslucencyFrame::Stage layers;
  layers.Parts = this->SortParts(frame);
  if (this->Operator == Over)
  {
    layers.Blend = frame.GetOver();
    return frame.Draw(gathering, layers);
  }
  std::reverse(layers.Parts.begin(), layers.Parts.end());
  layers.Blend = vtkTranslucencyFrame::Blending::Under;
  layers.Targets = &this->Layers;
  layers.Clear = { { 0, 0, 0, 1 } };
  std::vector<vtkTranslucencyFrame::Input> inputs{ { "sortedLayers", &this->Layers, 0 } };
  if (targets == 3)
  {
    inputs = { { "sortedRed", &this->Layers, 0 }, { "sortedGreen", &this->Layers, 1 },
      { "sortedBlue", &this->Layers, 2 } };
  }
  const std::vector<int> formats(inputs.size(), 4);
  return frame.UseTargets(this->Layers, formats) && frame.Draw(gathering, layers) &&
    frame.Composite("Sorted/Resolve.glsl", {}, inputs);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSortedTransparencyPass::GetTechniqueBytes()
{
  return this->Layers.GetBytes();
}

//------------------------------------------------------------------------------
void vtkSortedTransparencyPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Layers.Release(contextAlive);
  this->Actors->Clear();
}
VTK_ABI_NAMESPACE_END
