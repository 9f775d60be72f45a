// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// What depends on the order of drawing and what must not: reversed drawing, equal depths, very deep pixels.
//
// 5,000 fragments in a pixel are what the module promises to be right at least; 100,000 are more than the rounds after
// which some drivers end a loop.
#include "RenderTest.h"

#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyStatistics.h>

#include <vtksys/SystemTools.hxx>

namespace
{
using Reference::Removal;

vtkSmartPointer<vtkABufferPass> NewExact(int resolve)
{
  auto pass = vtkSmartPointer<vtkABufferPass>::New();
  pass->SetResolve(resolve);
  return pass;
}

/// Rectangles at one depth, overlapping in steps so that each pixel holds another number of them.
AnalyticScene EqualDepths(int count)
{
  AnalyticScene scene;
  scene.Width = 200;
  scene.Height = 40;
  scene.Background = { { 1, 1, 1 } };
  for (int i = 0; i < count; ++i)
  {
    const Reference::Color color{ { (i % 3) / 2.0, (i % 5) / 4.0, (i % 2) / 1.0 } };
    scene.Translucent.push_back({ { 4 * i, 0, scene.Width, scene.Height, 0.25, color, 0.125 + 0.5 * (i % 4) / 4 } });
  }
  return scene;
}

/// Very many fragments in each of a few pixels, and a scene of ordinary depth around them.
AnalyticScene DeepPixels(int count)
{
  AnalyticScene scene = RandomLayers(100, 80, 21, 40, 0.02, 0.3);
  Layer deep;
  for (int i = 0; i < count; ++i)
  {
    const int shuffled = static_cast<int>(i * 24977LL % count); // a prime, so that each number comes once
    const Reference::Color color{ { (shuffled % 256) / 255.0, (shuffled % 100) / 255.0, (i % 200) / 255.0 } };
    deep.push_back({ 37, 41, 45, 43, 0.125 + 0.25 * shuffled / 131072, color, (1 + i % 2) / 255.0 });
  }
  scene.Translucent.insert(scene.Translucent.begin() + 20, deep);
  return scene;
}
}

class TestOrderOfExact
  : public RenderTest
  , public testing::WithParamInterface<int>
{
};

//------------------------------------------------------------------------------
TEST_P(TestOrderOfExact, DrawsTheSameBitsInReversedOrder)
{
  for (const AnalyticScene& scene : { RandomLayers(400, 300, 3, 300, 0.02, 0.3).Shrunk(5),
         RandomLayers(80, 60, 5, 1200, 0.005, 0.05).Shrunk(5), RandomLayers(100, 80, 7, 20, 0.02, 0.8) })
  {
    const Picture drawn = Draw(scene, NewExact(GetParam()));
    EXPECT_EQ(Compare(drawn, Draw(scene.Reversed(), NewExact(GetParam()))).Largest, 0);
  }
}

//------------------------------------------------------------------------------
TEST_P(TestOrderOfExact, PutsTheLaterDrawnInFrontAtEqualDepth)
{
  for (const AnalyticScene& scene : { EqualDepths(2), EqualDepths(40), EqualDepths(40).Reversed() })
  {
    View view(scene);
    view.SetPass(NewExact(GetParam()));
    const Picture drawn = view.Render();
    if (!KeepsDrawOrder(view))
    {
      GTEST_SKIP() << "the driver does not keep the order of drawing";
    }
    const PictureDifference difference = Compare(drawn, scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, 1.5) << difference;
  }
  const auto lookDifferent = Compare(
    EqualDepths(40).Compute(Reference::CompositeExact), EqualDepths(40).Reversed().Compute(Reference::CompositeExact));
  EXPECT_GT(lookDifferent.Largest, 20) << "the scene does not tell the orders apart";
}

//------------------------------------------------------------------------------
TEST_P(TestOrderOfExact, DrawsEqualDepthsTheSameInEachRun)
{
  const AnalyticScene scene = EqualDepths(40);
  const Picture first = Draw(scene, NewExact(GetParam()));
  for (int run = 0; run < 3; ++run)
  {
    EXPECT_EQ(Compare(first, Draw(scene, NewExact(GetParam()))).Largest, 0);
  }
}

//------------------------------------------------------------------------------
TEST_P(TestOrderOfExact, DrawsEqualDepthsTheSameInReversedOrderIfNoneIsKept)
{
  View view(EqualDepths(40));
  view.SetPass(NewExact(GetParam()));
  const Picture drawn = view.Render();
  if (KeepsDrawOrder(view))
  {
    GTEST_SKIP() << "the driver keeps the order of drawing";
  }
  EXPECT_EQ(Compare(drawn, Draw(EqualDepths(40).Reversed(), NewExact(GetParam()))).Largest, 0);
}

//------------------------------------------------------------------------------
TEST_P(TestOrderOfExact, LosesNothingOfDeepPixels)
{
  for (int count : { 5000, 100000 })
  {
    const AnalyticScene scene = DeepPixels(count);
    View view(scene);
    const auto pass = NewExact(GetParam());
    view.SetPass(pass);
    const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, 1.5) << count << ": " << difference;
    EXPECT_GE(pass->GetStatistics()->GetDeepestPixel(), count);
  }
}

