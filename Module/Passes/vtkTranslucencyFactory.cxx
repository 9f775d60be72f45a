// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyFactory.h"

#include "vtkABufferPass.h"
#include "vtkAdaptiveTransparencyPass.h"
#include "vtkAdditiveTransparencyPass.h"
#include "vtkAutomaticTransparencyPass.h"
#include "vtkDepthPeelPass.h"
#include "vtkFourierOpacityPass.h"
#include "vtkHybridTransparencyPass.h"
#include "vtkKBufferPass.h"
#include "vtkMomentTransparencyPass.h"
#include "vtkMultiLayerAlphaBlendingPass.h"
#include "vtkOpacityShadowMapPass.h"
#include "vtkScreenDoorPass.h"
#include "vtkSortedTransparencyPass.h"
#include "vtkStochasticTransparencyPass.h"
#include "vtkWaveletTransparencyPass.h"
#include "vtkWeightedTransparencyPass.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStockPeelingPass.h"
#include "vtkTranslucencyChain.h"
#include "vtkTranslucencyFallback.h"
#include "vtkTranslucencyRenderStepsPass.h"
#include "vtkTranslucentPass.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTranslucencyFactory);

namespace
{
vtkRenderPass* NewDualDepthPeeling()
{
  auto* pass = vtkStockPeelingPass::New();
  pass->SetTranslucentPass(vtkSmartPointer<vtkTranslucentPass>::New());
  pass->SetMaximumNumberOfPeels(VTK_INT_MAX);
  pass->SetOcclusionRatio(0);
  return pass;
}

vtkRenderPass* NewOrderIndependentTranslucent()
{
  auto* pass = vtkOrderIndependentTranslucentPass::New();
  pass->SetTranslucentPass(vtkSmartPointer<vtkTranslucentPass>::New());
  return pass;
}

template <typename Pass>
vtkRenderPass* NewPass()
{
  return Pass::New();
}

struct Technique
{
  const char* Name;
  const char* Help;
  vtkRenderPass* (*New)();
};

const Technique Techniques[] = {
  { "exact", "A-buffer: every fragment, sorted and blended", NewPass<vtkABufferPass> },
  { "adaptive", "adaptive transparency: a visibility function of a few nodes a pixel",
    NewPass<vtkAdaptiveTransparencyPass> },
  { "peel", "depth peeling: layer by layer, in a drawing of the geometry each", NewPass<vtkDepthPeelPass> },
  { "mlab", "multi-layer alpha blending: the nearest layers of a pixel, and the rest merged into the last",
    NewPass<vtkMultiLayerAlphaBlendingPass> },
  { "kbuffer", "k-buffer: the nearest fragments of a pixel exactly, and no others", NewPass<vtkKBufferPass> },
  { "hybrid", "hybrid transparency: the nearest fragments of a pixel exactly, and the mean of the others behind them",
    NewPass<vtkHybridTransparencyPass> },
  { "stochastic", "stochastic transparency: visibility by random depth samples, right on average, with noise",
    NewPass<vtkStochasticTransparencyPass> },
  { "fourier", "Fourier opacity mapping: visibility from a Fourier series of absorbance, order does not matter",
    NewPass<vtkFourierOpacityPass> },
  { "shadowmap", "opacity shadow maps: visibility from absorbance in slices of equal depth, order does not matter",
    NewPass<vtkOpacityShadowMapPass> },
  { "wavelet", "wavelet transparency: visibility from absorbance in Haar wavelets, order does not matter",
    NewPass<vtkWaveletTransparencyPass> },
  { "moment", "moment transparency: visibility from moments of absorbance, order does not matter",
    NewPass<vtkMomentTransparencyPass> },
  { "weighted", "weighted sum, average or blended: one fast pass, order does not matter",
    NewPass<vtkWeightedTransparencyPass> },
  { "sorted", "blending in the order of depth, of objects or their polygons: right where they don't interlock",
    NewPass<vtkSortedTransparencyPass> },
  { "screendoor", "opaque surfaces with holes: no blending, order does not matter", NewPass<vtkScreenDoorPass> },
  { "additive", "surfaces that shine and hide nothing", NewPass<vtkAdditiveTransparencyPass> },
  { "auto", "the best of the others that stays within a budget of time and of memory",
    NewPass<vtkAutomaticTransparencyPass> },
  { "blend", "VTK's plain blending, in drawing order: wrong where surfaces overlap out of order",
    NewPass<vtkTranslucentPass> },
  { "vtk-oit", "VTK's order-independent pass: a weighted average, fast and approximate",
    NewOrderIndependentTranslucent },
  { "vtk-peel", "VTK's dual depth peeling, to the last layer but where opaque surfaces lie behind everything",
    NewDualDepthPeeling },
};

constexpr int TechniqueCount = static_cast<int>(sizeof(Techniques) / sizeof(Techniques[0]));

const Technique* Find(const std::string& name)
{
  std::string known;
  for (const Technique& technique : Techniques)
  {
    if (name == technique.Name)
    {
      return &technique;
    }
    known += (known.empty() ? "" : ", ") + std::string(technique.Name);
  }
  vtkGenericWarningMacro("there is no technique '" << name << "', expected one of: " << known);
  return nullptr;
}
}

