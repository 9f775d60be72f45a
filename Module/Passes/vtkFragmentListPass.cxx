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
std::string vtkFragmentListPass::LevelText(int level)
{
  return std::to_string(level) + "u";
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::RenderStages(vtkTranslucencyFrame& frame)
{
  this->LargestBlock = 0;
  if (!frame.Gather(this->Storage) || !this->ResolveLists(frame))
  {
    return false;
  }
  return frame.GetSamples() == 1 || !frame.IsLeftTo(LEVEL_SAMPLES) ||
    (this->ResolveShortSamples(frame) && this->ResolveEachSample(frame));
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::ResolveShortSamples(vtkTranslucencyFrame& frame)
{
  if (this->LargestBlock == 0)
  {
    return true;
  }
  frame.SetSample(vtkTranslucencyFrame::WholePixel, LEVEL_SAMPLES);
  bool drawn = frame.ReserveSampleColors();
  vtkTranslucencyFrame::Squares squares{ ShortSamples, 0, 0 };
  for (int size = 8; size <= this->LargestBlock && drawn; size *= 2)
  {
    const bool last = size == this->LargestBlock;
    squares.Most = last ? VTK_INT_MAX : size;
    drawn = frame.Resolve("ABuffer/ResolveSamples.glsl",
      { { "BLOCK_SIZE", std::to_string(size) }, { "EQUAL_DEPTHS", "1" },
        { "LONGER_LEVEL", LevelText(last ? LEVEL_EACH_SAMPLE : squares.Level + 1) } },
      squares);
    ++squares.Level;
    squares.Fewer = size;
  }
  return drawn && frame.CompositeSamples();
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::ResolveEachSample(vtkTranslucencyFrame& frame)
{
  const int left = this->LargestBlock == 0 ? LEVEL_SAMPLES : LEVEL_EACH_SAMPLE;
  bool drawn = true;
  const int samples = frame.IsLeftTo(left) ? frame.GetSamples() : 0;
  for (int sample = 0; sample < samples && drawn; ++sample)
  {
    frame.SetSample(sample, left);
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
