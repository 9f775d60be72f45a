// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFragmentListPass.h"

#include "Common/Bindings.glsl"
#include "vtkLinkedListStorage.h"
#include "vtkSectionStorage.h"
#include "vtkStorageTable.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFragmentListPass::vtkFragmentListPass()
  : Storage(vtkSmartPointer<vtkLinkedListStorage>::New())
{
}

//------------------------------------------------------------------------------
vtkFragmentListPass::~vtkFragmentListPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SectionLength: " << this->SectionLength << "\n";
  os << indent << "Storage:\n";
  this->Storage->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::SetStorage(vtkFragmentStorage* storage)
{
  if (!storage)
  {
    vtkErrorMacro(<< "Storage is null, expected a vtkFragmentStorage");
    return;
  }
  if (this->Storage != storage)
  {
    this->ReleaseGraphicsResources(nullptr); // what the old one holds
    this->Storage = storage;
    this->SectionLengthWarned = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkFragmentStorage* vtkFragmentListPass::GetStorage()
{
  return this->Storage;
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::SetStorageDesign(int design)
{
  if (vtkTranslucencyOption::Check(this, vtkFragmentListPass::GetOptions(), "StorageDesign", design) &&
    this->GetStorageDesign() != design)
  {
    const auto storage = vtkStorageTable::New(design);
    storage->SetColorFormat(this->Storage->GetColorFormat());
    storage->SetMemoryLimit(this->Storage->GetMemoryLimit());
    this->SetStorage(storage);
    this->UseSectionLength();
  }
}

//------------------------------------------------------------------------------
int vtkFragmentListPass::GetStorageDesign()
{
  const std::vector<std::string>& names = vtkStorageTable::GetNames();
  const auto found = std::find(names.begin(), names.end(), this->Storage->GetName());
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::SetSectionLength(int fragments)
{
  if (vtkTranslucencyOption::Check(this, vtkFragmentListPass::GetOptions(), "SectionLength", fragments))
  {
    this->SectionLengthGiven = true;
    this->SectionLengthWarned = false;
    if (this->SectionLength != fragments)
    {
      this->SectionLength = fragments;
      this->Modified();
    }
    this->UseSectionLength();
  }
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::UseSectionLength()
{
  auto* storage = vtkSectionStorage::SafeDownCast(this->Storage);
  if (storage && this->SectionLengthGiven)
  {
    storage->SetSectionLength(this->SectionLength);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkFragmentListPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  vtkTranslucencyOption design{ "StorageDesign", "storage", Kind::Choice, LinkedList, 0,
    static_cast<double>(vtkStorageTable::GetNames().size() - 1), vtkStorageTable::GetNames(),
    "where fragments lie until they are resolved: the picture is the same", [this] { return this->GetStorageDesign(); },
    [this](double value) { this->SetStorageDesign(static_cast<int>(value)); } };
  std::vector<vtkTranslucencyOption> options{ design,
    { "SectionLength", "section_length", Kind::Integer, 4, 1, vtkSectionStorage::LongestSection, {},
      "fragments in a section of the t-buffer or m-buffer: longer ones for deeper scenes; the m-buffer's are as long "
      "as pixels hold on average, unless "
      "this is given",
      [this] { return this->GetSectionLength(); },
      [this](double value) { this->SetSectionLength(static_cast<int>(value)); } } };
  for (const vtkTranslucencyOption& option : this->Storage->GetOptions())
  {
    options.push_back(option);
  }
  return options;
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::UsesStorage(const vtkTranslucencyCapabilities&) const
{
  return true;
}

//------------------------------------------------------------------------------
std::string vtkFragmentListPass::FindMissing(const vtkTranslucencyCapabilities& capabilities) const
{
  const std::string missing = this->Superclass::FindMissing(capabilities);
  const bool retries =
    this->UsesStorage(capabilities) && vtkSectionStorage::SafeDownCast(this->Storage) && !capabilities.KeepsDrawOrder;
  return missing.empty() && retries ? capabilities.MissingForRetries : missing;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkFragmentListPass::GetTechniqueBytes()
{
  return this->Storage->GetBytes();
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Storage->Release(contextAlive);
}

//------------------------------------------------------------------------------
std::string vtkFragmentListPass::LevelText(int level)
{
  return std::to_string(level) + "u";
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::RenderStages(vtkTranslucencyFrame& frame)
{
  if (this->SectionLengthGiven && !this->SectionLengthWarned && !vtkSectionStorage::SafeDownCast(this->Storage))
  {
    vtkWarningMacro(<< "SectionLength is " << this->SectionLength << ", but " << this->GetOption("storage")
                    << " has no sections, expected the storage t-buffer or m-buffer");
    this->SectionLengthWarned = true;
  }
  bool drawn;
  do
  {
    drawn = frame.Gather(this->Storage) && this->UseLists(frame) && frame.ReserveSampleColors() &&
      this->ResolveLists(frame) && (!frame.IsLeftTo(LEVEL_EACH_SAMPLE) || this->ResolveEachSample(frame)) &&
      (!frame.IsLeftTo(LEVEL_SAMPLES) || frame.CompositeSamples());
  } while (drawn && !frame.IsComplete());
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::ResolveEachSample(vtkTranslucencyFrame& frame)
{
  bool drawn = true;
  for (int sample = 0; sample < frame.GetSamples() && drawn; ++sample)
  {
    frame.SetSample(sample, LEVEL_EACH_SAMPLE);
    drawn = this->ResolveLists(frame);
  }
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::ResolveShortLists(
  vtkTranslucencyFrame& frame, int most, int longer, vtkTranslucencyFrame::Squares& rest)
{
  rest = {};
  const int largest = frame.GetSample() == vtkTranslucencyFrame::WholePixel ? std::min(32, most) : 0;
  for (int size = 8; size <= largest; size *= 2)
  {
    this->LargestBlock = size;
    rest.Most = size;
    const int next = 2 * size <= largest ? rest.Level + 1 : longer;
    if (!frame.Resolve("ABuffer/ResolveShort.glsl",
          { { "BLOCK_SIZE", std::to_string(size) }, { "EQUAL_DEPTHS", "0" }, { "LONGER_LEVEL", LevelText(next) },
            { "EQUAL_DEPTHS_LEVEL", LevelText(ShortEqualDepths) } },
          rest))
    {
      return false;
    }
    ++rest.Level;
    rest.Fewer = size;
  }
  // Without a short list to begin with, what is left is everything, and comes first.
  rest.Level = rest.Fewer > 0 ? longer : 0;
  rest.Most = VTK_INT_MAX;
  return true;
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::ResolveLeftLists(vtkTranslucencyFrame& frame)
{
  using Squares = vtkTranslucencyFrame::Squares;
  if (frame.IsLeftTo(ShortEqualDepths) &&
    !frame.Resolve("ABuffer/ResolveShort.glsl",
      { { "BLOCK_SIZE", std::to_string(this->LargestBlock) }, { "EQUAL_DEPTHS", "1" },
        { "LONGER_LEVEL", LevelText(Long) }, // longer lists are done by now, or left to that already
        { "EQUAL_DEPTHS_LEVEL", LevelText(ShortEqualDepths) } },
      Squares::LeftTo(ShortEqualDepths)))
  {
    return false;
  }
  if (!frame.IsLeftTo(Long))
  {
    return true;
  }
  const Squares left = Squares::LeftTo(Long);
  return frame.SortLists(left) && frame.Resolve("ABuffer/ResolveSorted.glsl", {}, left);
}
VTK_ABI_NAMESPACE_END
