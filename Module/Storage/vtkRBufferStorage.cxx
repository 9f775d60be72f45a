// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRBufferStorage.h"

#include "Common/Bindings.glsl"
#include "Storage/CellLayout.glsl"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkRBufferStorage);

//------------------------------------------------------------------------------
void vtkRBufferStorage::SetQueueReads(int fragments)
{
  vtkTranslucencyOption::SetInteger(this, "QueueReads", this->QueueReads, fragments, 1, VTK_INT_MAX);
}

//------------------------------------------------------------------------------
const char* vtkRBufferStorage::GetFileName() const
{
  return "RBuffer";
}

//------------------------------------------------------------------------------
std::vector<vtkCellStorage::Layout> vtkRBufferStorage::GetLayouts() const
{
  return { { STORAGE_BINDING_TABLE, 1, 0, Use::Cleared }, this->GetNodes(), { STORAGE_BINDING_NEXT, 0, 1 },
    { STORAGE_BINDING_LINKS, 2, 0, Use::Cleared } };
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkRBufferStorage::GetMostUnits(const Rectangle&) const
{
  return HEAD_MASK - 1; // 0 is none
}

//------------------------------------------------------------------------------
const char* vtkRBufferStorage::GetRetrieval() const
{
  return "Storage/Retrieve.glsl";
}

//------------------------------------------------------------------------------
void vtkRBufferStorage::BeginRetrieval()
{
  this->ClearTable(); // which held what was drawn last
}

//------------------------------------------------------------------------------
// A pass takes a fragment away at least, in a drawing for each part of its queue. The last drawing finds none.
vtkTypeInt64 vtkRBufferStorage::GetMostRetrievals() const
{
  const vtkTypeInt64 fragments = this->GetFragments();
  return fragments * (1 + fragments / this->QueueReads) + 1;
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> vtkRBufferStorage::GetDefines() const
{
  std::map<std::string, std::string> defines = this->Superclass::GetDefines();
  defines["QUEUE_READS"] = std::to_string(this->QueueReads);
  return defines;
}
VTK_ABI_NAMESPACE_END
