// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Enabling a technique takes nothing away: the renderer's effects and the passes that it has or gets later stay, and
// disabling gives them back.
#include "Chains.h"
#include "GLState.h"
#include "RenderTest.h"
#include "Room.h"

#include <vtkCameraPass.h>
#include <vtkDefaultPass.h>
#include <vtkEDLShading.h>
#include <vtkFXAAOptions.h>
#include <vtkGaussianBlurPass.h>
#include <vtkLightsPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOverlayPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyPass.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumetricPass.h>

#include <algorithm>

namespace
{
/// VTK's renderer with plain blending, as it has it from release 9.5 on by UseOITOff: 9.1 always takes its weighted
/// average.
class BlendingRenderer : public vtkOpenGLRenderer
{
public:
  static BlendingRenderer* New();
  vtkTypeMacro(BlendingRenderer, vtkOpenGLRenderer);

  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase*) override
  {
    this->UpdateTranslucentPolygonalGeometry();
  }
};
vtkStandardNewMacro(BlendingRenderer);

struct Effect
{
  std::string Name;
  std::function<void(vtkRenderer*, bool)> Use;
};

void PrintTo(const Effect& effect, std::ostream* os)
{
  *os << effect.Name;
}

void UseSSAO(vtkRenderer* renderer, bool use)
{
  renderer->SetUseSSAO(use);
  renderer->SetSSAORadius(0.6);
  renderer->SetSSAOBias(0.01);
  renderer->SetSSAOKernelSize(24);
  renderer->SetSSAOBlur(true);
}

const Effect Effects[] = {
  { "FXAA", [](vtkRenderer* renderer, bool use) { renderer->SetUseFXAA(use); } },
  { "FXAAWithOptions",
    [](vtkRenderer* renderer, bool use)
    {
      renderer->SetUseFXAA(use);
      renderer->GetFXAAOptions()->SetSubpixelBlendLimit(0.1F);
    } },
  { "SSAO", UseSSAO },
  { "HiddenLines", [](vtkRenderer* renderer, bool use) { renderer->SetUseHiddenLineRemoval(use); } },
  { "SSAOAndFXAA",
    [](vtkRenderer* renderer, bool use)
    {
      UseSSAO(renderer, use);
      renderer->SetUseFXAA(use);
    } },
  { "HiddenLinesAndSSAO",
    [](vtkRenderer* renderer, bool use)
    {
      UseSSAO(renderer, use);
      renderer->SetUseHiddenLineRemoval(use);
    } },
};

class TestEffects
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Effect, int>>
{
};

class TestEffectsOfTechniques
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Effect, int>>
{
};

using TestEffectsOfPasses = RenderTest;

/// Of this module's own, that draw a single surface as blending does.
std::vector<std::string> TechniquesThatBlendOneSurface()
{
  std::vector<std::string> names = OwnTechniques();
  names.erase(
    std::remove_if(names.begin(), names.end(), [](const std::string& name) { return !BlendsOneSurface(name); }),
    names.end());
  return names;
}

/// A pass that nobody knows, which draws what is opaque.
class UnknownPass : public vtkRenderPass
{
public:
  static UnknownPass* New();
  vtkTypeMacro(UnknownPass, vtkRenderPass);
  void Render(const vtkRenderState* state) override { this->Inner->Render(state); }

private:
  UnknownPass() { this->Inner->SetDelegatePass(Sequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>() })); }
  vtkNew<vtkCameraPass> Inner;
};
vtkStandardNewMacro(UnknownPass);
}

