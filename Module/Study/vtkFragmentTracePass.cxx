// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFragmentTracePass.h"

#include "Common/Bindings.glsl"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyFrame.h"
#include "vtkTranslucencyStatistics.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFragmentTracePass);

namespace
{
using Fragment = vtkStorageSimulator::Fragment;

constexpr std::size_t TraceWords = 6; // see Shaders/Trace/Resolve.glsl

Fragment ToFragment(const unsigned int* words)
{
  float floats[TraceWords - 1];
  std::memcpy(floats, words + 1, sizeof(floats));
  return { static_cast<int>(words[0] & 0xffffu), static_cast<int>(words[0] >> 16), floats[0],
    { { floats[1], floats[2], floats[3], floats[4] } } };
}
}

//------------------------------------------------------------------------------
vtkFragmentTracePass::~vtkFragmentTracePass()
{
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkFragmentTracePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fragments: " << this->Fragments.size() << "\n";
}

//------------------------------------------------------------------------------
void vtkFragmentTracePass::RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass)
{
  this->Fragments.clear();
  this->Superclass::RenderTranslucent(state, volumetricPass);
  if (!this->GetStatistics()->GetFallback().empty())
  {
    this->Fragments.clear();
  }
  // Pixels come as the GPU has taken them, those of a pixel behind each other.
  std::stable_sort(this->Fragments.begin(), this->Fragments.end(),
    [](const Fragment& a, const Fragment& b) { return a.Y != b.Y ? a.Y < b.Y : a.X < b.X; });
}

//------------------------------------------------------------------------------
bool vtkFragmentTracePass::UseLists(vtkTranslucencyFrame& frame)
{
  if (!frame.IsComplete())
  {
    return true; // it will be gathered again
  }
  if (frame.GetSamples() > 1)
  {
    return frame.Fail("a pixel has " + std::to_string(frame.GetSamples()) +
      " samples, expected 1: fragments of several can't be traced");
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(frame.GetRenderer()->GetRenderWindow());
  const vtkTypeInt64 most = this->GetCapabilities(window).MaximumBlockBytes;
  const vtkTypeInt64 fragments = this->Storage->GetFragments();
  const vtkTypeInt64 bytes =
    (1 + fragments * static_cast<vtkTypeInt64>(TraceWords)) * static_cast<vtkTypeInt64>(sizeof(unsigned int));
  if (fragments > VTK_INT_MAX || bytes > most || !this->Copy.Reserve(bytes))
  {
    return frame.Fail("the driver has no memory for a trace of " + std::to_string(fragments) +
      " fragments of a tile; a memory limit makes tiles smaller");
  }
  this->Copy.Clear(sizeof(unsigned int));
  this->Copy.BindStorage(STORAGE_BINDING_READ_BACK);
  if (!frame.Resolve("Trace/Resolve.glsl", {}, {}, { { "traceRoom", static_cast<int>(fragments) } }))
  {
    return false;
  }
  std::vector<unsigned int> words(static_cast<std::size_t>(bytes) / sizeof(unsigned int));
  this->Copy.Download(words.data(), bytes);
  if (words[0] != fragments)
  {
    return frame.Fail("the lists have " + std::to_string(words[0]) + " fragments, expected the " +
      std::to_string(fragments) + " that were stored");
  }
  for (std::size_t word = 1; word < words.size(); word += TraceWords)
  {
    this->Fragments.push_back(ToFragment(words.data() + word));
  }
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkFragmentTracePass::GetTechniqueBytes()
{
  return this->Superclass::GetTechniqueBytes() + this->Copy.GetBytes();
}

//------------------------------------------------------------------------------
void vtkFragmentTracePass::ReleaseTechniqueResources(bool contextAlive)
{
  this->Superclass::ReleaseTechniqueResources(contextAlive);
  this->Copy.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
