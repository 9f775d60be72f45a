// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Techniques without lists against pictures computed from their own theory, with 1 and 4 samples a pixel and under each
// critical section that the driver has. A technique more is a row more in Techniques().
#include "RenderTest.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <cmath>

namespace
{
using Reference::Fragment;
using Reference::Tail;

struct Technique
{
  std::string Name; // of the test
  std::string Technique;
  Settings Options;
  Compositor Compute;
  bool Locks;    // whether it has a critical section
  bool AnyOrder; // whether the order of drawing does not matter
};

void PrintTo(const Technique& value, std::ostream* os)
{
  *os << value.Name;
}

vtkSmartPointer<vtkTranslucencyPass> New(const Technique& technique, const Settings& more = {})
{
  Settings settings = technique.Options;
  settings.insert(settings.end(), more.begin(), more.end());
  return NewTechnique(technique.Technique, settings);
}

Technique Layers(const std::string& name, int layers, Tail tail)
{
  return { name + std::to_string(layers), name, { { "layers", std::to_string(layers) } },
    [=](const std::vector<Fragment>& fragments) { return Reference::CompositeLayers(fragments, layers, tail); }, true,
    tail != Tail::Merge };
}

Technique LayersOfBytes(const std::string& name, int layers, Tail tail)
{
  return { name + std::to_string(layers) + "Bytes", name,
    { { "layers", std::to_string(layers) }, { "color_format", "rgba8" } },
    [=](const std::vector<Fragment>& fragments) { return Reference::CompositeLayers(fragments, layers, tail, true); },
    false, tail != Tail::Merge };
}

// In fixed memory the fragment drawn first is inserted first, and transmittances take 16 bits.
Technique AdaptiveFixed(int nodes, const std::string& removal, Reference::Removal rule, bool corrected = true)
{
  return { "AdaptiveFixed" + std::to_string(nodes) + removal + (corrected ? "" : "Uncorrected"), "adaptive",
    { { "memory", "fixed" }, { "nodes", std::to_string(nodes) }, { "removal", removal },
      { "alpha_correction", corrected ? "on" : "off" } },
    [=](std::vector<Fragment> fragments)
    {
      std::reverse(fragments.begin(), fragments.end());
      return Reference::CompositeAdaptive(fragments, nodes, rule, corrected, 65535);
    },
    true, false };
}

Technique BucketSort()
{
  return { "PeelBucketSort", "peel", { { "method", "bucket-sort" } }, Reference::CompositeExact, true, true };
}

Technique Blended(const std::string& function, const std::function<double(double)>& weight)
{
  return { "WeightedBlended_" + function, "weighted", { { "method", "blended" }, { "weight_function", function } },
    [=](const std::vector<Fragment>& fragments) { return Reference::CompositeWeightedBlended(fragments, weight); },
    false, true };
}

// The distance for a depth of the analytic scenes, whose projection is parallel.
double Distance(double depth)
{
  return 0.1 + depth * (500 - 0.1);
}

double Clamped(double weight)
{
  return std::clamp(weight, 1e-2, 3e3);
}

std::vector<Technique> Techniques()
{
  using Reference::Removal;
  return { Layers("mlab", 1, Tail::Merge), Layers("mlab", 4, Tail::Merge), Layers("mlab", 32, Tail::Merge),
    Layers("kbuffer", 1, Tail::Drop), Layers("kbuffer", 8, Tail::Drop), Layers("hybrid", 1, Tail::Average),
    Layers("hybrid", 8, Tail::Average), LayersOfBytes("mlab", 4, Tail::Merge), LayersOfBytes("kbuffer", 16, Tail::Drop),
    LayersOfBytes("hybrid", 8, Tail::Average), AdaptiveFixed(1, "underestimate", Removal::Underestimate),
    AdaptiveFixed(8, "underestimate", Removal::Underestimate),
    AdaptiveFixed(16, "underestimate", Removal::Underestimate),
    AdaptiveFixed(16, "overestimate", Removal::Overestimate), AdaptiveFixed(23, "mixed", Removal::Mixed),
    AdaptiveFixed(64, "underestimate", Removal::Underestimate),
    AdaptiveFixed(8, "underestimate", Removal::Underestimate, false), BucketSort(),
    { "WeightedSum", "weighted", { { "method", "sum" } }, Reference::CompositeWeightedSum, false, true },
    { "WeightedAverage", "weighted", { { "method", "average" } }, Reference::CompositeWeightedAverage, false, true },
    Blended("equation7",
      [](double depth)
      {
        const double z = Distance(depth);
        return Clamped(10 / (1e-5 + std::pow(z / 5, 2) + std::pow(z / 200, 6)));
      }),
    Blended("equation8",
      [](double depth)
      {
        const double z = Distance(depth);
        return Clamped(10 / (1e-5 + std::pow(z / 10, 3) + std::pow(z / 200, 6)));
      }),
    Blended("equation9", [](double depth) { return Clamped(0.03 / (1e-5 + std::pow(Distance(depth) / 200, 4))); }),
    Blended("equation10", [](double depth) { return std::max(1e-2, 3e3 * std::pow(1 - depth, 3)); }) };
}

// Those of which a member is true.
std::vector<Technique> Techniques(bool Technique::*is)
{
  std::vector<Technique> techniques = Techniques();
  techniques.erase(
    std::remove_if(techniques.begin(), techniques.end(), [is](const Technique& one) { return !(one.*is); }),
    techniques.end());
  return techniques;
}

struct Scene
{
  std::string Name;
  std::function<AnalyticScene()> New;
};

// Not deeper: half floats in the layers are rounded with each merging.
std::vector<Scene> Scenes()
{
  return { { "Layers3", [] { return RandomLayers(100, 80, 1, 3, 0.2, 0.8).Shrunk(5); } },
    { "Layers30", [] { return RandomLayers(100, 80, 2, 30, 0.02, 0.8).Shrunk(5); } },
    { "Layers300", [] { return RandomLayers(60, 40, 3, 300, 0.02, 0.3).Shrunk(5); } },
    { "Mosaic64", [] { return RandomMosaic(100, 80, 6, 64, 0.02, 0.3).Shrunk(5); } } };
}

constexpr double Bound = 2; // of 255: the framebuffer rounds three times, and fragments or layers are rounded, too
}

