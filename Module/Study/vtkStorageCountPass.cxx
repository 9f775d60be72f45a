// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStorageCountPass.h"

#include "Common/Bindings.glsl"
#include "vtkCellStorage.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyStatistics.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkStorageCountPass);

//------------------------------------------------------------------------------
vtkStorageCountPass::~vtkStorageCountPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkStorageCountPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Accesses: " << this->GetAccesses() << "\n";
  os << indent << "PackedBytes: " << this->PackedBytes << "\n";
  os << indent << "SectionFragments: " << this->SectionFragments << "\n";
}

//------------------------------------------------------------------------------
void vtkStorageCountPass::Reset()
{
  this->Histogram = {};
  this->Accesses = {};
  this->SectionFragments = 0;
  this->PackedBytes = -1;
}

//------------------------------------------------------------------------------
void vtkStorageCountPass::RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass)
{
  this->Reset();
  auto* storage = vtkCellStorage::SafeDownCast(this->Storage);
  if (!storage)
  {
    vtkErrorMacro(<< "the storage is a " << this->Storage->GetClassName()
                  << ", expected a vtkCellStorage: other shaders don't count");
    return;
  }
  storage->SetCountAccesses(true);
  this->Superclass::RenderTranslucent(state, volumetricPass);
  storage->SetCountAccesses(false); // others may draw with it
  if (!this->GetStatistics()->GetFallback().empty())
  {
    this->Reset();
  }
  if (this->SectionFragments == 0)
  {
    return;
  }
  vtkStorageAccounting::Settings settings;
  settings.TSectionLength = this->SectionFragments;
  settings.MSectionLength = this->SectionFragments;
  const vtkStorageAccounting accounting(settings, { this->Histogram });
  const auto design = vtkStorageDesign::Find(storage->GetName());
  this->PackedBytes = design && accounting.GetError().empty() ? accounting.GetCost(*design, 0).Bytes : -1;
}

//------------------------------------------------------------------------------
bool vtkStorageCountPass::UseLists(vtkTranslucencyFrame& frame)
{
  if (!frame.IsComplete())
  {
    return true; // it will be gathered again
  }
  const auto& tile = frame.GetTile();
  std::vector<unsigned int> pixels(static_cast<std::size_t>(tile[2]) * tile[3]);
  const auto bytes = static_cast<vtkTypeInt64>(pixels.size() * sizeof(unsigned int));
  if (!this->PixelFragments.Reserve(bytes))
  {
    return frame.Fail("the driver has no memory for counting fragments");
  }
  this->PixelFragments.Clear(bytes);
  this->PixelFragments.BindStorage(STORAGE_BINDING_READ_BACK);
  if (!frame.Resolve("Storage/CountAccesses.glsl", {}, {}))
  {
    return false;
  }
  this->PixelFragments.Download(pixels.data(), bytes);
  for (unsigned int count : pixels)
  {
    if (count > 0)
    {
      ++this->Histogram.Pixels[count];
    }
  }
  auto* storage = vtkCellStorage::SafeDownCast(this->Storage);
  this->Accesses += storage->GetAccesses();
  this->SectionFragments = storage->GetSectionFragments();
  this->Histogram.Width = frame.GetViewport()[2];
  this->Histogram.Height = frame.GetViewport()[3];
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkStorageCountPass::GetPixelsHolding(vtkTypeInt64 fragments) const
{
  const auto found = this->Histogram.Pixels.find(fragments);
  return this->Count(found == this->Histogram.Pixels.end() ? 0 : found->second);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkStorageCountPass::GetTechniqueBytes()
{
  return this->Superclass::GetTechniqueBytes() + this->PixelFragments.GetBytes();
}

//------------------------------------------------------------------------------
void vtkStorageCountPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Superclass::ReleaseTechniqueResources(contextAlive);
  this->PixelFragments.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
