// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Techniques against computed pictures: every technique with every format of fragments on every scene that is not too
// much for it. A case more is a row more in Techniques(), Formats() or Scenes().
#include "RenderTest.h"

#include <vtkFragmentStorage.h>

#include <algorithm>
#include <cmath>

namespace
{
using Reference::Removal;

struct Technique
{
  std::string Name;
  std::function<vtkSmartPointer<vtkFragmentListPass>()> New;
  Compositor Compute;
  double Bound;          // what it may differ from the picture computed for the fragments as stored, in units of 1/255
  bool Exact;            // that picture is the true one, but for the rounding of fragments
  double MostOperations; // that a test may take, as pixels times fragments squared
};

struct Format
{
  std::string Name;
  int Value;
  AnalyticScene (AnalyticScene::*Round)() const;
};

struct Scene
{
  std::string Name;
  std::function<AnalyticScene()> New;
  double HalfFloatBound; // what an exact picture may differ from the true one, in units of 1/255
  double BytesBound;     // the same with fragments in bytes; 0 if the opacities are too small for that
};

struct Case
{
  Technique By;
  Format In;
  Scene Of;

  std::string GetName() const { return this->Of.Name + this->By.Name + this->In.Name; }
};

void PrintTo(const Case& value, std::ostream* os)
{
  *os << value.GetName();
}

constexpr double NoLimit = 1e30;

// A framebuffer of bytes rounds a picture by 0.5 where little of what is behind shows through. Where more does,
// blending in bytes rounds colour, transmittance and product.
constexpr double ShowsThrough = 1.5;

Technique Exact(int resolve, const std::string& name, double mostOperations)
{
  const auto create = [resolve]
  {
    auto pass = vtkSmartPointer<vtkABufferPass>::New();
    pass->SetResolve(resolve);
    return pass;
  };
  return { name, create, Reference::CompositeExact, 1, true, mostOperations };
}

Technique Adaptive(int nodeCount, Removal removal, const std::string& name)
{
  return { name + std::to_string(nodeCount), [=] { return NewAdaptive(nodeCount, removal); },
    AdaptiveCompositor(nodeCount, removal), 2, false, NoLimit };
}

Technique Paper(int nodeCount)
{
  const auto create = [nodeCount]
  {
    auto pass = NewAdaptive(nodeCount, Removal::Underestimate);
    pass->AlphaCorrectionOff();
    return pass;
  };
  return { "Paper" + std::to_string(nodeCount), create, AdaptiveCompositor(nodeCount, Removal::Underestimate, false), 2,
    false, NoLimit };
}

std::vector<Technique> Techniques()
{
  std::vector<Technique> techniques = {
    Exact(vtkABufferPass::Recursive, "Recursive", NoLimit),
    Exact(vtkABufferPass::Iterative, "Iterative", 2e10),
  };
  for (int nodeCount : { 4, 8, 16, 32 })
  {
    techniques.push_back(Adaptive(nodeCount, Removal::Underestimate, "Underestimate"));
    techniques.push_back(Adaptive(nodeCount, Removal::Overestimate, "Overestimate"));
    techniques.push_back(Adaptive(nodeCount, Removal::Mixed, "Mixed"));
  }
  techniques.push_back(Paper(8));
  return techniques;
}

std::vector<Format> Formats()
{
  return { { "HalfFloat", vtkFragmentStorage::HalfFloat, &AnalyticScene::RoundedToHalf },
    { "RGBA8", vtkFragmentStorage::RGBA8, &AnalyticScene::RoundedToBytes } };
}

std::vector<Scene> Scenes()
{
  return {
    { "Layers3", [] { return RandomLayers(400, 300, 1, 3, 0.2, 0.8); }, ShowsThrough, 2 },
    { "Layers30", [] { return RandomLayers(400, 300, 2, 30, 0.02, 0.8); }, ShowsThrough, 2 },
    { "Layers300", [] { return RandomLayers(400, 300, 3, 300, 0.02, 0.3).Shrunk(5); }, 1, 2 },
    { "Layers1200", [] { return RandomLayers(400, 300, 4, 1200, 0.005, 0.05).Shrunk(5); }, 1, 0 },
    { "Layers1200Small", [] { return RandomLayers(80, 60, 5, 1200, 0.005, 0.05); }, 1, 0 },
    { "Mosaic64", [] { return RandomMosaic(400, 300, 6, 64, 0.02, 0.3).Shrunk(5); }, 1, 1 },
  };
}

bool IsLegal(const Case& value, double operations)
{
  const bool bytes = value.In.Value == vtkFragmentStorage::RGBA8;
  return operations <= value.By.MostOperations && (!bytes || value.Of.BytesBound > 0);
}

std::vector<Case> Cases()
{
  std::vector<Case> cases;
  for (const Scene& scene : Scenes())
  {
    const AnalyticScene made = scene.New();
    const double operations = std::pow(static_cast<double>(made.Translucent.size()), 2) * made.Width * made.Height;
    for (const Technique& technique : Techniques())
    {
      for (const Format& format : Formats())
      {
        const Case candidate{ technique, format, scene };
        if (IsLegal(candidate, operations))
        {
          cases.push_back(candidate);
        }
      }
    }
  }
  return cases;
}
}

class TestAnalyticScenes
  : public RenderTest
  , public testing::WithParamInterface<Case>
{
};

//------------------------------------------------------------------------------
TEST_P(TestAnalyticScenes, IsAsComputed)
{
  const Case& now = GetParam();
  const AnalyticScene scene = now.Of.New();
  const auto pass = now.By.New();
  pass->GetStorage()->SetColorFormat(now.In.Value);
  View view(scene);
  view.SetPass(pass);
  const Picture drawn = view.Render();
  if (!now.By.Exact && !KeepsDrawOrder(view))
  {
    GTEST_SKIP() << "the driver inserts fragments in an order of its own";
  }

  const Picture ofTheStored = (scene.*now.In.Round)().Compute(now.By.Compute);
  const PictureDifference difference = Compare(drawn, ofTheStored);
  EXPECT_LE(difference.Largest, std::max(now.By.Bound, now.Of.HalfFloatBound)) << difference;
  RecordProperty("largest", std::to_string(difference.Largest));

  if (now.By.Exact)
  {
    const PictureDifference fromTruth = Compare(drawn, scene.Compute(now.By.Compute));
    const bool half = now.In.Value == vtkFragmentStorage::HalfFloat;
    EXPECT_LE(fromTruth.Largest, half ? now.Of.HalfFloatBound : now.Of.BytesBound) << fromTruth;
    RecordProperty("largestFromTruth", std::to_string(fromTruth.Largest));
  }
}

INSTANTIATE_TEST_SUITE_P(
  Matrix, TestAnalyticScenes, testing::ValuesIn(Cases()), [](const auto& info) { return info.param.GetName(); });
