#include "vtkDepthPeelPass.h"

#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkDepthPeelPass);

namespace
{
using Blending = vtkTranslucencyFrame::Blending;
using Buffer = vtkTranslucencyFrame::Buffer;

const char* const Methods[] = { "PEEL_FRONT_TO_BACK", "PEEL_DUAL", "PEEL_BUCKET_SORT" };
constexpr int MostLayers = 65536;
const char* const TooMany = "more than 65536 layers, expected no more: depths of the same fragments may differ from drawing to drawing";

// Shaders/Peel/Methods.glsl
constexpr std::array<float, 4> NoBounds{ { -1e30f, -1e30f, 0, 0 } };
constexpr std::array<float, 4> AllWithin{ { 1e30f, 1e30f, 0, 0 } };
constexpr int PeelStage = 0;
constexpr int TailStage = 1;

// The buffers of both targets.
constexpr int Bounds = 0;
constexpr int Front = 1;
constexpr int Back = 2;

// Shaders/Peel/Buckets.glsl
constexpr int NumberOfBuckets = 8;
constexpr int BucketSize = 4;

int WordsOfRecord(int channels)
{
  return 7 + channels + NumberOfBuckets * BucketSize * (channels == 3 ? 4 : 3);
}

vtkTranslucencyFrame::Gathering GetGathering(int method)
{
  vtkTranslucencyFrame::Gathering gathering{ "Peel/Gather.glsl", { { "PEEL_METHOD", Methods[method] } } };
  gathering.Outputs = method == vtkDepthPeelPass::Dual ? 3 : 2;
  gathering.Rejects = true;
  return gathering;
}

// A premultiplied colour in floats as one in bytes that is not.
vtkSmartPointer<vtkImageData> NewImage(const std::array<int, 4>& rectangle, const std::vector<float>& colors)
{
  constexpr float Most = 255;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(rectangle[2], rectangle[3], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const float alpha = colors[i / 4 * 4 + 3];
    const float divisor = i % 4 == 3 || alpha <= 0 ? 1 : alpha;
    bytes[i] = static_cast<unsigned char>(std::lround(Most * std::clamp(colors[i] / divisor, 0.0f, 1.0f)));
  }
  return image;
}
}

