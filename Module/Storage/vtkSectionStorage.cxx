#include "vtkSectionStorage.h"

#include "Common/Bindings.glsl"
#include "Storage/CellLayout.glsl"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkSectionStorage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SectionLength: " << this->SectionLength << "\n";
}

//------------------------------------------------------------------------------
void vtkSectionStorage::SetSectionLength(int fragments)
{
  if (fragments < 1 || fragments > LongestSection)
  {
    vtkErrorMacro(<< "SectionLength is " << fragments << ", expected 1 to " << LongestSection << " fragments");
    return;
  }
  if (this->SectionLength != fragments)
  {
    this->UseSectionLength(fragments);
    this->Modified();
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
const char* vtkSectionStorage::GetShaderName() const
{
  return "Sections";
}

//------------------------------------------------------------------------------
std::vector<vtkCellStorage::Layout> vtkSectionStorage::GetLayouts() const
{
  const int fragmentWords = 1 + this->GetColorWords() + (this->Samples > 1 ? 1 : 0);
  const int unitWords = this->SectionLength * fragmentWords;
  const int pixelWords = this->GetPixelFragments() * fragmentWords;
  return { { STORAGE_BINDING_TABLE, 1, 0, Use::Cleared }, { STORAGE_BINDING_FRAGMENTS, pixelWords, unitWords },
    { STORAGE_BINDING_NEXT, 0, 1 }, { STORAGE_BINDING_LINKS, this->GetPixelFragments(), this->SectionLength, Use::Links } };
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSectionStorage::GetMostUnits(const Rectangle& tile) const
{
  // An entry tells links from sections by a bit, and holds a section's number beside what is free in it, or a fragment's number.
  const int bits = (this->Samples > 1 ? HEAD_BITS : 32) - 1;
  const vtkTypeInt64 fragments = (vtkTypeInt64(1) << bits) - 1;
  const vtkTypeInt64 sections = (vtkTypeInt64(1) << (bits - this->GetFreeBits())) - 1;
  const vtkTypeInt64 own = this->GetPixelFragments() > 0 ? static_cast<vtkTypeInt64>(tile[2]) * tile[3] : 0;
  return std::min(sections, fragments / this->SectionLength) - own;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSectionStorage::CountUnits(const unsigned int* cell) const
{
  const vtkTypeInt64 inserted = cell[CELL_INSERTED];
  return this->Superclass::CountUnits(cell) + (inserted + this->SectionLength - 1) / this->SectionLength;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSectionStorage::CountFragments(const unsigned int* cell) const
{
  return cell[CELL_FRAGMENTS];
}