INSTANTIATE_TEST_SUITE_P(Resolve, TestOrderOfExact,
  testing::Values(vtkABufferPass::Recursive, vtkABufferPass::Iterative),
  [](const auto& info) { return info.param == vtkABufferPass::Recursive ? "Recursive" : "Iterative"; });

//------------------------------------------------------------------------------
using TestOrderOfTheEnvironment = RenderTest;

TEST_F(TestOrderOfTheEnvironment, ThatIsNoneIsToldAndTheDriversOwnIsTaken)
{
  const char* name = "TRANSLUCENCY_DRAW_ORDER";
  std::string before;
  const bool given = vtksys::SystemTools::GetEnv(name, before);
  vtksys::SystemTools::PutEnv(std::string(name) + "=random");
  View view(EqualDepths(40));
  view.SetPass(NewExact(vtkABufferPass::Recursive));
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  const bool kept = KeepsDrawOrder(view);
  TakeMessages();
  vtksys::SystemTools::UnPutEnv(name);
  EXPECT_EQ(kept, KeepsDrawOrder(view));
  if (given)
  {
    vtksys::SystemTools::PutEnv(std::string(name) + "=" + before);
  }
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("TRANSLUCENCY_DRAW_ORDER is 'random', expected 'any'"), std::string::npos) << messages[0];
}

//------------------------------------------------------------------------------
TEST(TestOrderOfTheDriver, IsPromisedByRasterizersThemselvesOnly)
{
  for (const char* renderer : { "llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe" })
  {
    EXPECT_TRUE(vtkTranslucencyCapabilities::IsRasterizer(renderer)) << renderer;
  }
  for (const char* renderer : { "zink Vulkan 1.4(llvmpipe (LLVM 21.1.8, 256 bits) (MESA_LLVMPIPE))",
         "virgl (llvmpipe (LLVM 15.0.7, 256 bits))", "NVIDIA GeForce GTX 1080/PCIe/SSE2", "" })
  {
    EXPECT_FALSE(vtkTranslucencyCapabilities::IsRasterizer(renderer)) << renderer;
  }
}

//------------------------------------------------------------------------------
class TestOrderOfAdaptive
  : public RenderTest
  , public testing::WithParamInterface<Removal>
{
};

TEST_P(TestOrderOfAdaptive, IsExactWithEnoughNodes)
{
  AnalyticScene scene = EqualDepths(16);
  for (const Layer& layer : RandomLayers(200, 40, 8, 16, 0.02, 0.8).Translucent)
  {
    scene.Translucent.push_back(layer);
  }
  View view(scene);
  view.SetPass(NewAdaptive(32, GetParam()));
  const Picture drawn = view.Render();
  if (!KeepsDrawOrder(view))
  {
    GTEST_SKIP() << "the driver does not keep the order of drawing";
  }
  const PictureDifference difference = Compare(drawn, scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, 1.5) << difference;
}

//------------------------------------------------------------------------------
TEST_P(TestOrderOfAdaptive, LosesNothingOfDeepPixels)
{
  const AnalyticScene scene = DeepPixels(5000);
  View view(scene);
  const auto pass = NewAdaptive(16, GetParam());
  view.SetPass(pass);
  const Picture drawn = view.Render();
  EXPECT_GE(pass->GetStatistics()->GetDeepestPixel(), 5000);
  if (!KeepsDrawOrder(view))
  {
    GTEST_SKIP() << "the driver inserts fragments in an order of its own";
  }
  const PictureDifference difference =
    Compare(drawn, scene.RoundedToHalf().Compute(AdaptiveCompositor(16, GetParam())));
  EXPECT_LE(difference.Largest, 2) << difference;
}

INSTANTIATE_TEST_SUITE_P(
  Removal, TestOrderOfAdaptive, testing::Values(Removal::Underestimate, Removal::Overestimate, Removal::Mixed));

//------------------------------------------------------------------------------
// 64 fragments a pixel, uniform in depth, colour and opacity: nothing worse is drawn in practice.
struct WorstCaseBound
{
  int NodeCount;
  double Rmse;
};

class TestWorstCase
  : public RenderTest
  , public testing::WithParamInterface<WorstCaseBound>
{
};

TEST_P(TestWorstCase, StaysWithinItsBound)
{
  const AnalyticScene scene = RandomMosaic(400, 300, 9, 64, 0.02, 0.3).Shrunk(5);
  const Picture exact = scene.Compute(Reference::CompositeExact);
  const Picture drawn = Draw(scene, NewAdaptive(GetParam().NodeCount, Removal::Underestimate));
  const double rmse = Compare(drawn, exact).RootMeanSquare;
  RecordProperty("rmse", std::to_string(rmse));
  EXPECT_LE(rmse, GetParam().Rmse);
}

INSTANTIATE_TEST_SUITE_P(Adaptive, TestWorstCase,
  testing::Values(WorstCaseBound{ 16, 0.025 }, WorstCaseBound{ 32, 0.006 }),
  [](const auto& info) { return "Nodes" + std::to_string(info.param.NodeCount); });
