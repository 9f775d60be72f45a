// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chains.h"

#include <vtkCameraPass.h>
#include <vtkDepthOfFieldPass.h>
#include <vtkEDLShading.h>
#include <vtkFramebufferPass.h>
#include <vtkGaussianBlurPass.h>
#include <vtkHiddenLineRemovalPass.h>
#include <vtkImageProcessingPass.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkSobelGradientMagnitudePass.h>
#include <vtkToneMappingPass.h>

#include <algorithm>
#include <iterator>
#include <ostream>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSequencePass> Sequence(const std::vector<vtkRenderPass*>& passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (vtkRenderPass* pass : passes)
  {
    collection->AddItem(pass);
  }
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(collection);
  return sequence;
}

namespace
{
using Pass = vtkSmartPointer<vtkRenderPass>;

vtkSmartPointer<vtkRenderStepsPass> Steps(vtkRenderPass* translucent)
{
  auto steps = vtkSmartPointer<vtkRenderStepsPass>::New();
  steps->SetTranslucentPass(translucent);
  return steps;
}

/// A pass that draws what another one gives it.
struct Wrapper
{
  const char* Name;
  Pass (*Wrap)(vtkRenderPass* inner);
  double Bound;
};

template <typename Type>
Pass Wrap(vtkRenderPass* inner)
{
  return Around<Type>(inner);
}

Pass WrapSSAO(vtkRenderPass* inner)
{
  auto pass = vtkSmartPointer<vtkSSAOPass>::New();
  pass->SetRadius(0.5);
  pass->SetKernelSize(16);
  pass->SetDelegatePass(inner);
  return pass;
}

Pass WrapPanorama(vtkRenderPass* inner)
{
  auto pass = vtkSmartPointer<vtkPanoramicProjectionPass>::New();
  pass->SetCubeResolution(32);
  pass->SetDelegatePass(inner);
  return pass;
}

const Wrapper Wrappers[] = {
  { "SSAA", Wrap<vtkSSAAPass>, 2 },
  { "SSAO", WrapSSAO, 2 },
  { "EDL", Wrap<vtkEDLShading>, 2 },
  { "ToneMapping", Wrap<vtkToneMappingPass>, 2 },
  { "DepthOfField", Wrap<vtkDepthOfFieldPass>, 2 },
  { "Blur", Wrap<vtkGaussianBlurPass>, 2 },
  { "Sobel", Wrap<vtkSobelGradientMagnitudePass>, 8 },
  { "FXAA", Wrap<vtkOpenGLFXAAPass>, 20 },
  { "Framebuffer", Wrap<vtkFramebufferPass>, 2 },
  { "Panorama", WrapPanorama, 2 },
};

Pass HiddenLines(vtkRenderPass* translucent)
{
  const auto steps = Steps(translucent);
  steps->SetOpaquePass(vtkNew<vtkHiddenLineRemovalPass>());
  return steps;
}

/// Translucent props receive shadows, as those do that are drawn with them.
Pass Shadows(vtkRenderPass* translucent)
{
  vtkNew<vtkShadowMapPass> shadows;
  shadows->SetOpaqueSequence(Sequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), translucent }));
  return Wrap<vtkCameraPass>(Sequence({ shadows->GetShadowMapBakerPass(), shadows }));
}
}

//------------------------------------------------------------------------------
void PrintTo(const Chain& chain, std::ostream* os)
{
  *os << chain.Name;
}

//------------------------------------------------------------------------------
std::vector<Chain> Chains()
{
  std::vector<Chain> chains{ { "HiddenLines", HiddenLines }, { "Shadows", Shadows } };
  const std::size_t count = std::size(Wrappers);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Wrapper& outer = Wrappers[i];
    const Wrapper& inner = Wrappers[(i + 1) % count];
    chains.push_back({ outer.Name, [outer](vtkRenderPass* pass) { return outer.Wrap(Steps(pass)); }, outer.Bound });
    if (outer.Wrap != WrapSSAO)
    {
      chains.push_back({ std::string(outer.Name) + "Over" + inner.Name,
        [outer, inner](vtkRenderPass* pass) { return outer.Wrap(inner.Wrap(Steps(pass))); },
        std::max(outer.Bound, inner.Bound), true });
    }
  }
  chains.push_back(
    { "SSAAOverShadows", [](vtkRenderPass* pass) { return Wrap<vtkSSAAPass>(Shadows(pass)); }, 2, true });
  chains.push_back({ "SSAOOverHiddenLines", [](vtkRenderPass* pass) { return WrapSSAO(HiddenLines(pass)); }, 2, true });
  return chains;
}