//------------------------------------------------------------------------------
TEST_P(TestEffects, OfTheRendererAreThose)
{
  const auto& [effect, samples] = GetParam();
  Room stock(samples, vtkSmartPointer<BlendingRenderer>::New());
  if (VTKFailsIn(effect.Name, stock.Window))
  {
    GTEST_SKIP() << "VTK's FXAA fails in multi-sampled windows";
  }
  const Picture plain = stock.Render();
  effect.Use(stock.Renderer, true);
  const Picture expected = stock.Render();
  EXPECT_GT(Compare(plain, expected).Largest, 10) << "an effect that is seen";

  Room room(samples);
  const Picture before = room.Render();
  effect.Use(room.Renderer, true);
  const Picture beforeWithEffect = room.Render();
  vtkTranslucencyFactory::Enable(room.Renderer, "blend");
  EXPECT_EQ(Compare(room.Render(), expected).Largest, 0) << "set before";
  effect.Use(room.Renderer, false);
  EXPECT_EQ(Compare(room.Render(), plain).Largest, 0) << "not set any more";
  effect.Use(room.Renderer, true);
  EXPECT_EQ(Compare(room.Render(), expected).Largest, 0) << "set after";
  vtkTranslucencyFactory::Enable(room.Renderer, "vtk-oit");
  EXPECT_EQ(Compare(room.Render(), beforeWithEffect).Largest, 0) << "another technique: VTK's default";

  vtkTranslucencyFactory::Disable(room.Renderer);
  EXPECT_EQ(room.Renderer->GetPass(), nullptr);
  EXPECT_EQ(Compare(room.Render(), beforeWithEffect).Largest, 0);
  effect.Use(room.Renderer, false);
  EXPECT_EQ(Compare(room.Render(), before).Largest, 0);
}

INSTANTIATE_TEST_SUITE_P(Effects, TestEffects, testing::Combine(testing::ValuesIn(Effects), testing::Values(0, 4)),
  [](const auto& info) { return std::get<0>(info.param).Name + "Samples" + std::to_string(std::get<1>(info.param)); });

//------------------------------------------------------------------------------
TEST_P(TestEffectsOfTechniques, AreThoseOfTheRenderer)
{
  const auto& [effect, samples] = GetParam();
  Room stock(samples, vtkSmartPointer<BlendingRenderer>::New());
  stock.ShowOthers(false);
  if (VTKFailsIn(effect.Name, stock.Window))
  {
    GTEST_SKIP() << "VTK's FXAA fails in multi-sampled windows";
  }
  effect.Use(stock.Renderer, true);
  const Picture expected = stock.Render();
  Room room(samples);
  room.ShowOthers(false);
  effect.Use(room.Renderer, true);
  for (const std::string& name : TechniquesThatBlendOneSurface())
  {
    vtkTranslucencyFactory::Enable(room.Renderer, name);
    const PictureDifference difference = Compare(room.Render(), expected);
    EXPECT_LE(difference.RootMeanSquare, 0.004) << name << ": " << difference;
  }
}

INSTANTIATE_TEST_SUITE_P(Effects, TestEffectsOfTechniques,
  testing::Combine(testing::Values(Effects[0], Effects[2], Effects[3]), testing::Values(0, 4)),
  [](const auto& info) { return std::get<0>(info.param).Name + "Samples" + std::to_string(std::get<1>(info.param)); });

//------------------------------------------------------------------------------
// VTK draws no translucent props then: they come over the picture that it draws, and shadows fall on them.
TEST_F(TestEffectsOfPasses, ShadowsOfTheRendererHideNothing)
{
  for (int samples : { 0, 4 })
  {
    SCOPED_TRACE(samples);
    Room room(samples);
    room.ShowTranslucent(false);
    const Picture unshadowed = room.Render();
    const bool late = samples > 0 && IsZink(); // VTK's shadows are those of the frame before there
    const auto draw = [&room, late]
    {
      if (late)
      {
        room.Render();
      }
      return room.Render();
    };
    room.Renderer->UseShadowsOn();
    const Picture stock = draw();
    EXPECT_GT(Compare(unshadowed, stock).Largest, 10) << "a shadow that is seen";
    vtkTranslucencyFactory::Enable(room.Renderer, "blend");
    EXPECT_EQ(Compare(draw(), stock).Largest, 0);
    room.ShowTranslucent(true);
    room.ShowOthers(false);
    const Picture blended = draw();
    EXPECT_GT(Compare(blended, stock).RootMeanSquare, 0.05);
    for (const std::string& name : TechniquesThatBlendOneSurface())
    {
      vtkTranslucencyFactory::Enable(room.Renderer, name);
      const PictureDifference difference = Compare(draw(), blended);
      EXPECT_LE(difference.Largest, 2) << name << ": " << difference;
    }
    if (!VTKFailsIn("FXAA", room.Window))
    {
      room.Renderer->UseFXAAOn();
      room.Render();
    }
    vtkTranslucencyFactory::Disable(room.Renderer);
    room.Renderer->UseFXAAOff();
    EXPECT_EQ(Compare(draw(), stock).Largest, 0);
  }
}

