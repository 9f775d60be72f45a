#include "vtkFragmentListPass.h"

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
std::string vtkFragmentListPass::GetMissing(vtkOpenGLRenderWindow* window)
{
  return this->GetCapabilities(window).MissingForStorage;
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
bool vtkFragmentListPass::ResolveShortLists(
  vtkTranslucencyFrame& frame, int most, vtkTranslucencyFrame::Squares& rest)
{
  rest = {};
  for (int size = 8; size <= std::min(32, most); size *= 2)
  {
    rest.Most = size;
    if (!frame.Resolve("ABuffer/ResolveShort.glsl",
          { { "BLOCK_SIZE", std::to_string(size) },
            { "NEXT_LEVEL", std::to_string(rest.Level + 1) + "u" } },
          rest))
    {
      return false;
    }
    ++rest.Level;
    rest.Fewer = rest.Most;
  }
  rest.Most = VTK_INT_MAX;
  return true;
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::ResolveLongLists(
  vtkTranslucencyFrame& frame, const vtkTranslucencyFrame::Squares& rest)
{
  if (frame.GetHighestLevel() < rest.Level && this->Storage->GetMostExpected() <= rest.Fewer)
  {
    return true;
  }
  const auto left = vtkTranslucencyFrame::Squares::LeftTo(rest.Level + 1);
  if (!frame.Resolve("ABuffer/ResolveRuns.glsl",
        { { "NEXT_LEVEL", std::to_string(left.Level) + "u" } }, rest))
  {
    return false;
  }
  if (frame.GetHighestLevel() < left.Level)
  {
    return true;
  }
  if (!frame.Resolve("ABuffer/SortRuns.glsl", {}, left))
  {
    return false;
  }
  const vtkTypeInt64 deepest = frame.GetDeepestPixel();
  for (int length = 32; length < deepest; length *= 2)
  {
    if (!frame.Resolve("ABuffer/MergeRuns.glsl", {}, left, { { "runLength", length } }))
    {
      return false;
    }
  }
  return frame.Resolve("ABuffer/ResolveSorted.glsl", {}, left);
}
