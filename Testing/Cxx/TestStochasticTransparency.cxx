// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Stochastic transparency against its theory: right on average, with the noise that the same method has on the CPU,
// exact where chance plays no part, the same in any order of drawing, and refined over frames as long as nothing
// changes.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCompositePolyDataMapper.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkStochasticTransparencyPass.h>
#include <vtkTransform.h>
#include <vtkTranslucencyOption.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{
using StochasticPass = vtkSmartPointer<vtkStochasticTransparencyPass>;

StochasticPass NewPass(int samples = 8, bool correction = true, int seed = 0)
{
  auto pass = StochasticPass::New();
  pass->SetDepthSamples(samples);
  pass->SetAlphaCorrection(correction);
  pass->SetSeed(seed);
  return pass;
}

/// Of dark colours over black: what noise adds does not reach white, and blending with what lies behind rounds nothing.
AnalyticScene DarkMosaic(int width, int height, int fragments)
{
  AnalyticScene scene = RandomMosaic(width, height, 11, fragments, 0.1, 0.7);
  for (Layer& layer : scene.Translucent)
  {
    for (Rectangle& rectangle : layer)
    {
      for (double& channel : rectangle.Rgb)
      {
        channel = std::floor(255 * channel / 3) / 255;
      }
    }
  }
  return scene;
}

/// The method on the CPU, once for a pixel.
class Simulation
{
public:
  Simulation(int samples, bool correction)
    : Samples(samples)
    , Correction(correction)
  {
  }

  Reference::Pixel operator()(const std::vector<Reference::Fragment>& fragments)
  {
    std::vector<double> depths(this->Samples, 1);
    std::vector<int> order(this->Samples);
    std::iota(order.begin(), order.end(), 0);
    for (const Reference::Fragment& fragment : fragments)
    {
      std::shuffle(order.begin(), order.end(), this->Random);
      const int count = static_cast<int>(fragment.Alpha * this->Samples + this->Unit(this->Random));
      for (int i = 0; i < count; ++i)
      {
        depths[order[i]] = std::min(depths[order[i]], fragment.Depth);
      }
    }
    Reference::Pixel pixel;
    double weights = 0;
    for (const Reference::Fragment& fragment : fragments)
    {
      const auto sees = [&](double depth) { return depth >= fragment.Depth; };
      const double weight = fragment.Alpha * std::count_if(depths.begin(), depths.end(), sees) / this->Samples;
      weights += weight;
      pixel.Transmittance *= 1 - fragment.Alpha;
      std::transform(pixel.Rgb.begin(), pixel.Rgb.end(), fragment.Rgb.begin(), pixel.Rgb.begin(),
        [weight](double sum, double channel) { return sum + weight * channel; });
    }
    for (double& channel : pixel.Rgb)
    {
      channel *= this->Correction ? (1 - pixel.Transmittance) / weights : 1;
    }
    return pixel;
  }

private:
  int Samples;
  bool Correction;
  std::mt19937 Random{ 7 };
  std::uniform_real_distribution<double> Unit{ 0, 1 };
};

/// The root mean square of the method's error, in all cells of a mosaic, and the mean of its error.
struct Error
{
  double RootMeanSquare;
  double Mean;
};

Error ExpectedError(const AnalyticScene& scene, int samples, bool correction)
{
  constexpr int Trials = 2000; // for each cell
  Simulation simulate(samples, correction);
  double squares = 0;
  double sum = 0;
  int count = 0;
  scene.Compute(
    [&](const std::vector<Reference::Fragment>& fragments)
    {
      const Reference::Pixel exact = Reference::CompositeExact(fragments);
      for (int trial = 0; trial < Trials; ++trial)
      {
        const Reference::Pixel simulated = simulate(fragments);
        for (int c = 0; c < 3; ++c)
        {
          const double error = simulated.Rgb[c] - exact.Rgb[c];
          squares += error * error;
          sum += error;
          ++count;
        }
      }
      return exact;
    });
  return { std::sqrt(squares / count), sum / count };
}

/// Of many seeds, channel by channel.
struct Statistic
{
  std::vector<double> Mean;
  std::vector<double> Variance;
};

