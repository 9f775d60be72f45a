// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyStatistics.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTranslucencyStatistics);

//------------------------------------------------------------------------------
void vtkTranslucencyStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fragments: " << this->Fragments << "\n";
  os << indent << "DeepestPixel: " << this->DeepestPixel << "\n";
  os << indent << "Bytes: " << this->Bytes << "\n";
  os << indent << "Tiles: " << this->Tiles << "\n";
  os << indent << "GeometryPasses: " << this->GeometryPasses << "\n";
  os << indent << "ScreenPasses: " << this->ScreenPasses << "\n";
  os << indent << "ShaderBuilds: " << this->ShaderBuilds << "\n";
  os << indent << "GatherTime: " << this->GatherTime << "\n";
  os << indent << "ResolveTime: " << this->ResolveTime << "\n";
  os << indent << "Fallback: " << this->Fallback << "\n";
}

//------------------------------------------------------------------------------
void vtkTranslucencyStatistics::Reset()
{
  this->Fragments = 0;
  this->DeepestPixel = 0;
  this->Bytes = 0;
  this->Tiles = 0;
  this->GeometryPasses = 0;
  this->ScreenPasses = 0;
  this->ShaderBuilds = 0;
  this->GatherTime = -1;
  this->ResolveTime = -1;
  this->Fallback.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTranslucencyStatistics::Copy(vtkTranslucencyStatistics* others)
{
  this->Fragments = others->Fragments;
  this->DeepestPixel = others->DeepestPixel;
  this->Bytes = others->Bytes;
  this->Tiles = others->Tiles;
  this->GeometryPasses = others->GeometryPasses;
  this->ScreenPasses = others->ScreenPasses;
  this->ShaderBuilds = others->ShaderBuilds;
  this->GatherTime = others->GatherTime;
  this->ResolveTime = others->ResolveTime;
  this->Fallback = others->Fallback;
  this->Modified();
}
VTK_ABI_NAMESPACE_END