//------------------------------------------------------------------------------
// In each chain: the technique is put where it belongs, and taken out again.
TEST_F(TestEffectsOfPasses, ThatARendererHasStay)
{
  auto chains = Chains();
  chains.push_back({ "Default", [](vtkRenderPass*) {
                      return Around<vtkCameraPass>(Sequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkDefaultPass>() }));
                    } });
  chains.push_back({ "Sequence",
    [](vtkRenderPass* pass)
    {
      return Around<vtkCameraPass>(Sequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), pass,
        vtkNew<vtkVolumetricPass>(), vtkNew<vtkOverlayPass>() }));
    } });
  for (const Chain& chain : chains)
  {
    if (chain.Nested)
    {
      continue;
    }
    SCOPED_TRACE(chain.Name);
    Room room(0);
    const auto pass = chain.Make(vtkNew<vtkTranslucentPass>());
    room.Renderer->SetPass(pass);
    room.Render(); // the camera has been set by then for passes that look at it first
    const Picture stock = room.Render();
    vtkTranslucencyFactory::Enable(room.Renderer, "blend");
    EXPECT_EQ(room.Renderer->GetPass(), pass);
    EXPECT_EQ(Compare(room.Render(), stock).Largest, 0);
    vtkTranslucencyFactory::Enable(room.Renderer, "additive");
    EXPECT_EQ(room.Renderer->GetPass(), pass);
    const Picture added = room.Render();
    EXPECT_GT(Compare(added, stock).Largest, 20) << "the technique that was asked for";
    EXPECT_EQ(Compare(room.Render(), added).Largest, 0);
    vtkTranslucencyFactory::Enable(room.Renderer, "blend");
    EXPECT_EQ(Compare(room.Render(), stock).Largest, 0);
    vtkTranslucencyFactory::Enable(room.Renderer, "additive");
    vtkTranslucencyFactory::Disable(room.Renderer);
    EXPECT_EQ(room.Renderer->GetPass(), pass);
    EXPECT_EQ(Compare(room.Render(), stock).Largest, 0);
  }
}

