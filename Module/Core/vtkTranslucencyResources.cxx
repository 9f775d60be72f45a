// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyResources.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyResources::GetBytes()
{
  return this->Resolved.GetBytes() + this->SampleColors.GetBytes() + this->Layers.GetBytes() +
    this->Background.GetBytes();
}

//------------------------------------------------------------------------------
void vtkTranslucencyResources::Release(bool contextAlive)
{
  this->Mappers->Release();
  this->Unreached.Release();
  this->Layers.Release(contextAlive);
  this->Background.Release(contextAlive);
  this->Tiles.Forget();
  this->Programs.Release(contextAlive);
  this->Resolved.Release(contextAlive);
  this->SampleColors.Release(contextAlive);
  this->Window = nullptr;
  this->Context = nullptr;
}
VTK_ABI_NAMESPACE_END
