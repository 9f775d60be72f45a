// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLinkedListStorage.h"

#include "Common/Bindings.glsl"
#include "Storage/CellLayout.glsl"

#include "vtkObjectFactory.h"

#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkLinkedListStorage);

//------------------------------------------------------------------------------
const char* vtkLinkedListStorage::GetFileName() const
{
  return "LinkedList";
}

//------------------------------------------------------------------------------
int vtkLinkedListStorage::GetUnitFragments() const
{
  return this->GetKeepsDrawOrder() ? NODE_RUN : 1;
}

//------------------------------------------------------------------------------
unsigned int vtkLinkedListStorage::CountFree(const unsigned int* entries, int count) const
{
  return std::accumulate(entries, entries + count, 0u,
    [](unsigned int free, unsigned int last)
    { return free + (NODE_RUN - last % NODE_RUN) % NODE_RUN; }); // runs begin at multiples of their length
}

//------------------------------------------------------------------------------
std::vector<vtkCellStorage::Layout> vtkLinkedListStorage::GetLayouts() const
{
  return { { STORAGE_BINDING_TABLE, 1, 0, Use::Cleared }, this->GetNodes() };
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkLinkedListStorage::GetMostUnits(const Rectangle&) const
{
  return (HEAD_MASK - 1) / this->GetUnitFragments(); // 0 is none
}
VTK_ABI_NAMESPACE_END
