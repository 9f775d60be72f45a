#include "vtkAdaptiveTransparencyPass.h"

#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkAdaptiveTransparencyPass);

namespace
{
constexpr int LeastNodes = 1;
constexpr int MostNodes = 64;

const char* const Removals[] = { "NODE_REMOVAL_UNDERESTIMATE", "NODE_REMOVAL_OVERESTIMATE",
  "NODE_REMOVAL_MIXED" };
}

//------------------------------------------------------------------------------
vtkAdaptiveTransparencyPass::~vtkAdaptiveTransparencyPass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NodeCount: " << this->NodeCount << "\n";
  os << indent << "NodeRemoval: " << Removals[this->NodeRemoval] << "\n";
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetNodeCount(int count)
{
  if (count < LeastNodes || count > MostNodes)
  {
    vtkErrorMacro(<< "NodeCount is " << count << ", expected " << LeastNodes << " to " << MostNodes);
    return;
  }
  if (this->NodeCount != count)
  {
    this->NodeCount = count;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::SetNodeRemoval(int removal)
{
  if (removal < Underestimate || removal > Mixed)
  {
    vtkErrorMacro(<< "NodeRemoval is " << removal
                  << ", expected Underestimate (0), Overestimate (1) or Mixed (2)");
    return;
  }
  if (this->NodeRemoval != removal)
  {
    this->NodeRemoval = removal;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkAdaptiveTransparencyPass::GetOptions()
{
  using Kind = vtkTranslucencyOption::Kind;
  std::vector<vtkTranslucencyOption> options{
    { "NodeCount", "nodes", Kind::Integer, 16, LeastNodes, MostNodes, {},
      "nodes of the visibility function; 8 is hard to tell from exact, 16 safer for hair and smoke",
      [this] { return this->GetNodeCount(); },
      [this](double value) { this->SetNodeCount(static_cast<int>(value)); } },
    { "NodeRemoval", "removal", Kind::Choice, Underestimate, 0, 2,
      { "underestimate", "overestimate", "mixed" },
      "how a full visibility function loses a node; underestimate looks best",
      [this] { return this->GetNodeRemoval(); },
      [this](double value) { this->SetNodeRemoval(static_cast<int>(value)); } },
    this->GetMemoryOption(), this->GetCriticalSectionOption()
  };
  for (const vtkTranslucencyOption& option : this->Superclass::GetOptions())
  {
    options.push_back(option);
  }
  return options;
}

//------------------------------------------------------------------------------
std::string vtkAdaptiveTransparencyPass::GetMissing(vtkOpenGLRenderWindow* window)
{
  const std::string missing = this->Superclass::GetMissing(window);
  return missing.empty() && this->Memory == Fixed ? this->GetMissingForCriticalSection(window) : missing;
}

//------------------------------------------------------------------------------
bool vtkAdaptiveTransparencyPass::RenderFixed(vtkTranslucencyFrame& frame)
{
  constexpr int wordsOfNode = 2; // Adaptive/Gather.glsl
  vtkTranslucencyFrame::Gathering gathering{ "Adaptive/Gather.glsl",
    { { "NODE_COUNT", std::to_string(this->NodeCount) }, { "NODE_REMOVAL", Removals[this->NodeRemoval] } }, 1 };
  gathering.Critical = true;
  const vtkTranslucencyFrame::Stage visibility;
  vtkTranslucencyFrame::Stage shading;
  shading.Number = 1;
  shading.Targets = &this->Colors;
  shading.Blend = vtkTranslucencyFrame::Blending::AddAndAttenuate;
  shading.Clear = { { 0, 0, 0, 1 } };
  return frame.UsePixels(this->Functions, this->NodeCount * wordsOfNode, this->Storage->GetMemoryLimit()) &&
    frame.UseTargets(this->Colors, { 4 }) && frame.Draw(gathering, visibility) && frame.Draw(gathering, shading) &&
    frame.Composite("Common/CompositeColors.glsl", {}, { { "gatheredColors", &this->Colors, 0 } });
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkAdaptiveTransparencyPass::GetTechniqueBytes()
{
  return this->Superclass::GetTechniqueBytes() + this->Functions.GetBytes() + this->Colors.GetBytes();
}

//------------------------------------------------------------------------------
void vtkAdaptiveTransparencyPass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Superclass::ReleaseTechniqueResources(contextAlive);
  this->Functions.Release(contextAlive);
  this->Colors.Release(contextAlive);
}

//------------------------------------------------------------------------------
bool vtkAdaptiveTransparencyPass::ResolveLists(vtkTranslucencyFrame& frame)
{
  // A list of no more fragments than nodes needs no compression: it is exact, and sorting it takes fewer steps.
  vtkTranslucencyFrame::Squares rest;
  if (!this->ResolveShortLists(frame, this->NodeCount, Technique, rest))
  {
    return false;
  }
  vtkTranslucencyFrame::Defines defines{ { "NODE_COUNT", std::to_string(this->NodeCount) },
    { "NODE_REMOVAL", Removals[this->NodeRemoval] }, { "EQUAL_DEPTHS", "0" },
    { "EQUAL_DEPTHS_LEVEL", LevelText(TechniqueMore) },
    { "UNFINISHED_LEVEL", LevelText(Long) } };
  if (!frame.Resolve("Adaptive/Resolve.glsl", defines, rest))
  {
    return false;
  }
  if (frame.IsLeftTo(TechniqueMore))
  {
    defines["EQUAL_DEPTHS"] = "1";
    const auto left = vtkTranslucencyFrame::Squares::LeftTo(TechniqueMore);
    if (!frame.Resolve("Adaptive/Resolve.glsl", defines, left))
    {
      return false;
    }
  }
  return this->ResolveLeftLists(frame);
}
