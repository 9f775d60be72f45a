#include "vtkFragmentListPass.h"

#include "Common/Bindings.glsl"
#include "vtkLinkedListStorage.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include <algorithm>

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
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkFragmentStorage* vtkFragmentListPass::GetStorage()
{
  return this->Storage;
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkFragmentListPass::GetOptions()
{
  return this->Storage->GetOptions();
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
  return frame.Gather(this->Storage) && frame.ReserveSampleColors() && this->ResolveLists(frame) &&
    (!frame.IsLeftTo(LEVEL_EACH_SAMPLE) || this->ResolveEachSample(frame)) &&
    (!frame.IsLeftTo(LEVEL_SAMPLES) || frame.CompositeSamples());
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
  for (int size = 8; size <= std::min(32, most); size *= 2)
  {
    this->LargestBlock = size;
    rest.Most = size;
    const int next = 2 * size <= std::min(32, most) ? rest.Level + 1 : longer;
    if (!frame.Resolve("ABuffer/ResolveShort.glsl",
          { { "BLOCK_SIZE", std::to_string(size) }, { "EQUAL_DEPTHS", "0" },
            { "LONGER_LEVEL", LevelText(next) },
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