//------------------------------------------------------------------------------
vtkDepthPeelPass::vtkDepthPeelPass() = default;

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
  if (method < FrontToBack || method > BucketSort)
  {
    vtkErrorMacro(<< "Method is " << method << ", expected FrontToBack (0), Dual (1) or BucketSort (2)");
    return;
  }
  if (this->Method != method)
  {
    this->Method = method;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::SetLayers(int layers)
{
  if (layers < 0 || layers > MostLayers)
  {
    vtkErrorMacro(<< "Layers is " << layers << ", expected 1 to " << MostLayers << ", or 0 for all");
    return;
  }
  if (this->Layers != layers)
  {
    this->Layers = layers;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::SetTail(int tail)
{
  if (tail < Drop || tail > Average)
  {
    vtkErrorMacro(<< "Tail is " << tail << ", expected Drop (0) or Average (1)");
    return;
  }
  if (this->Tail != tail)
  {
    this->Tail = tail;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::SetMemoryLimit(double mebibytes)
{
  if (!(mebibytes >= 0))
  {
    vtkErrorMacro(<< "MemoryLimit is " << mebibytes << " MiB, expected a positive number, or 0 for the default");
    return;
  }
  if (this->MemoryLimit != mebibytes)
  {
    this->MemoryLimit = mebibytes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkDepthPeelPass::GetNumberOfKeptLayers()
{
  return static_cast<int>(this->Images.size());
}

//------------------------------------------------------------------------------
vtkImageData* vtkDepthPeelPass::GetKeptLayer(int index)
{
  const int count = this->GetNumberOfKeptLayers();
  if (index < 0 || index >= count)
  {
    vtkErrorMacro(<< "the layer is " << index << ", expected one of the " << count << " layers kept, the first of which is 0");
    return nullptr;
  }
  return this->Images[index];
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkDepthPeelPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "Method", "method", Kind::Choice, Dual, 0, 2, { "front-to-back", "dual", "bucket-sort" },
             "dual takes off the nearest and the farthest layer at once, in half as many drawings of the geometry; bucket-sort up to 32, in far more memory",
             [this] { return this->GetMethod(); }, [this](double value) { this->SetMethod(static_cast<int>(value)); } },
    { "Layers", "layers", Kind::Integer, 0, 0, MostLayers, {},
      "the most layers to peel, with dual half of them from each side; 0 peels until nothing is left",
      [this] { return this->GetLayers(); }, [this](double value) { this->SetLayers(static_cast<int>(value)); } },
    { "Tail", "tail", Kind::Choice, Average, 0, 1, { "drop", "average" },
      "what is done with fragments that are left after so many layers: nothing, or all are drawn as one layer of their mean colour",
      [this] { return this->GetTail(); }, [this](double value) { this->SetTail(static_cast<int>(value)); } },
    this->GetCriticalSectionOption(),
    { "MemoryLimit", "memory_limit", Kind::Real, 0, 0, std::numeric_limits<double>::infinity(), {},
      "graphics memory for bucket-sort, in MiB; what does not fit is drawn in tiles; 0 means a quarter of the driver's memory, or 2048",
      [this] { return this->GetMemoryLimit(); }, [this](double value) { this->SetMemoryLimit(value); } } };
}

//------------------------------------------------------------------------------
std::string vtkDepthPeelPass::GetMissing(vtkOpenGLRenderWindow* window)
{
  const std::string missing = this->Superclass::GetMissing(window);
  if (!missing.empty())
  {
    return missing;
  }
  return this->Method == BucketSort ? this->GetMissingForCriticalSection(window) : this->GetCapabilities(window).MissingForBuffers;
}

//------------------------------------------------------------------------------
bool vtkDepthPeelPass::RenderStages(vtkTranslucencyFrame& frame)
{
  this->Images.clear();
  if (this->Method == BucketSort)
  {
    return this->PeelBuckets(frame);
  }
  const bool dual = this->Method == Dual;
  const std::vector<int> formats = dual ? std::vector<int>{ 2, 4, 4 } : std::vector<int>{ 1, 4 };
  bool left = false;
  if (!frame.UseTargets(this->Peeled, formats) || !frame.UseTargets(this->Merged, formats) || !this->Peel(frame, left))
  {
    return false;
  }
  const bool tail = left && this->Tail == Average;
  if (tail && !this->AddTail(frame))
  {
    return false;
  }
  std::vector<vtkTranslucencyFrame::Input> inputs{ { "frontLayers", &this->Merged, Front } };
  if (dual)
  {
    inputs.push_back({ "backLayers", &this->Merged, Back });
  }
  if (tail)
  {
    inputs.push_back({ "tailOpacities", &this->Peeled, Bounds });
    inputs.push_back({ "tailColors", &this->Peeled, Front });
  }
  return frame.Composite(
    "Peel/Resolve.glsl", { { "PEEL_METHOD", Methods[this->Method] }, { "PEEL_TAIL", tail ? "1" : "0" } }, inputs);
}

//------------------------------------------------------------------------------
bool vtkDepthPeelPass::Peel(vtkTranslucencyFrame& frame, bool& left)
{
  const bool dual = this->Method == Dual;
  vtkTranslucencyFrame::Stage peel;
  peel.Number = PeelStage;
  peel.Targets = &this->Peeled;
  peel.Blend = Blending::Over;
  peel.Differing[Bounds] = { Blending::Maximum, NoBounds };
  peel.Inputs = { { "peelBounds", &this->Merged, Bounds } };

  vtkTranslucencyFrame::Stage merge;
  merge.Targets = &this->Merged;
  merge.Blend = Blending::Under;
  merge.Clear = { { 0, 0, 0, 1 } };
  merge.Differing[Bounds] = { Blending::Minimum, AllWithin };
  merge.Inputs = { { "nextBounds", &this->Peeled, Bounds }, { "frontLayer", &this->Peeled, Front } };
  if (dual)
  {
    merge.Differing[Back] = { Blending::Over, {} };
    merge.Inputs.push_back({ "backLayer", &this->Peeled, Back });
  }

  // The first drawing finds bounds only. The others take a layer off, or two.
  const int layers = this->Layers == 0 ? MostLayers : this->Layers;
  const int most = 1 + (dual ? (layers + 1) / 2 : layers);
  left = frame.Clear(merge);
  merge.Cleared = 0;
  bool good = left;
  for (int drawing = 0; left && good && drawing < most; ++drawing)
  {
    good = frame.Draw(GetGathering(this->Method), peel, &left);
    if (good && left)
    {
      good = frame.DrawScreen("Peel/Merge.glsl", { { "PEEL_METHOD", Methods[this->Method] } }, merge) &&
        (drawing == 0 || !this->KeepLayers || dual || this->KeepLayer(frame));
    }
  }
  return good && (this->Layers > 0 || !left || frame.Fail(TooMany));
}

//------------------------------------------------------------------------------
bool vtkDepthPeelPass::KeepLayer(vtkTranslucencyFrame& frame)
{
  const std::vector<float> colors = frame.Read(this->Peeled, Front);
  if (!colors.empty())
  {
    this->Images.push_back(NewImage(frame.GetTile(), colors));
  }
  return !colors.empty();
}

//------------------------------------------------------------------------------
bool vtkDepthPeelPass::AddTail(vtkTranslucencyFrame& frame)
{
  vtkTranslucencyFrame::Stage sums;
  sums.Number = TailStage;
  sums.Targets = &this->Peeled;
  sums.Blend = Blending::AddAndAttenuate;
  sums.Clear = { { 0, 0, 0, 1 } };
  sums.Differing[Bounds] = { Blending::Add, {} };
  sums.Inputs = { { "peelBounds", &this->Merged, Bounds } };
  return frame.Draw(GetGathering(this->Method), sums);
}

//------------------------------------------------------------------------------
bool vtkDepthPeelPass::PeelBuckets(vtkTranslucencyFrame& frame)
{
  const vtkTranslucencyFrame::Defines buckets{ { "BUCKETS", std::to_string(NumberOfBuckets) },
    { "BUCKET_SIZE", std::to_string(BucketSize) } };
  vtkTranslucencyFrame::Gathering gathering{ "Peel/GatherBuckets.glsl", buckets };
  gathering.Values["PEEL_TAIL"] = this->Layers > 0 && this->Tail == Average ? "1" : "0";
  gathering.Critical = true;
  gathering.Rejects = true;
  vtkTranslucencyFrame::Defines merge = gathering.Values;
  merge["PEEL_LAYERS"] = std::to_string(this->Layers);

  bool left = true;
  int drawings = 0;
  bool good =
    frame.UsePixels(this->Buckets, WordsOfRecord(frame.GetChannels()), this->MemoryLimit) && frame.DrawScreen("Peel/StartBuckets.glsl", buckets, {});
  while (left && good)
  {
    good = (drawings++ < MostLayers || frame.Fail(TooMany)) && frame.Draw(gathering, {}) &&
      frame.DrawScreen("Peel/MergeBuckets.glsl", merge, {}, &left);
  }
  return good && frame.Composite("Peel/ResolveBuckets.glsl", buckets, {});
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkDepthPeelPass::GetTechniqueBytes()
{
  return this->Peeled.GetBytes() + this->Merged.GetBytes() + this->Buckets.GetBytes();
}

//------------------------------------------------------------------------------
void vtkDepthPeelPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Peeled.Release(contextAlive);
  this->Merged.Release(contextAlive);
  this->Buckets.Release(contextAlive);
}
