#include "vtkMultiLayerAlphaBlendingPass.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

#include <limits>

vtkStandardNewMacro(vtkMultiLayerAlphaBlendingPass);

namespace
{
constexpr int LeastLayers = 1;
constexpr int MostLayers = 32;

// MultiLayer/Layers.glsl
int WordsOfLayer(int channels)
{
  return channels == 3 ? 4 : 3;
}

int WordsOfAverage(int channels)
{
  return 3 + 2 * channels;
}

const char* const Tails[] = { "TAIL_MERGE", "TAIL_DROP", "TAIL_AVERAGE" };
}

//------------------------------------------------------------------------------
vtkMultiLayerAlphaBlendingPass::vtkMultiLayerAlphaBlendingPass(int tail)
  : DefaultTail(tail)
  , Tail(tail)
{
}

//------------------------------------------------------------------------------
vtkMultiLayerAlphaBlendingPass::~vtkMultiLayerAlphaBlendingPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Tail: " << Tails[this->Tail] << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::SetLayers(int layers)
{
  if (layers < LeastLayers || layers > MostLayers)
  {
    vtkErrorMacro(<< "Layers is " << layers << ", expected " << LeastLayers << " to " << MostLayers);
    return;
  }
  if (this->Layers != layers)
  {
    this->Layers = layers;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::SetTail(int tail)
{
  if (tail < Merge || tail > Average)
  {
    vtkErrorMacro(<< "Tail is " << tail << ", expected Merge (0), Drop (1) or Average (2)");
    return;
  }
  if (this->Tail != tail)
  {
    this->Tail = tail;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::SetMemoryLimit(double mebibytes)
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
std::vector<vtkTranslucencyOption> vtkMultiLayerAlphaBlendingPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  return { { "Layers", "layers", Kind::Integer, 4, LeastLayers, MostLayers, {},
             "layers of a pixel", [this] { return this->GetLayers(); },
             [this](double value) { this->SetLayers(static_cast<int>(value)); } },
    { "Tail", "tail", Kind::Choice, static_cast<double>(this->DefaultTail), 0, 2, { "merge", "drop", "average" },
      "what becomes of fragments behind the layers: merged into the last, left out, or averaged behind it",
      [this] { return this->GetTail(); }, [this](double value) { this->SetTail(static_cast<int>(value)); } },
    this->GetCriticalSectionOption(),
    { "MemoryLimit", "memory_limit", Kind::Real, 0, 0, std::numeric_limits<double>::infinity(), {},
      "graphics memory for layers, in MiB; what does not fit is drawn in tiles; 0 means a quarter of the driver's memory, or 2048",
      [this] { return this->GetMemoryLimit(); }, [this](double value) { this->SetMemoryLimit(value); } } };
}

//------------------------------------------------------------------------------
std::string vtkMultiLayerAlphaBlendingPass::GetMissing(vtkOpenGLRenderWindow* window)
{
  const std::string missing = this->Superclass::GetMissing(window);
  return missing.empty() ? this->GetMissingForCriticalSection(window) : missing;
}

//------------------------------------------------------------------------------
bool vtkMultiLayerAlphaBlendingPass::RenderStages(vtkTranslucencyFrame& frame)
{
  const vtkTranslucencyFrame::Defines layers{ { "LAYERS", std::to_string(this->Layers) },
    { "TAIL", Tails[this->Tail] } };
  const int channels = frame.GetChannels();
  const int words = this->Layers * WordsOfLayer(channels) + (this->Tail == Average ? WordsOfAverage(channels) : 0);
  vtkTranslucencyFrame::Gathering gathering{ "MultiLayer/Gather.glsl", layers };
  gathering.Critical = true;
  return frame.UsePixels(this->Pixels, words, this->MemoryLimit) && frame.Draw(gathering, {}) &&
    frame.Composite("MultiLayer/Resolve.glsl", layers, {});
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMultiLayerAlphaBlendingPass::GetTechniqueBytes()
{
  return this->Pixels.GetBytes();
}

//------------------------------------------------------------------------------
void vtkMultiLayerAlphaBlendingPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Pixels.Release(contextAlive);
}
