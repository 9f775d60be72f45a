// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMBufferStorage.h"

#include "Storage/CellLayout.glsl"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkMBufferStorage);

namespace
{
constexpr double FarFromMean = 0.75;
}

//------------------------------------------------------------------------------
void vtkMBufferStorage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutomaticSectionLength: " << (this->AutomaticSectionLength ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
void vtkMBufferStorage::SetAutomaticSectionLength(bool automatic)
{
  if (this->AutomaticSectionLength != automatic)
  {
    this->AutomaticSectionLength = automatic;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMBufferStorage::SetSectionLength(int fragments)
{
  const vtkMTimeType before = this->GetMTime();
  this->Superclass::SetSectionLength(fragments);
  if (fragments == this->SectionLength || this->GetMTime() != before)
  {
    this->SetAutomaticSectionLength(false);
  }
}

//------------------------------------------------------------------------------
void vtkMBufferStorage::BeginFrame(const std::vector<Box>& boxes, const vtkTranslucencyCapabilities& capabilities)
{
  this->Superclass::BeginFrame(boxes, capabilities);
  if (this->AutomaticSectionLength && this->LastPixels > 0)
  {
    const double mean = static_cast<double>(this->LastFragments) / static_cast<double>(this->LastPixels);
    if (std::abs(mean - this->SectionLength) >= FarFromMean)
    {
      this->UseSectionLength(static_cast<int>(std::clamp(std::round(mean), 1.0, double(LongestSection))));
    }
  }
  this->LastFragments = 0;
  this->LastPixels = 0;
}

//------------------------------------------------------------------------------
void vtkMBufferStorage::Learn(const std::vector<unsigned int>& cells)
{
  this->LastFragments += this->GetFragments();
  for (std::size_t cell = 0; cell < cells.size(); cell += CELL_WORDS)
  {
    this->LastPixels += cells[cell + CELL_PIXELS];
  }
}
VTK_ABI_NAMESPACE_END
