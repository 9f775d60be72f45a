// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSectionStorage.h"

#include "Common/Bindings.glsl"
#include "Storage/CellLayout.glsl"
#include "vtkTranslucencyOption.h"

#include <algorithm>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSectionStorage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SectionLength: " << this->SectionLength << "\n";
}

//------------------------------------------------------------------------------
void vtkSectionStorage::SetSectionLength(int fragments)
{
  if (vtkTranslucencyOption::SetInteger(this, "SectionLength", this->SectionLength, fragments, 1, LongestSection))
  {
    this->ForgetUnits();
  }
}

//------------------------------------------------------------------------------
void vtkSectionStorage::UseSectionLength(int fragments)
{
  this->SectionLength = fragments;
  this->ForgetUnits();
}

//------------------------------------------------------------------------------
int vtkSectionStorage::GetFreeBits() const
{
  int bits = 0;
  while ((1 << bits) < this->SectionLength) // of a section that has been begun, length - 1 places may be free
  {
    ++bits;
  }
  return bits;
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> vtkSectionStorage::GetDefines() const
{
  std::map<std::string, std::string> defines = this->Superclass::GetDefines();
  defines["SECTION_LENGTH"] = std::to_string(this->SectionLength);
  defines["SECTION_FREE_BITS"] = std::to_string(this->GetFreeBits());
  defines["OWN_SECTIONS"] = this->GetPixelFragments() > 0 ? "1" : "0";
  return defines;
}

//------------------------------------------------------------------------------
const char* vtkSectionStorage::GetFileName() const
{
  return "Sections";
}

//------------------------------------------------------------------------------
std::vector<vtkCellStorage::Layout> vtkSectionStorage::GetLayouts() const
{
  const int words = 1 + this->GetColorWords() + (this->Samples > 1 ? 1 : 0);
  return { { STORAGE_BINDING_TABLE, 1, 0, Use::Cleared },
    { STORAGE_BINDING_FRAGMENTS, this->GetPixelFragments() * words, this->SectionLength * words, Use::Written,
      "fragmentTexels", 4 },
    { STORAGE_BINDING_NEXT, 0, 1, Use::Written, "nextTexels", 1 },
    { STORAGE_BINDING_LINKS, this->GetPixelFragments(), this->SectionLength, Use::Links } };
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSectionStorage::GetMostUnits(const Rectangle& tile) const
{
  // An entry tells links from sections by a bit, and holds a section's number beside what is free in it, or a
  // fragment's number.
  const int bits = (this->Samples > 1 ? HEAD_BITS : 32) - 1;
  const vtkTypeInt64 fragments = (vtkTypeInt64(1) << bits) - 1;
  const vtkTypeInt64 sections = (vtkTypeInt64(1) << (bits - this->GetFreeBits())) - 1;
  const vtkTypeInt64 own = this->GetPixelFragments() > 0 ? static_cast<vtkTypeInt64>(tile[2]) * tile[3] : 0;
  return std::min(sections, fragments / this->SectionLength) - own;
}

//------------------------------------------------------------------------------
unsigned int vtkSectionStorage::CountFree(const unsigned int* entries, int count) const
{
  const unsigned int mask = (1u << this->GetFreeBits()) - 1u;
  return std::accumulate(
    entries, entries + count, 0u, [mask](unsigned int free, unsigned int entry) { return free + (entry & mask); });
}
VTK_ABI_NAMESPACE_END
