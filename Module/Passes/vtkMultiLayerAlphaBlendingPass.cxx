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
constexpr int WordsOfLayer = 3; // MultiLayer/Layers.glsl
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
             "layers of a pixel; what lies behind them is merged into the last", [this] { return this->GetLayers(); },
             [this](double value) { this->SetLayers(static_cast<int>(value)); } },
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
  const vtkTranslucencyFrame::Defines layers{ { "LAYERS", std::to_string(this->Layers) } };
  vtkTranslucencyFrame::Gathering gathering{ "MultiLayer/Gather.glsl", layers };
  gathering.Critical = true;
  return frame.UsePixels(this->Pixels, this->Layers * WordsOfLayer, this->MemoryLimit) && frame.Draw(gathering, {}) &&
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
