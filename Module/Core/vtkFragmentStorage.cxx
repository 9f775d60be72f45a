// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFragmentStorage.h"

#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyOption.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkFragmentStorage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColorFormat: " << (this->ColorFormat == RGBA8 ? "RGBA8" : "HalfFloat") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}

//------------------------------------------------------------------------------
void vtkFragmentStorage::SetColorFormat(int format)
{
  vtkTranslucencyOption::SetProperty(this, vtkFragmentStorage::GetOptions(), "ColorFormat", this->ColorFormat, format);
}

//------------------------------------------------------------------------------
void vtkFragmentStorage::SetMemoryLimit(double mebibytes)
{
  vtkTranslucencyOption::SetProperty(
    this, vtkFragmentStorage::GetOptions(), "MemoryLimit", this->MemoryLimit, mebibytes);
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkFragmentStorage::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "ColorFormat", "color_format", Kind::Choice, 0, 0, 1, { "half-float", "rgba8" },
             "how a fragment's colour is kept; rgba8 takes 4 bytes less a fragment, and loses opacities "
             "near 1/255",
             [this] { return this->GetColorFormat(); },
             [this](double value) { this->SetColorFormat(static_cast<int>(value)); } },
    vtkTranslucencyOption::NewMemoryLimit(
      "fragments", [this] { return this->GetMemoryLimit(); }, [this](double value) { this->SetMemoryLimit(value); }) };
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> vtkFragmentStorage::GetDefines() const
{
  return { { "COLOR_FORMAT", this->ColorFormat == RGBA8 ? "COLOR_FORMAT_RGBA8" : "COLOR_FORMAT_HALF_FLOAT" } };
}

//------------------------------------------------------------------------------
double vtkFragmentStorage::GetLimitBytes(const vtkTranslucencyCapabilities& capabilities) const
{
  return capabilities.GetLimitBytes(this->MemoryLimit);
}
VTK_ABI_NAMESPACE_END