//------------------------------------------------------------------------------
vtkTranslucencyPass* vtkTranslucencyNewFallback(bool storage)
{
  auto* pass = vtkDepthPeelPass::New();
  // Bucket sort takes fewer drawings, but where there is storage it would use what may just have failed.
  pass->SetMethod(storage ? vtkDepthPeelPass::Dual : vtkDepthPeelPass::BucketSort);
  return pass;
}

//------------------------------------------------------------------------------
int vtkTranslucencyFactory::GetNumberOfTechniques()
{
  return TechniqueCount;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyFactory::GetTechniqueName(int index)
{
  return index >= 0 && index < TechniqueCount ? Techniques[index].Name : "";
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyFactory::GetTechniqueHelp(int index)
{
  return index >= 0 && index < TechniqueCount ? Techniques[index].Help : "";
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkTranslucencyFactory::CreateTechnique(const std::string& name)
{
  const Technique* technique = Find(name);
  return technique ? technique->New() : nullptr;
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkTranslucencyFactory::Enable(vtkRenderer* renderer, const std::string& name)
{
  if (!renderer)
  {
    vtkGenericWarningMacro("the renderer is null, expected a vtkRenderer");
    return nullptr;
  }
  const auto technique = vtkSmartPointer<vtkRenderPass>::Take(CreateTechnique(name));
  return technique && vtkTranslucencyChain::Enable(renderer, technique) ? technique.Get() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFactory::Enable(vtkRenderer* renderer, vtkRenderPass* technique)
{
  if (!renderer || !technique)
  {
    vtkGenericWarningMacro("the " << (renderer ? "technique" : "renderer") << " is null, expected a "
                                  << (renderer ? "vtkRenderPass" : "vtkRenderer"));
    return false;
  }
  return vtkTranslucencyChain::Enable(renderer, technique);
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkTranslucencyFactory::GetTechnique(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkGenericWarningMacro("the renderer is null, expected a vtkRenderer");
    return nullptr;
  }
  return vtkTranslucencyChain::GetTechnique(renderer);
}

//------------------------------------------------------------------------------
void vtkTranslucencyFactory::Disable(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkGenericWarningMacro("the renderer is null, expected a vtkRenderer");
    return;
  }
  vtkTranslucencyChain::Disable(renderer);
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkTranslucencyFactory::CreateSteps(vtkRenderPass* technique)
{
  if (!technique)
  {
    vtkGenericWarningMacro("the technique is null, expected a vtkRenderPass");
    return nullptr;
  }
  auto* steps = vtkTranslucencyRenderStepsPass::New();
  steps->SetCameraPass(nullptr);
  steps->SetTranslucentPass(technique);
  if (auto* own = vtkTranslucencyPass::SafeDownCast(technique))
  {
    own->SetVolumetricPass(steps->GetVolumetricPass());
    steps->SetVolumetricPass(nullptr);
  }
  return steps;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyFactory::GetMissing(const std::string& name, vtkOpenGLRenderWindow* window)
{
  const auto pass = vtkSmartPointer<vtkRenderPass>::Take(CreateTechnique(name));
  auto* own = vtkTranslucencyPass::SafeDownCast(pass);
  return own ? own->GetMissing(window) : "";
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyFactory::GetMissing(const std::string& name, int major, int minor)
{
  const auto pass = vtkSmartPointer<vtkRenderPass>::Take(CreateTechnique(name));
  auto* own = vtkTranslucencyPass::SafeDownCast(pass);
  return own ? own->GetMissing(major, minor) : "";
}
VTK_ABI_NAMESPACE_END