class TestTechniques
  : public RenderTest
  , public testing::WithParamInterface<Technique>
{
};

//------------------------------------------------------------------------------
TEST_P(TestTechniques, AreAsComputed)
{
  for (const Scene& scene : Scenes())
  {
    SCOPED_TRACE(scene.Name);
    const AnalyticScene made = scene.New();
    const Picture computed = made.Compute(GetParam().Compute);
    for (int samples : { 0, 4 })
    {
      SCOPED_TRACE(samples);
      const auto pass = New(GetParam());
      View view(made, samples);
      view.SetPass(pass);
      const PictureDifference difference = Compare(view.Render(), computed);
      EXPECT_LE(difference.Largest, Bound) << difference;
      EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
      EXPECT_GT(pass->GetStatistics()->GetBytes(), made.Width * made.Height);
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(TestTechniques, BuildNoShaderAgain)
{
  const AnalyticScene scene = RandomLayers(60, 40, 2, 10, 0.02, 0.8);
  for (int samples : { 0, 4 })
  {
    const auto pass = New(GetParam());
    View view(scene, samples);
    view.SetPass(pass);
    const Picture first = view.Render();
    EXPECT_GT(pass->GetStatistics()->GetShaderBuilds(), 0);
    const vtkTypeInt64 bytes = pass->GetStatistics()->GetBytes();
    EXPECT_EQ(Compare(first, view.Render()).Largest, 0);
    EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
    EXPECT_EQ(pass->GetStatistics()->GetBytes(), bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Matrix, TestTechniques, testing::ValuesIn(Techniques()), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestAnyOrder = TestTechniques;

TEST_P(TestAnyOrder, GivesTheSamePicture)
{
  const AnalyticScene scene = RandomLayers(200, 150, 2, 30, 0.02, 0.8);
  const auto pass = New(GetParam());
  const PictureDifference difference = Compare(Draw(scene, pass), Draw(scene.Reversed(), pass));
  EXPECT_LE(difference.Largest, 1) << difference; // sums are rounded in another order
}

INSTANTIATE_TEST_SUITE_P(Matrix, TestAnyOrder, testing::ValuesIn(Techniques(&Technique::AnyOrder)),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestSpinLock = TestTechniques;

TEST_P(TestSpinLock, GivesTheSamePictureAsWithout)
{
  const AnalyticScene scene = RandomLayers(200, 150, 2, 30, 0.02, 0.8);
  for (int samples : { 0, 4 })
  {
    View view(scene, samples);
    view.SetPass(New(GetParam(), { { "critical_section", "none" } }));
    const Picture alone = view.Render();
    if (!KeepsDrawOrder(view))
    {
      GTEST_SKIP() << "the driver has no order to compare with";
    }
    view.SetPass(New(GetParam(), { { "critical_section", "spinlock" } }));
    EXPECT_EQ(Compare(alone, view.Render()).Largest, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Matrix, TestSpinLock, testing::ValuesIn(Techniques(&Technique::Locks)),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestCriticalSection = RenderTest;

TEST_F(TestCriticalSection, ThatTheDriverLacksFallsBack)
{
  const AnalyticScene scene = RandomLayers(60, 40, 2, 10, 0.02, 0.8);
  for (const Technique& technique : { Layers("mlab", 4, Tail::Merge),
         AdaptiveFixed(16, "underestimate", Reference::Removal::Underestimate), BucketSort() })
  {
    const auto pass = New(technique, { { "critical_section", "interlock" } });
    View view(scene);
    view.SetPass(pass);
    const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
    const std::vector<std::string> messages = TakeMessages();
    if (pass->GetMissing(vtkOpenGLRenderWindow::SafeDownCast(view.Window)).empty())
    {
      EXPECT_TRUE(messages.empty());
      continue;
    }
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("GL_ARB_fragment_shader_interlock"), std::string::npos) << messages[0];
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
    EXPECT_LE(difference.Largest, 3) << difference;
  }
}

//------------------------------------------------------------------------------
using TestPixelMemory = RenderTest;

TEST_F(TestPixelMemory, InTilesGivesTheSamePicture)
{
  const AnalyticScene scene = RandomLayers(100, 75, 2, 20, 0.02, 0.8);
  const Technique mlab = Layers("mlab", 8, Tail::Merge);
  const Technique fixed = AdaptiveFixed(8, "underestimate", Reference::Removal::Underestimate);
  for (const Technique& technique : { mlab, fixed, BucketSort() })
  {
    for (int samples : { 0, 4 })
    {
      const auto pass = New(technique);
      View view(scene, samples);
      view.SetPass(pass);
      const Picture whole = view.Render();
      EXPECT_EQ(pass->GetStatistics()->GetTiles(), 1);
      for (const char* limit : { "0.5", "0.25", "0.06" })
      {
        EXPECT_TRUE(pass->SetOption("memory_limit", limit));
        EXPECT_EQ(Compare(whole, view.Render()).Largest, 0) << technique.Name << " " << samples << " " << limit;
      }
      EXPECT_GT(pass->GetStatistics()->GetTiles(), 1);
      EXPECT_TRUE(pass->SetOption("memory_limit", "0"));
      EXPECT_EQ(Compare(whole, view.Render()).Largest, 0);
      EXPECT_EQ(pass->GetStatistics()->GetTiles(), 1);
    }
  }
}

//------------------------------------------------------------------------------
// Records in colours that fragments fetch are those in buffers, without their counts or with the sums that are else
// blended.
TEST_F(TestPixelMemory, IsLessWhereFragmentsFetchIt)
{
  const AnalyticScene scene = RandomLayers(100, 75, 2, 20, 0.02, 0.8);
  const struct
  {
    Technique Drawn;
    bool Transmitting;
    vtkTypeInt64 Bytes; // a pixel, in colours
  } cases[] = { { Layers("mlab", 1, Tail::Merge), false, 16 }, { Layers("mlab", 4, Tail::Merge), false, 48 },
    { Layers("kbuffer", 8, Tail::Drop), false, 96 }, { Layers("hybrid", 4, Tail::Average), false, 68 },
    { Layers("hybrid", 8, Tail::Average), false, 116 }, { LayersOfBytes("mlab", 4, Tail::Merge), false, 32 },
    { LayersOfBytes("hybrid", 8, Tail::Average), false, 84 }, { Layers("mlab", 4, Tail::Merge), true, 64 },
    { Layers("hybrid", 4, Tail::Average), true, 100 }, { LayersOfBytes("kbuffer", 10, Tail::Drop), true, 120 },
    { AdaptiveFixed(8, "underestimate", Reference::Removal::Underestimate), false, 72 },
    { AdaptiveFixed(16, "mixed", Reference::Removal::Mixed), false, 120 } };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.Drawn.Name + (one.Transmitting ? " transmitting" : ""));
    const auto pass = New(one.Drawn);
    View view(one.Transmitting ? scene.Transmitting(3) : scene);
    view.SetPass(pass);
    const Picture drawn = view.Render();
    const vtkTypeInt64 bytes = pass->GetStatistics()->GetBytes();
    EXPECT_TRUE(pass->SetOption("critical_section", "spinlock"));
    const Picture locked = view.Render();
    const vtkTypeInt64 lockedBytes = pass->GetStatistics()->GetBytes();
    if (KeepsDrawOrder(view))
    {
      EXPECT_EQ(Compare(drawn, locked).Largest, 0);
    }
    const auto capabilities = vtkTranslucencyCapabilities::Probe(vtkOpenGLRenderWindow::SafeDownCast(view.Window));
    if (capabilities.MissingForFetch.empty())
    {
      constexpr vtkTypeInt64 besides = 100; // for the frame
      EXPECT_GE(bytes, one.Bytes * scene.Width * scene.Height);
      EXPECT_LE(bytes, one.Bytes * scene.Width * scene.Height + besides);
      EXPECT_GE(lockedBytes, bytes + 4 * scene.Width * scene.Height); // the locks
    }
    EXPECT_TRUE(pass->SetOption("critical_section", "auto"));
    EXPECT_EQ(Compare(drawn, view.Render()).Largest, 0);
    EXPECT_EQ(pass->GetStatistics()->GetBytes(), bytes); // buffers are not kept besides
    const auto buffered = New(one.Drawn, { { "critical_section", "spinlock" } });
    view.SetPass(buffered);
    view.Render();
    EXPECT_EQ(lockedBytes, buffered->GetStatistics()->GetBytes()); // nor colours
  }
}

//------------------------------------------------------------------------------
TEST_F(TestPixelMemory, BelowOnePixelIsAnErrorAndFallsBack)
{
  const AnalyticScene scene = RandomLayers(60, 40, 2, 10, 0.02, 0.8);
  const auto pass = New(Layers("mlab", 8, Tail::Merge), { { "memory_limit", "0.001" } });
  const PictureDifference difference = Compare(Draw(scene, pass), scene.Compute(Reference::CompositeExact));
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("memory limit of 1048 bytes"), std::string::npos) << messages[0];
  EXPECT_LE(difference.Largest, 3) << difference;
}