//------------------------------------------------------------------------------
// As toolkits do: chains come and go after the technique was enabled, and null follows the last.
TEST_F(TestEffectsOfPasses, ThatComeAndGoLeaveTheTechnique)
{
  Room room(0);
  const Picture stock = room.Render();
  vtkRenderPass* technique = vtkTranslucencyFactory::Enable(room.Renderer, "additive");
  const Picture alone = room.Render();
  EXPECT_GT(Compare(stock, alone).Largest, 20);
  vtkNew<vtkRenderStepsPass> steps;
  const vtkSmartPointer<vtkRenderPass> translucent = steps->GetTranslucentPass();
  const vtkSmartPointer<vtkRenderPass> volumes = steps->GetVolumetricPass();
  const auto camera = Around<vtkCameraPass>(Sequence({ steps }));
  const auto outline = Around<vtkEDLShading>(camera);
  room.Renderer->SetPass(outline);
  const Picture shaded = room.Render();
  EXPECT_GT(Compare(shaded, alone).Largest, 20);
  EXPECT_EQ(steps->GetTranslucentPass(), technique);
  EXPECT_EQ(vtkTranslucencyPass::SafeDownCast(technique)->GetVolumetricPass(), volumes);
  const auto samples = Around<vtkSSAAPass>(outline);
  room.Renderer->SetPass(samples);
  EXPECT_GT(Compare(room.Render(), shaded).Largest, 5);
  EXPECT_EQ(steps->GetTranslucentPass(), technique);
  room.Renderer->SetPass(outline);
  EXPECT_EQ(Compare(room.Render(), shaded).Largest, 0);
  room.Renderer->SetPass(nullptr);
  EXPECT_EQ(Compare(room.Render(), alone).Largest, 0);
  EXPECT_EQ(steps->GetTranslucentPass(), translucent) << "a pass that has gone is as it was";
  EXPECT_EQ(steps->GetVolumetricPass(), volumes);
  steps->SetTranslucentPass(nullptr);
  room.Renderer->SetPass(camera);
  EXPECT_EQ(Compare(room.Render(), alone).Largest, 0) << "steps that had no translucent pass";
  vtkTranslucencyFactory::Disable(room.Renderer);
  EXPECT_EQ(steps->GetTranslucentPass(), nullptr);
  room.Renderer->SetPass(nullptr);
  EXPECT_EQ(Compare(room.Render(), stock).Largest, 0);
  vtkTranslucencyFactory::Disable(room.Renderer);
  samples->ReleaseGraphicsResources(room.Window);
}

//------------------------------------------------------------------------------
// Steps, and then what is opaque with its shadows: what is translucent would be hidden by that.
TEST_F(TestEffectsOfPasses, ShadowsAfterStepsHideNothing)
{
  Room room(0);
  vtkTranslucencyFactory::Enable(room.Renderer, "weighted");
  room.Renderer->UseShadowsOn();
  const Picture expected = room.Render();
  room.Renderer->UseShadowsOff();
  const Picture unshadowed = room.Render();
  vtkNew<vtkRenderStepsPass> steps;
  const vtkSmartPointer<vtkRenderPass> translucent = steps->GetTranslucentPass();
  vtkNew<vtkShadowMapPass> shadows;
  const vtkSmartPointer<vtkRenderPass> opaque = shadows->GetOpaqueSequence();
  const auto sequence = Sequence({ steps, shadows->GetShadowMapBakerPass(), shadows });
  room.Renderer->SetPass(Around<vtkCameraPass>(sequence));
  EXPECT_EQ(Compare(room.Render(), expected).Largest, 0);
  sequence->GetPasses()->RemoveItem(shadows);
  EXPECT_EQ(Compare(room.Render(), unshadowed).Largest, 0);
  EXPECT_EQ(shadows->GetOpaqueSequence(), opaque);
  sequence->GetPasses()->AddItem(shadows);
  EXPECT_EQ(Compare(room.Render(), expected).Largest, 0);
  vtkTranslucencyFactory::Disable(room.Renderer);
  EXPECT_EQ(shadows->GetOpaqueSequence(), opaque);
  EXPECT_EQ(steps->GetTranslucentPass(), translucent);
}

