// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthPeelPass.h"

#include "vtkBucketPeeling.h"
#include "vtkLayerPeeling.h"
#include "vtkListPeeling.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyOption.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkDepthPeelPass);

namespace
{
const char* const Methods[] = { "FrontToBack", "Dual", "BucketSort" };
}

//------------------------------------------------------------------------------
vtkDepthPeelPass::vtkDepthPeelPass()
  : Peeling(new vtkLayerPeeling)
  , Buckets(new vtkBucketPeeling)
  , Lists(new vtkListPeeling)
{
}

//------------------------------------------------------------------------------
vtkDepthPeelPass::~vtkDepthPeelPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << Methods[this->Method] << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Tail: " << (this->Tail == Drop ? "Drop" : "Average") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "KeepLayers: " << this->KeepLayers << "\n";
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::SetMethod(int method)
{
  vtkTranslucencyOption::SetProperty(this, vtkDepthPeelPass::GetOptions(), "Method", this->Method, method);
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::SetLayers(int layers)
{
  vtkTranslucencyOption::SetProperty(this, vtkDepthPeelPass::GetOptions(), "Layers", this->Layers, layers);
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::SetTail(int tail)
{
  vtkTranslucencyOption::SetProperty(this, vtkDepthPeelPass::GetOptions(), "Tail", this->Tail, tail);
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::SetMemoryLimit(double mebibytes)
{
  vtkTranslucencyOption::SetProperty(this, vtkDepthPeelPass::GetOptions(), "MemoryLimit", this->MemoryLimit, mebibytes);
}

//------------------------------------------------------------------------------
int vtkDepthPeelPass::GetNumberOfKeptLayers()
{
  return static_cast<int>(this->Peeling->GetImages().size());
}

//------------------------------------------------------------------------------
vtkImageData* vtkDepthPeelPass::GetKeptLayer(int index)
{
  const int count = this->GetNumberOfKeptLayers();
  if (index < 0 || index >= count)
  {
    vtkErrorMacro(<< "the layer is " << index << ", expected one of the " << count
                  << " layers kept, the first of which is 0");
    return nullptr;
  }
  return this->Peeling->GetImages()[index];
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkDepthPeelPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "Method", "method", Kind::Choice, Dual, 0, 2, { "front-to-back", "dual", "bucket-sort" },
             "dual takes off the nearest and the farthest layer at once, in half as many drawings of the geometry; "
             "bucket-sort up to 32, in far more memory",
             [this] { return this->GetMethod(); }, [this](double value) { this->SetMethod(static_cast<int>(value)); } },
    { "Layers", "layers", Kind::Integer, 0, 0, vtkPeelingSettings::MostLayers, {},
      "the most layers to peel, with dual half of them from each side; 0 peels until nothing is left",
      [this] { return this->GetLayers(); }, [this](double value) { this->SetLayers(static_cast<int>(value)); } },
    { "Tail", "tail", Kind::Choice, Average, 0, 1, { "drop", "average" },
      "what is done with fragments that are left after so many layers: nothing, or all are drawn as one layer of their "
      "mean colour",
      [this] { return this->GetTail(); }, [this](double value) { this->SetTail(static_cast<int>(value)); } },
    this->GetCriticalSectionOption(),
    vtkTranslucencyOption::NewMemoryLimit(
      "bucket-sort", [this] { return this->GetMemoryLimit(); },
      [this](double value) { this->SetMemoryLimit(value); }) };
}

//------------------------------------------------------------------------------
bool vtkDepthPeelPass::UsesStorage(const vtkTranslucencyCapabilities& capabilities) const
{
  return this->Method == BucketSort && capabilities.MissingForStorage.empty();
}

//------------------------------------------------------------------------------
std::string vtkDepthPeelPass::FindMissing(const vtkTranslucencyCapabilities& capabilities) const
{
  const std::string missing = this->Superclass::FindMissing(capabilities);
  return missing.empty() && this->UsesStorage(capabilities) ? this->FindMissingForCriticalSection(capabilities)
                                                            : missing;
}

//------------------------------------------------------------------------------
bool vtkDepthPeelPass::RenderStages(vtkTranslucencyFrame& frame)
{
  this->Peeling->GetImages().clear();
  const vtkPeelingSettings settings{ this->Layers, this->Tail == Average };
  if (this->Method == BucketSort)
  {
    if (!this->HasStorage && this->MemoryLimit > 0 && !this->MemoryLimitWarned)
    {
      vtkWarningMacro(
        << "MemoryLimit is " << this->MemoryLimit
        << " MiB, but the driver has no storage buffers; the targets that bucket-sort draws to have no limit");
      this->MemoryLimitWarned = true;
    }
    return this->HasStorage ? this->Buckets->Render(frame, settings, this->MemoryLimit)
                            : this->Lists->Render(frame, settings);
  }
  return this->Peeling->Render(frame, settings, this->Method == Dual, this->KeepLayers);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkDepthPeelPass::GetTechniqueBytes()
{
  return this->Peeling->GetBytes() + this->Buckets->GetBytes() + this->Lists->GetBytes();
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Peeling->Release(contextAlive);
  this->Buckets->Release(contextAlive);
  this->Lists->Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
