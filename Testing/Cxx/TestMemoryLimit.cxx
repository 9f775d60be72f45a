// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// A limit on memory changes how often the scene is drawn, never the picture.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFragmentStorage.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>

namespace
{
struct Limited
{
  std::string Name;
  std::function<vtkSmartPointer<vtkFragmentListPass>()> New;
  int ColorFormat;
  double MiB;
};

void PrintTo(const Limited& value, std::ostream* os)
{
  *os << value.Name;
}

constexpr double MiB = 1024.0 * 1024.0;
}

class TestMemoryLimit
  : public RenderTest
  , public testing::WithParamInterface<Limited>
{
};

//------------------------------------------------------------------------------
TEST_P(TestMemoryLimit, ChangesNoPixel)
{
  const AnalyticScene scene = RandomLayers(400, 300, 13, 60, 0.02, 0.5);
  const auto free = GetParam().New();
  free->GetStorage()->SetColorFormat(GetParam().ColorFormat);
  const Picture whole = Draw(scene, free);
  EXPECT_EQ(free->GetStatistics()->GetTiles(), 1);

  View view(scene);
  const auto limited = GetParam().New();
  limited->GetStorage()->SetColorFormat(GetParam().ColorFormat);
  limited->GetStorage()->SetMemoryLimit(GetParam().MiB);
  view.SetPass(limited);
  for (int frame = 0; frame < 2; ++frame)
  {
    EXPECT_EQ(Compare(whole, view.Render()).Largest, 0) << "frame " << frame;
    EXPECT_GT(limited->GetStatistics()->GetTiles(), 1);
    EXPECT_EQ(limited->GetStatistics()->GetFragments(), free->GetStatistics()->GetFragments());
    EXPECT_LE(limited->GetStorage()->GetBytes(), GetParam().MiB * MiB);
  }
}

namespace
{
template <typename Pass>
vtkSmartPointer<vtkFragmentListPass> New()
{
  return vtkSmartPointer<Pass>::New();
}
}

INSTANTIATE_TEST_SUITE_P(Limits, TestMemoryLimit,
  testing::Values(Limited{ "ExactHalf1MiB", New<vtkABufferPass>, vtkFragmentStorage::HalfFloat, 1 },
    Limited{ "ExactBytes1MiB", New<vtkABufferPass>, vtkFragmentStorage::RGBA8, 1 },
    Limited{ "ExactHalf10MiB", New<vtkABufferPass>, vtkFragmentStorage::HalfFloat, 10 },
    Limited{ "ExactHalf50KiB", New<vtkABufferPass>, vtkFragmentStorage::HalfFloat, 0.05 },
    Limited{ "AdaptiveHalf1MiB", New<vtkAdaptiveTransparencyPass>, vtkFragmentStorage::HalfFloat, 1 },
    Limited{ "AdaptiveBytes1MiB", New<vtkAdaptiveTransparencyPass>, vtkFragmentStorage::RGBA8, 1 }),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestMemoryLimitChange = RenderTest;

TEST_F(TestMemoryLimitChange, TakesEffectInTheNextFrame)
{
  const AnalyticScene scene = RandomLayers(200, 150, 13, 60, 0.02, 0.5);
  View view(scene);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture whole = view.Render();
  // Too little for a fragment a pixel, and too little for all of them.
  for (double limit : { 0.3, 0.0, 2.0, 0.0, 10.0, 0.0 })
  {
    pass->GetStorage()->SetMemoryLimit(limit);
    EXPECT_EQ(Compare(whole, view.Render()).Largest, 0) << limit;
    EXPECT_EQ(pass->GetStatistics()->GetTiles() > 1, limit > 0) << limit;
  }
}

//------------------------------------------------------------------------------
// More than the 128 MiB that llvmpipe advertises; the same in tiles that fit into them.
TEST_F(TestMemoryLimitChange, BlocksAreAsLargeAsTheDriverCanAddress)
{
  const AnalyticScene scene = RandomLayers(800, 600, 13, 40, 0.02, 0.3);
  View view(scene);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture whole = view.Render();
  const auto block =
    vtkTranslucencyCapabilities::Probe(vtkOpenGLRenderWindow::SafeDownCast(view.Window)).MaximumBlockBytes;
  const bool fits = static_cast<double>(block) > 200 * MiB;
  EXPECT_EQ(pass->GetStatistics()->GetTiles() == 1, fits) << block;
  EXPECT_TRUE(!fits || pass->GetStorage()->GetBytes() > 200 * MiB) << pass->GetStorage()->GetBytes();
  pass->GetStorage()->SetMemoryLimit(120);
  EXPECT_EQ(Compare(whole, view.Render()).Largest, 0);
  EXPECT_GT(pass->GetStatistics()->GetTiles(), 1);
}

//------------------------------------------------------------------------------
// Impostors are tested against a copy of the opaque depth: it must be there each time that the geometry is drawn.
TEST_F(TestMemoryLimitChange, ImpostorsAreHiddenInEveryTile)
{
  View view(400, 300);
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(0, -200, 100); // the right half of the picture
  source->SetPoint1(200, -200, 100);
  source->SetPoint2(0, 200, 100);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> opaque;
  opaque->SetMapper(mapper);
  view.Renderer->AddActor(opaque);
  AddBall(view.Renderer, true, 0, 0, 0);
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(100);
  camera->SetPosition(0, 0, 500);
  camera->SetClippingRange(100, 1000);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture grown = view.Render();
  EXPECT_GT(pass->GetStatistics()->GetGeometryPasses(), 1);
  const auto half = [](const Picture& picture, int x) { return Crop(picture, x, 0, 200, 300); };
  const Picture hidden = half(grown, 200);
  EXPECT_EQ(
    std::count(hidden.Rgb.begin(), hidden.Rgb.end(), hidden.Rgb[0]), static_cast<std::ptrdiff_t>(hidden.Rgb.size()))
    << "the opaque plane is white";
  EXPECT_GT(Compare(half(grown, 0), hidden).RootMeanSquare, 0.1);

  const Picture whole = view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 1);
  EXPECT_EQ(Compare(grown, whole).Largest, 0);
  pass->GetStorage()->SetMemoryLimit(0.1);
  EXPECT_EQ(Compare(whole, view.Render()).Largest, 0);
  EXPECT_GT(pass->GetStatistics()->GetTiles(), 1);
}

//------------------------------------------------------------------------------
TEST_F(TestMemoryLimitChange, SmallerThanARowIsAnErrorAndFallsBack)
{
  const AnalyticScene scene = RandomLayers(400, 300, 13, 10, 0.02, 0.5);
  View view(scene);
  vtkNew<vtkABufferPass> pass;
  pass->GetStorage()->SetMemoryLimit(0.001);
  view.SetPass(pass);
  const Picture drawn = view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("MemoryLimit is 0.001 MiB, expected at least"), std::string::npos) << messages[0];
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
  const PictureDifference difference = Compare(drawn, scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, 4) << difference; // peeling accumulates in bytes

  view.Render();
  EXPECT_TRUE(TakeMessages().empty()) << "once is enough";
}