//------------------------------------------------------------------------------
TEST_F(TestEffectsOfPasses, ThatHaveNoPlaceAreNamed)
{
  Room room(0);
  vtkNew<UnknownPass> unknown;
  const auto chain = Around<vtkSSAAPass>(unknown);
  room.Renderer->SetPass(chain);
  const Picture before = room.Render();
  vtkTranslucencyFactory::Enable(room.Renderer, "weighted");
  std::vector<std::string> said = TakeMessages();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("(vtkSSAAPass, UnknownPass): it is replaced"), std::string::npos) << said[0];
  const Picture drawn = room.Render();
  EXPECT_GT(Compare(drawn, before).RootMeanSquare, 0.05);
  room.Render();
  EXPECT_TRUE(TakeMessages().empty());
  vtkTranslucencyFactory::Disable(room.Renderer);
  EXPECT_EQ(room.Renderer->GetPass(), chain);
  EXPECT_EQ(Compare(room.Render(), before).Largest, 0);

  room.Renderer->SetPass(nullptr);
  vtkTranslucencyFactory::Enable(room.Renderer, "weighted");
  EXPECT_EQ(Compare(room.Render(), drawn).Largest, 0);
  room.Renderer->SetPass(chain);
  EXPECT_EQ(Compare(room.Render(), before).Largest, 0) << "what is set afterwards is left alone";
  room.Render();
  said = TakeMessages();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("(vtkSSAAPass, UnknownPass): they are drawn by it instead"), std::string::npos) << said[0];
  room.Renderer->SetPass(nullptr);
  EXPECT_EQ(Compare(room.Render(), drawn).Largest, 0);
}

//------------------------------------------------------------------------------
TEST_F(TestEffectsOfPasses, AreKeptWhenATechniqueIsExchanged)
{
  Room room(0);
  vtkTranslucencyFactory::Enable(room.Renderer, "weighted");
  vtkRenderPass* steps = room.Renderer->GetPass();
  const auto wrapped = Around<vtkGaussianBlurPass>(steps); // as programs do
  room.Renderer->SetPass(wrapped);
  const Picture blurred = room.Render();
  const auto given = NewTechnique("adaptive", { { "nodes", "8" } });
  vtkTranslucencyFactory::Enable(room.Renderer, given.Get());
  EXPECT_EQ(room.Renderer->GetPass(), wrapped);
  EXPECT_EQ(vtkRenderStepsPass::SafeDownCast(steps)->GetTranslucentPass(), given);
  EXPECT_GT(Compare(room.Render(), blurred).Largest, 2);
  vtkTranslucencyFactory::Enable(room.Renderer, "weighted");
  EXPECT_EQ(Compare(room.Render(), blurred).Largest, 0);
  vtkTranslucencyFactory::Disable(room.Renderer);
  EXPECT_EQ(room.Renderer->GetPass(), wrapped);
  room.Render();
  wrapped->ReleaseGraphicsResources(room.Window);

  room.Renderer->SetPass(given); // alone
  const Picture alone = room.Render();
  vtkTranslucencyFactory::Enable(room.Renderer, "weighted");
  EXPECT_GT(Compare(room.Render(), alone).Largest, 2);
  vtkTranslucencyFactory::Disable(room.Renderer);
  EXPECT_EQ(room.Renderer->GetPass(), given);
  EXPECT_EQ(Compare(room.Render(), alone).Largest, 0);
}

//------------------------------------------------------------------------------
// As the renderer's own pass a technique carries out its effects, too.
TEST_F(TestEffectsOfPasses, AreThereWithATechniqueAlone)
{
  Room room(0);
  UseSSAO(room.Renderer, true);
  room.Renderer->UseFXAAOn();
  vtkTranslucencyFactory::Enable(room.Renderer, "weighted");
  const Picture expected = room.Render();
  vtkTranslucencyFactory::Disable(room.Renderer);
  room.Renderer->SetPass(NewTechnique("weighted"));
  EXPECT_EQ(Compare(room.Render(), expected).Largest, 0);
}

//------------------------------------------------------------------------------
TEST_F(TestEffectsOfPasses, WithoutARendererIsAnError)
{
  vtkTranslucencyFactory::Enable(nullptr, NewTechnique("exact").Get());
  vtkTranslucencyFactory::Enable(vtkNew<vtkRenderer>(), static_cast<vtkRenderPass*>(nullptr));
  vtkTranslucencyFactory::Disable(nullptr);
  EXPECT_EQ(TakeMessages().size(), 3u);
}