Statistic DrawSeeds(const AnalyticScene& scene, vtkStochasticTransparencyPass* pass, int seeds, int windowSamples)
{
  View view(scene, windowSamples);
  view.SetPass(pass);
  Statistic statistic;
  for (int seed = 0; seed < seeds; ++seed)
  {
    pass->SetSeed(seed);
    const Picture picture = view.Render();
    statistic.Mean.resize(picture.Rgb.size(), 0);
    statistic.Variance.resize(picture.Rgb.size(), 0);
    for (std::size_t i = 0; i < picture.Rgb.size(); ++i)
    {
      statistic.Mean[i] += picture.Rgb[i];
      statistic.Variance[i] += picture.Rgb[i] * picture.Rgb[i];
    }
  }
  for (std::size_t i = 0; i < statistic.Mean.size(); ++i)
  {
    statistic.Mean[i] /= seeds;
    const double variance = statistic.Variance[i] / seeds - statistic.Mean[i] * statistic.Mean[i];
    statistic.Variance[i] = variance * seeds / (seeds - 1);
  }
  return statistic;
}

Picture DrawFrames(const AnalyticScene& scene, vtkStochasticTransparencyPass* pass, int frames)
{
  View view(scene);
  view.SetPass(pass);
  for (int frame = 1; frame < frames; ++frame)
  {
    view.Window->Render();
  }
  return view.Render();
}

Rectangle Whole(double depth, const Reference::Color& rgb, double alpha)
{
  return { 0, 0, 40, 30, depth, rgb, alpha };
}

AnalyticScene Layers(const std::vector<Rectangle>& rectangles)
{
  AnalyticScene scene;
  scene.Width = 40;
  scene.Height = 30;
  scene.Background = { { 0.2, 0.4, 0.6 } };
  for (const Rectangle& rectangle : rectangles)
  {
    scene.Translucent.push_back({ rectangle });
  }
  return scene;
}
}

using TestStochastic = RenderTest;

class TestStochasticSamples
  : public RenderTest
  , public testing::WithParamInterface<int>
{
};

//------------------------------------------------------------------------------
// Each channel's mean over the seeds lies within three standard errors of the exact one as often as Student's
// distribution says (99.6 % with 63 degrees of freedom), and the mean of all channels' errors within three of its own,
// which are much smaller.
TEST_P(TestStochasticSamples, AreRightOnAverageWithoutAlphaCorrection)
{
  constexpr int Seeds = 64;
  const AnalyticScene scene = DarkMosaic(80, 60, 12);
  const Picture exact = scene.Compute(Reference::CompositeExact);
  for (int windowSamples : { 0, 4 })
  {
    const Statistic drawn = DrawSeeds(scene, NewPass(GetParam(), false), Seeds, windowSamples);
    int far = 0;
    double error = 0;
    double variance = 0;
    for (std::size_t i = 0; i < exact.Rgb.size(); ++i)
    {
      const double rounding = 1.0 / 12; // of a byte, where all seeds may give the same
      const double standardError = std::sqrt((drawn.Variance[i] + rounding) / Seeds);
      far += std::abs(drawn.Mean[i] - exact.Rgb[i]) > 3 * standardError;
      error += drawn.Mean[i] - exact.Rgb[i];
      variance += drawn.Variance[i] / Seeds;
    }
    EXPECT_LE(far, 0.01 * exact.Rgb.size()) << windowSamples;
    // The three channels of a pixel may err together, pixels do not. Rounding errs by chance, but for that of the mean
    // of a window's samples.
    const double resolved = windowSamples > 1 ? 0.1 * exact.Rgb.size() : 0;
    EXPECT_LE(std::abs(error), 3 * std::sqrt(3 * variance) + resolved) << windowSamples;
    EXPECT_GT(std::sqrt(variance * Seeds / exact.Rgb.size()), 1) << "there is no noise to speak of";
  }
}

