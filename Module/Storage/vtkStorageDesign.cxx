// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStorageDesign.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
const std::vector<vtkStorageDesign::Kind>& vtkStorageDesign::GetAll()
{
  static const std::vector<Kind> designs{ Kind::LinkedList, Kind::TBuffer, Kind::RBuffer, Kind::MBuffer };
  return designs;
}

//------------------------------------------------------------------------------
std::string vtkStorageDesign::GetName(Kind design)
{
  switch (design)
  {
    case Kind::LinkedList:
      return "linked-list";
    case Kind::TBuffer:
      return "t-buffer";
    case Kind::RBuffer:
      return "r-buffer";
    case Kind::MBuffer:
      break;
  }
  return "m-buffer";
}

//------------------------------------------------------------------------------
std::optional<vtkStorageDesign::Kind> vtkStorageDesign::Find(const std::string& name)
{
  for (const Kind design : GetAll())
  {
    if (GetName(design) == name)
    {
      return design;
    }
  }
  return std::nullopt;
}
VTK_ABI_NAMESPACE_END
