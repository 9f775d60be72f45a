#include "vtkLinkedListStorage.h"

#include "Common/Bindings.glsl"
#include "Storage/CellLayout.glsl"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLinkedListStorage);

//------------------------------------------------------------------------------
const char* vtkLinkedListStorage::GetShaderName() const
{
  return "LinkedList";
}

//------------------------------------------------------------------------------
std::vector<vtkCellStorage::Layout> vtkLinkedListStorage::GetLayouts() const
{
  return { { STORAGE_BINDING_TABLE, 1, 0, Use::Cleared }, { STORAGE_BINDING_FRAGMENTS, 0, 2 + this->GetColorWords() } };
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListStorage::GetMostUnits(const Rectangle&) const
{
  return HEAD_MASK - 1; // 0 is none
}