//------------------------------------------------------------------------------
TEST_P(TestStochasticSamples, HaveTheNoiseOfTheMethod)
{
  const AnalyticScene scene = DarkMosaic(160, 120, 12);
  const Picture exact = scene.Compute(Reference::CompositeExact);
  for (bool correction : { false, true })
  {
    SCOPED_TRACE(correction ? "with alpha correction" : "without");
    const Error expected = ExpectedError(scene, GetParam(), correction);
    const Picture drawn = Draw(scene, NewPass(GetParam(), correction));
    double mean = 0;
    for (std::size_t i = 0; i < drawn.Rgb.size(); ++i)
    {
      mean += (drawn.Rgb[i] - exact.Rgb[i]) / (255.0 * drawn.Rgb.size());
    }
    const double rounded = std::hypot(expected.RootMeanSquare, 1 / (255 * std::sqrt(12.0)));
    EXPECT_NEAR(Compare(drawn, exact).RootMeanSquare / rounded, 1, 0.03);
    EXPECT_NEAR(mean, expected.Mean, 4 * expected.RootMeanSquare / std::sqrt(160 * 120.0));
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, TestStochasticSamples, testing::Values(4, 8, 12, 32, 64));

//------------------------------------------------------------------------------
TEST_F(TestStochastic, LetsThroughExactlyWhatIsRight)
{
  AnalyticScene scene = RandomLayers(200, 160, 12, 12, 0.05, 0.4);
  for (Layer& layer : scene.Translucent)
  {
    layer[0].Rgb = { { 0, 0, 0 } }; // only what shows through has a colour
  }
  for (bool correction : { false, true })
  {
    const PictureDifference difference =
      Compare(Draw(scene, NewPass(8, correction)), scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, 1.5) << difference;
  }
}

//------------------------------------------------------------------------------
TEST_F(TestStochastic, IsExactForOneFragment)
{
  const AnalyticScene scene = Layers({ Whole(0.25, { { 0.8, 0.1, 0.4 } }, 0.37) });
  for (bool correction : { false, true })
  {
    for (int windowSamples : { 0, 4 })
    {
      View view(scene, windowSamples);
      view.SetPass(NewPass(8, correction));
      const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
      EXPECT_LE(difference.Largest, 1.5) << difference;
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestStochastic, IsExactForFragmentsOfOneColorWithAlphaCorrection)
{
  const Reference::Color rgb{ { 0.8, 0.1, 0.4 } };
  const AnalyticScene scene = Layers({ Whole(0.25, rgb, 0.3), Whole(0.5, rgb, 0.45), Whole(0.125, rgb, 0.15) });
  const Picture exact = scene.Compute(Reference::CompositeExact);
  EXPECT_LE(Compare(Draw(scene, NewPass(4, true)), exact).Largest, 1.5);
  EXPECT_GT(Compare(Draw(scene, NewPass(4, false)), exact).Largest, 5);
}

//------------------------------------------------------------------------------
TEST_F(TestStochastic, HidesExactlyWhatLiesBehindFullOpacity)
{
  const Reference::Color hidden{ { 0, 1, 0 } };
  const AnalyticScene scene =
    Layers({ Whole(0.75, hidden, 0.5), Whole(0.5, { { 0.6, 0.2, 0.4 } }, 1), Whole(0.625, hidden, 1) });
  for (const AnalyticScene& drawn : { scene, scene.Reversed() })
  {
    for (bool correction : { false, true })
    {
      EXPECT_LE(Compare(Draw(drawn, NewPass(8, correction)), scene.Compute(Reference::CompositeExact)).Largest, 0.5);
    }
  }
}

//------------------------------------------------------------------------------
// The order of sums changes their last bits, which may round a byte the other way.
TEST_F(TestStochastic, IsTheSameInAnyOrderOfDrawing)
{
  const AnalyticScene scene = RandomLayers(200, 160, 13, 12, 0.1, 0.7);
  for (int samples : { 8, 64 })
  {
    const Picture drawn = Draw(scene, NewPass(samples));
    EXPECT_LE(Compare(drawn, Draw(scene.Reversed(), NewPass(samples))).Largest, 1);
    EXPECT_EQ(drawn, Draw(scene, NewPass(samples)));
    EXPECT_GT(Compare(drawn, Draw(scene, NewPass(samples, true, 1))).Largest, 10) << "another seed";
  }
}

//------------------------------------------------------------------------------
// Fragments that differ in depth alone, or in colour alone, cover samples of their own, and hide what lies behind them
// both.
TEST_F(TestStochastic, TellsFragmentsOfAPixelApart)
{
  const Rectangle nearer = Whole(0.25, { { 0.2, 0.1, 0.3 } }, 0.5);
  Rectangle behind = nearer;
  behind.Depth = 0.375;
  Rectangle beside = nearer; // which does not hide it, nor is hidden
  beside.Rgb[0] = 0.3;
  const struct
  {
    Rectangle Other;
    double Visibility; // of it
  } cases[] = { { behind, 0.5 }, { beside, 1 } };
  for (const auto& now : cases)
  {
    const AnalyticScene scene = Layers({ nearer, now.Other, Whole(0.5, { { 0, 1, 0 } }, 0.5) });
    auto pass = NewPass(8, false);
    pass->SetAccumulate(64);
    const Picture drawn = DrawFrames(scene, pass, 64);
    double green = 0;
    for (std::size_t i = 1; i < drawn.Rgb.size(); i += 3)
    {
      green += drawn.Rgb[i] / (drawn.Rgb.size() / 3.0);
    }
    const double farthest = 0.25 * 0.5;
    const double shinesThrough = 0.125 * scene.Background[1];
    EXPECT_NEAR(green / 255, 0.5 * 0.1 + now.Visibility * 0.5 * 0.1 + farthest + shinesThrough, 0.005);
  }
}

//------------------------------------------------------------------------------
TEST_F(TestStochastic, BuildsNoShaderInTheSecondFrame)
{
  View view(RandomLayers(100, 80, 14, 5, 0.1, 0.5));
  auto pass = NewPass();
  view.SetPass(pass);
  view.Window->Render();
  EXPECT_GT(pass->GetStatistics()->GetShaderBuilds(), 0);
  EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 2);
  EXPECT_GE(pass->GetStatistics()->GetBytes(), 100 * 80 * (8 * 4 + 16 + 4));
  pass->SetSeed(5);
  view.Window->Render();
  EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
}

//------------------------------------------------------------------------------
TEST_F(TestStochastic, GetsTwiceAsCloseWithFourTimesTheFrames)
{
  const AnalyticScene scene = DarkMosaic(80, 60, 12);
  const Picture exact = scene.Compute(Reference::CompositeExact);
  for (bool correction : { false, true })
  {
    SCOPED_TRACE(correction ? "with alpha correction" : "without");
    double before = 0;
    for (int frames : { 1, 4, 16, 64 })
    {
      auto pass = NewPass(4, correction);
      pass->SetAccumulate(1000);
      const double error = Compare(DrawFrames(scene, pass, frames), exact).RootMeanSquare;
      if (frames > 1)
      {
        EXPECT_GT(before / error, 1.6) << frames;
        EXPECT_LT(before / error, 2.5) << frames;
      }
      before = error;
    }
  }
}

//------------------------------------------------------------------------------
// Transmission colours are taken by their mean, which is what the frames come nearer to.
TEST_F(TestStochastic, GetsCloseToTheMeanOfTransmissionColors)
{
  const AnalyticScene scene = RandomLayers(80, 60, 17, 12, 0.1, 0.7).Transmitting(18);
  const Picture exact = scene.MeanTransmission().Compute(Reference::CompositeExact);
  for (bool correction : { false, true })
  {
    SCOPED_TRACE(correction ? "with alpha correction" : "without");
    double before = 0;
    for (int frames : { 16, 64, 256 })
    {
      auto pass = NewPass(8, correction);
      pass->SetAccumulate(1000);
      const double error = Compare(DrawFrames(scene, pass, frames), exact).RootMeanSquare;
      EXPECT_EQ(TakeMessages().size(), 1u);
      EXPECT_LE(error, frames > 16 ? before / 1.6 : 0.05) << frames;
      before = error;
    }
  }
}

//------------------------------------------------------------------------------
// A surface that hides nothing adds its light, alone and in front of another.
TEST_F(TestStochastic, AddsTheLightOfWhiteTransmission)
{
  Rectangle white = Whole(0.25, { { 0.4, 0.2, 0.1 } }, 0.5);
  white.Transmission = { { 1, 1, 1 } };
  Rectangle black = Whole(0.5, { { 0, 0, 0 } }, 0.5);
  black.Right = 20;
  const AnalyticScene scene = Layers({ white, black });
  for (bool correction : { false, true })
  {
    const Picture drawn = Draw(scene, NewPass(8, correction));
    EXPECT_EQ(TakeMessages().size(), 1u);
    for (int c = 0; c < 3; ++c)
    {
      const double light = 0.5 * white.Rgb[c];
      EXPECT_NEAR(drawn.At(10, 15, c), 255 * (light + 0.5 * scene.Background[c]), 1) << c;
      EXPECT_NEAR(drawn.At(30, 15, c), 255 * (light + scene.Background[c]), 1) << c;
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestStochastic, StopsDrawingGeometryWhenAllFramesAreThere)
{
  View view(RandomLayers(100, 80, 15, 8, 0.1, 0.6));
  auto pass = NewPass();
  pass->SetAccumulate(3);
  view.SetPass(pass);
  Picture last;
  for (int passes : { 2, 2, 2, 0, 0 })
  {
    const Picture now = view.Render();
    EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), passes);
    EXPECT_EQ(now == last, passes == 0);
    last = now;
  }
  pass->ReleaseGraphicsResources(view.Window);
  view.Window->Render();
  EXPECT_EQ(pass->GetAccumulatedFrames(), 1);
}

namespace
{
/// A view of balls, one of them opaque, one in an assembly, one in a data set of blocks.
class Balls : public View
{
public:
  Balls()
    : View(RandomLayers(100, 80, 16, 6, 0.1, 0.6))
  {
    this->Source->SetRadius(15);
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Ball->SetMapper(this->Mapper);
    this->Ball->GetProperty()->SetOpacity(0.5);
    this->Ball->SetPosition(30, 30, 0);
    this->Renderer->AddActor(this->Ball);

    this->Part->SetMapper(this->Mapper);
    this->Part->GetProperty()->SetOpacity(0.4);
    this->Assembly->AddPart(this->Part);
    this->Assembly->SetPosition(70, 30, 0);
    this->Renderer->AddActor(this->Assembly);

    vtkNew<vtkSphereSource> block;
    block->SetRadius(12);
    block->SetCenter(50, 60, 0);
    block->Update();
    this->Block->DeepCopy(block->GetOutput());
    this->Blocks->SetBlock(0, this->Block);
    vtkNew<vtkCompositePolyDataMapper> blocks;
    blocks->SetInputDataObject(this->Blocks);
    vtkNew<vtkActor> whole;
    whole->SetMapper(blocks);
    whole->GetProperty()->SetOpacity(0.5);
    this->Renderer->AddActor(whole);

    this->Opaque->SetMapper(this->Mapper);
    this->Opaque->SetPosition(80, 65, 0);
    this->Renderer->AddActor(this->Opaque);
  }

  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Ball;
  vtkNew<vtkActor> Part;
  vtkNew<vtkAssembly> Assembly;
  vtkNew<vtkPolyData> Block;
  vtkNew<vtkMultiBlockDataSet> Blocks;
  vtkNew<vtkActor> Opaque;
};

/// What can be done to it while it is being refined.
struct Change
{
  std::string Name;
  std::function<void(Balls&, vtkStochasticTransparencyPass*)> Make;
};

void PrintTo(const Change& value, std::ostream* os)
{
  *os << value.Name;
}

const Change Changes[] = {
  { "Camera", [](Balls& view, auto*) { view.Renderer->GetActiveCamera()->Zoom(1.1); } },
  { "CameraModelTransform",
    [](Balls& view, auto*)
    {
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(0, 3, 5);
      view.Renderer->GetActiveCamera()->SetModelTransformMatrix(matrix);
    } },
  { "Size", [](Balls& view, auto*) { view.Window->SetSize(90, 80); } },
  { "Viewport", [](Balls& view, auto*) { view.Renderer->SetViewport(0, 0, 0.9, 1); } },
  { "Source", [](Balls& view, auto*) { view.Source->SetRadius(10); } },
  { "Data",
    [](Balls& view, auto*)
    {
      view.Block->GetPoints()->SetPoint(0, 50, 60, 0.5);
      view.Block->GetPoints()->Modified();
    } },
  { "Transform", [](Balls& view, auto*) { view.Ball->AddPosition(5, 0, 0); } },
  { "UserMatrix",
    [](Balls& view, auto*)
    {
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(0, 3, 5);
      view.Ball->SetUserMatrix(matrix);
    } },
  { "AssemblyTransform", [](Balls& view, auto*) { view.Assembly->AddPosition(5, 0, 0); } },
  { "PartTransform", [](Balls& view, auto*) { view.Part->AddPosition(5, 0, 0); } },
  { "PartProperty", [](Balls& view, auto*) { view.Part->GetProperty()->SetOpacity(0.9); } },
  { "OpaqueTransform", [](Balls& view, auto*) { view.Opaque->AddPosition(-10, 0, 0); } },
  { "Opacity", [](Balls& view, auto*) { view.Ball->GetProperty()->SetOpacity(0.6); } },
  { "Color", [](Balls& view, auto*) { view.Ball->GetProperty()->SetColor(1, 0, 0); } },
  { "Light",
    [](Balls& view, auto*)
    { vtkLight::SafeDownCast(view.Renderer->GetLights()->GetItemAsObject(0))->SetIntensity(0.5); } },
  { "ClippingPlane",
    [](Balls& view, auto*)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(35, 0, 0);
      view.Mapper->AddClippingPlane(plane);
    } },
  { "Invisible", [](Balls& view, auto*) { view.Ball->VisibilityOff(); } },
  { "Removed", [](Balls& view, auto*) { view.Renderer->RemoveActor(view.Ball); } },
  { "Seed", [](Balls&, auto* pass) { pass->SetSeed(9); } },
  { "DepthSamples", [](Balls&, auto* pass) { pass->SetDepthSamples(16); } },
  { "AlphaCorrection", [](Balls&, auto* pass) { pass->AlphaCorrectionOff(); } },
};
}

class TestStochasticChange
  : public RenderTest
  , public testing::WithParamInterface<Change>
{
};

//------------------------------------------------------------------------------
TEST_P(TestStochasticChange, StartsTheMeanAnew)
{
  auto pass = NewPass();
  Balls view;
  view.SetPass(pass);
  view.Window->Render(); // some mappers modify themselves when they are drawn first
  pass->SetAccumulate(100);
  for (int frame = 1; frame <= 3; ++frame)
  {
    view.Window->Render();
    ASSERT_EQ(pass->GetAccumulatedFrames(), frame) << "nothing has changed";
  }
  const Picture before = Capture(view.Window);
  GetParam().Make(view, pass);
  const Picture changed = view.Render();
  EXPECT_EQ(pass->GetAccumulatedFrames(), 1);
  EXPECT_FALSE(changed == before);
  view.Window->Render();
  EXPECT_EQ(pass->GetAccumulatedFrames(), 2) << "it goes on from there";

  // As a pass draws that has seen nothing before.
  auto fresh = NewPass();
  fresh->SetAccumulate(100);
  Balls again;
  again.SetPass(NewPass());
  again.Window->Render();
  again.SetPass(fresh);
  GetParam().Make(again, fresh);
  again.Window->Render();
  const auto drawn = [](const Picture& picture) { return Crop(picture, 0, 0, 90, 80); }; // by all changes of size
  EXPECT_EQ(drawn(Capture(again.Window)), drawn(changed));
}

INSTANTIATE_TEST_SUITE_P(
  Changes, TestStochasticChange, testing::ValuesIn(Changes), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
TEST_F(TestStochastic, RefusesOptionsOutOfRange)
{
  auto pass = NewPass();
  const vtkMTimeType before = pass->GetMTime();
  const struct
  {
    std::function<void()> Set;
    std::string Expected;
  } refused[] = {
    { [&] { pass->SetDepthSamples(0); }, "DepthSamples is 0, expected a multiple of 4" },
    { [&] { pass->SetDepthSamples(6); }, "DepthSamples is 6, expected" },
    { [&] { pass->SetDepthSamples(36); }, "DepthSamples is 36, expected" },
    { [&] { pass->SetDepthSamples(72); }, "DepthSamples is 72, expected" },
    { [&] { pass->SetDepthSamples(-4); }, "DepthSamples is -4, expected" },
    { [&] { pass->SetSeed(-1); }, "Seed is -1, expected 0 or more" },
    { [&] { pass->SetAccumulate(0); }, "Accumulate is 0, expected 1 to" },
    { [&] { pass->SetAccumulate(65537); }, "Accumulate is 65537, expected 1 to" },
  };
  for (const auto& attempt : refused)
  {
    attempt.Set();
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u) << attempt.Expected;
    EXPECT_NE(messages[0].find(attempt.Expected), std::string::npos) << messages[0];
  }
  EXPECT_EQ(pass->GetMTime(), before);
  for (const vtkTranslucencyOption& option : pass->GetOptions())
  {
    EXPECT_EQ(option.Get(), option.Default) << option.Name;
    EXPECT_TRUE(pass->SetOption(option.Keyword, pass->GetOption(option.Keyword)));
  }
}
