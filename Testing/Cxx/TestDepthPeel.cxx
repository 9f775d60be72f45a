// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Depth peeling against pictures computed from its theory: all layers give the exact one, some give these and the tail.
#include "RenderTest.h"

#include <vtkDepthPeelPass.h>
#include <vtkImageData.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{
constexpr int FrontToBack = vtkDepthPeelPass::FrontToBack;
constexpr int Dual = vtkDepthPeelPass::Dual;
constexpr int BucketSort = vtkDepthPeelPass::BucketSort;
constexpr int Drop = vtkDepthPeelPass::Drop;
constexpr int Average = vtkDepthPeelPass::Average;

/// The fragments of a pixel as layers, front to back: those of one depth are one.
std::vector<Reference::Pixel> LayersOf(const std::vector<Reference::Fragment>& fragments)
{
  std::map<double, std::vector<Reference::Fragment>> byDepth;
  for (const Reference::Fragment& fragment : fragments)
  {
    byDepth[fragment.Depth].push_back(fragment);
  }
  std::vector<Reference::Pixel> layers;
  for (const auto& layer : byDepth)
  {
    layers.push_back(Reference::CompositeExact(layer.second));
  }
  return layers;
}

Reference::Pixel AverageOf(const std::vector<Reference::Fragment>& fragments)
{
  Reference::Pixel sum;
  double opacities = 0;
  for (const Reference::Fragment& fragment : fragments)
  {
    opacities += fragment.Alpha;
    sum.Transmittance *= 1 - fragment.Alpha;
    for (int c = 0; c < 3; ++c)
    {
      sum.Rgb[c] += fragment.Alpha * fragment.Rgb[c];
    }
  }
  for (double& channel : sum.Rgb)
  {
    channel *= opacities > 0 ? (1 - sum.Transmittance) / opacities : 0;
  }
  return sum;
}

/// So many layers from the front and from the back, and the rest between them.
Reference::Pixel CompositePeeled(
  const std::vector<Reference::Fragment>& fragments, std::size_t front, std::size_t back, int tail)
{
  const std::vector<Reference::Pixel> layers = LayersOf(fragments);
  std::set<double> depths;
  for (const Reference::Fragment& fragment : fragments)
  {
    depths.insert(fragment.Depth);
  }
  const std::vector<double> sorted(depths.begin(), depths.end());
  front = std::min(front, layers.size());
  back = std::min(back, layers.size() - front);
  std::vector<Reference::Fragment> between;
  for (const Reference::Fragment& fragment : fragments)
  {
    const auto at =
      static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), fragment.Depth) - sorted.begin());
    if (at >= front && at < layers.size() - back)
    {
      between.push_back(fragment);
    }
  }
  std::vector<Reference::Pixel> pieces(layers.begin(), layers.begin() + static_cast<std::ptrdiff_t>(front));
  if (tail == Average)
  {
    pieces.push_back(AverageOf(between));
  }
  pieces.insert(pieces.end(), layers.end() - static_cast<std::ptrdiff_t>(back), layers.end());
  Reference::Pixel pixel;
  for (const Reference::Pixel& piece : pieces)
  {
    for (int c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += pixel.Transmittance * piece.Rgb[c];
    }
    pixel.Transmittance *= piece.Transmittance;
  }
  return pixel;
}

/// Some depths are there twice or three times.
AnalyticScene WithEqualDepths(AnalyticScene scene)
{
  for (std::size_t i = 1; i < scene.Translucent.size(); ++i)
  {
    if (i % 3 != 0)
    {
      scene.Translucent[i].front().Depth = scene.Translucent[i - 1].front().Depth;
    }
  }
  return scene;
}

/// Layers of the whole picture at these depths, in the order of drawing.
AnalyticScene LayersAt(const std::vector<double>& depths, double alpha)
{
  AnalyticScene scene;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const auto level = [i](std::size_t step) { return static_cast<double>(i * step % 4) / 3; };
    scene.Translucent.push_back(
      { { 0, 0, scene.Width, scene.Height, depths[i], { { level(1), level(3), level(5) } }, alpha } });
  }
  return scene;
}

/// As close as depths can be in 32-bit floats, more of them than a bucket has room for, and others around them.
AnalyticScene WithAdjacentDepths()
{
  constexpr double step = 1.0 / (1 << 24);
  std::vector<double> depths{ 0.25, 0.875 };
  for (int i : { 3, 7, 1, 5, 0, 6, 2, 4, 8 })
  {
    depths.push_back(0.5 + i * step);
  }
  depths.push_back(0.125);
  return LayersAt(depths, 0.4);
}

/// A scene of hundreds of layers as one actor, which is drawn hundreds of times.
AnalyticScene AsOneActor(const AnalyticScene& scene)
{
  AnalyticScene merged = scene.RoundedToBytes();
  merged.Translucent = { {} };
  for (const Layer& layer : scene.RoundedToBytes().Translucent)
  {
    merged.Translucent.front().insert(merged.Translucent.front().end(), layer.begin(), layer.end());
  }
  return merged;
}

struct Case
{
  std::string Scene;
  std::function<AnalyticScene()> New;
  double Bound; // in units of 1/255
};

/// A framebuffer of bytes rounds colour, transmittance and their product where much of what is behind shows through.
constexpr double ShowsThrough = 1.5;

const Case Cases[] = {
  { "Layers3", [] { return RandomLayers(400, 300, 1, 3, 0.2, 0.8); }, ShowsThrough },
  { "Layers30", [] { return RandomLayers(400, 300, 2, 30, 0.02, 0.8).Shrunk(5); }, ShowsThrough },
  { "EqualDepths", [] { return WithEqualDepths(RandomLayers(400, 300, 8, 30, 0.1, 0.6).Shrunk(5)); }, ShowsThrough },
  { "AdjacentDepths", WithAdjacentDepths, ShowsThrough },
  { "Layers300", [] { return AsOneActor(RandomLayers(60, 40, 3, 300, 0.02, 0.3).Shrunk(5)); }, 1 },
  { "Layers1200", [] { return AsOneActor(RandomLayers(20, 20, 5, 1200, 0.005, 0.05).Shrunk(5)); }, 1 },
  { "Mosaic64", [] { return RandomMosaic(120, 80, 6, 64, 0.02, 0.3).Shrunk(5); }, 1 },
};

void PrintTo(const Case& value, std::ostream* os)
{
  *os << value.Scene;
}

std::string MethodName(int method)
{
  return method == Dual ? "Dual" : method == BucketSort ? "BucketSort" : "FrontToBack";
}

vtkSmartPointer<vtkDepthPeelPass> NewPeel(int method, int layers = 0, int tail = Average)
{
  auto pass = vtkSmartPointer<vtkDepthPeelPass>::New();
  pass->SetMethod(method);
  pass->SetLayers(layers);
  pass->SetTail(tail);
  return pass;
}
}

//------------------------------------------------------------------------------
class TestDepthPeelOfAll
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Case, int, int>>
{
};

TEST_P(TestDepthPeelOfAll, IsExact)
{
  const auto& [now, method, samples] = GetParam();
  const AnalyticScene scene = now.New();
  const auto pass = NewPeel(method);
  View view(scene, samples);
  view.SetPass(pass);
  const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, now.Bound) << difference;
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  RecordProperty("largest", std::to_string(difference.Largest));
  RecordProperty("rms", std::to_string(difference.RootMeanSquare));
}

INSTANTIATE_TEST_SUITE_P(Matrix, TestDepthPeelOfAll,
  testing::Combine(testing::ValuesIn(Cases), testing::Values(FrontToBack, Dual, BucketSort), testing::Values(0, 4)),
  [](const auto& info)
  {
    return std::get<0>(info.param).Scene + MethodName(std::get<1>(info.param)) +
      (std::get<2>(info.param) > 0 ? "MultiSampled" : "");
  });

//------------------------------------------------------------------------------
class TestDepthPeelOfSome
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<int, int, int, int>>
{
};

TEST_P(TestDepthPeelOfSome, IsTheseLayersAndTheTail)
{
  const auto& [method, layers, tail, samples] = GetParam();
  const AnalyticScene scene = WithEqualDepths(RandomLayers(200, 160, 7, 30, 0.02, 0.15).Shrunk(5));
  View view(scene, samples);
  view.SetPass(NewPeel(method, layers, tail));
  const auto half = static_cast<std::size_t>((layers + 1) / 2);
  const std::size_t front = method == Dual ? half : static_cast<std::size_t>(layers);
  const std::size_t back = method == Dual ? half : 0;
  const Picture expected = scene.Compute([&, kept = tail](const std::vector<Reference::Fragment>& fragments)
    { return CompositePeeled(fragments, front, back, kept); });
  const PictureDifference difference = Compare(view.Render(), expected);
  EXPECT_LE(difference.Largest, ShowsThrough) << difference;
}

INSTANTIATE_TEST_SUITE_P(Matrix, TestDepthPeelOfSome,
  testing::Combine(testing::Values(FrontToBack, Dual, BucketSort), testing::Values(1, 4, 5, 100),
    testing::Values(Drop, Average), testing::Values(0, 4)),
  [](const auto& info)
  {
    return MethodName(std::get<0>(info.param)) + std::to_string(std::get<1>(info.param)) +
      (std::get<2>(info.param) == Drop ? "Drop" : "Average") + (std::get<3>(info.param) > 0 ? "MultiSampled" : "");
  });

//------------------------------------------------------------------------------
class TestDepthPeel
  : public RenderTest
  , public testing::WithParamInterface<int>
{
};

TEST_P(TestDepthPeel, DependsOnNoDrawingOrder)
{
  const AnalyticScene scene = RandomLayers(200, 160, 9, 40, 0.1, 0.5).Shrunk(5);
  const auto draw = [](const AnalyticScene& drawn, int tail)
  { return Draw(drawn, NewPeel(GetParam(), tail < 0 ? 0 : 4, std::max(tail, Drop))); };
  EXPECT_EQ(Compare(draw(scene, -1), draw(scene.Reversed(), -1)).Largest, 0) << "all layers";
  EXPECT_EQ(Compare(draw(scene, Drop), draw(scene.Reversed(), Drop)).Largest, 0);
  EXPECT_LE(Compare(draw(scene, Average), draw(scene.Reversed(), Average)).Largest, 1) << "sums of floats";
}

// Their shaders set gl_FragDepth; lit surfaces have depths of all kinds.
TEST_P(TestDepthPeel, DrawsLitSurfacesAndImpostors)
{
  for (bool impostors : { false, true })
  {
    View view(AnalyticScene{});
    for (int i = 0; i < 4; ++i)
    {
      AddBall(view.Renderer, impostors && i % 2 == 0, 150 + 30 * i, 140 + 15 * (i % 3), -0.4 + 0.2 * i);
    }
    vtkNew<vtkABufferPass> exact;
    view.SetPass(exact);
    const Picture expected = view.Render();
    view.SetPass(NewPeel(GetParam()));
    const PictureDifference difference = Compare(view.Render(), expected);
    EXPECT_LE(difference.Largest, 1) << (impostors ? "impostors: " : "") << difference;
  }
}

// The first drawing only looks for depths; the last finds that nothing is left.
TEST_P(TestDepthPeel, DrawsTheGeometryNoMoreOftenThanItHasTo)
{
  const auto pass = NewPeel(GetParam());
  View view(LayersAt({ 1 / 8.0, 2 / 8.0, 3 / 8.0, 4 / 8.0, 5 / 8.0, 6 / 8.0, 7 / 8.0 }, 0.3));
  view.SetPass(pass);
  const bool dual = GetParam() == Dual;
  const bool buckets = GetParam() == BucketSort;
  const auto drawings = [&](int layers, int tail)
  {
    pass->SetLayers(layers);
    pass->SetTail(tail);
    view.Render();
    return pass->GetStatistics()->GetGeometryPasses();
  };
  EXPECT_EQ(drawings(0, Average), buckets ? 1 : dual ? 1 + 4 + 1 : 1 + 7 + 1);
  EXPECT_EQ(drawings(4, Drop), buckets ? 1 : dual ? 1 + 2 : 1 + 4);
  EXPECT_EQ(drawings(4, Average), buckets ? 1 + 1 : dual ? 1 + 2 + 1 : 1 + 4 + 1);
  EXPECT_EQ(drawings(100, Average), buckets ? 1 : dual ? 1 + 4 + 1 : 1 + 7 + 1);
}

TEST_P(TestDepthPeel, BuildsNoShaderInLaterFrames)
{
  const AnalyticScene scene = RandomLayers(200, 160, 9, 20, 0.1, 0.5).Shrunk(5);
  const auto pass = NewPeel(GetParam(), 4);
  View view(scene);
  view.SetPass(pass);
  view.Render();
  EXPECT_GT(pass->GetStatistics()->GetShaderBuilds(), 0);
  view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
}

INSTANTIATE_TEST_SUITE_P(Methods, TestDepthPeel, testing::Values(FrontToBack, Dual, BucketSort),
  [](const auto& info) { return MethodName(info.param); });

//------------------------------------------------------------------------------
using TestDepthPeelBuckets = RenderTest;

// Four of them, whatever the depths: here each is half as deep as the next one, so that nearly all lie in one bucket.
TEST_F(TestDepthPeelBuckets, GiveNoLessThanTheyHoldADrawing)
{
  std::vector<double> depths;
  for (int i = 1; i <= 24; ++i)
  {
    depths.push_back(std::ldexp(1.0, -i));
  }
  const auto drawings = [](const AnalyticScene& scene)
  {
    const auto pass = NewPeel(BucketSort);
    EXPECT_LE(Compare(Draw(scene, pass), scene.Compute(Reference::CompositeExact)).Largest, ShowsThrough);
    return pass->GetStatistics()->GetGeometryPasses();
  };
  EXPECT_LE(drawings(LayersAt(depths, 0.2)), 24 / 4);
  std::reverse(depths.begin(), depths.end());
  EXPECT_LE(drawings(LayersAt(depths, 0.2)), 24 / 4);
  // At random, far more.
  const int many = drawings(AsOneActor(RandomLayers(60, 40, 3, 300, 0.02, 0.3)));
  EXPECT_GT(many, 300 / 32);
  EXPECT_LE(many, 300 / 7);
}

TEST_F(TestDepthPeelBuckets, AreThoseOfTheFrameThatNeedsThem)
{
  const AnalyticScene scene = RandomLayers(200, 160, 9, 20, 0.1, 0.5).Shrunk(5);
  const auto pass = NewPeel(Dual);
  View view(scene);
  view.SetPass(pass);
  const Picture expected = scene.Compute(Reference::CompositeExact);
  for (int method : { Dual, BucketSort, FrontToBack, BucketSort, Dual })
  {
    pass->SetMethod(method);
    EXPECT_LE(Compare(view.Render(), expected).Largest, ShowsThrough) << method;
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  }
}

//------------------------------------------------------------------------------
using TestDepthPeelLayers = RenderTest;

// Each pixel of each layer is its fragment of that number.
TEST_F(TestDepthPeelLayers, AreKept)
{
  const AnalyticScene scene = WithEqualDepths(RandomLayers(120, 90, 11, 20, 0.2, 0.7));
  for (int samples : { 0, 4 })
  {
    const auto pass = NewPeel(FrontToBack);
    View view(scene, samples);
    view.SetPass(pass);
    view.Render();
    EXPECT_EQ(pass->GetNumberOfKeptLayers(), 0);
    pass->KeepLayersOn();
    view.Render();
    ASSERT_GT(pass->GetNumberOfKeptLayers(), 3);
    for (int i = 0; i < pass->GetNumberOfKeptLayers(); ++i)
    {
      vtkImageData* image = pass->GetKeptLayer(i);
      ASSERT_TRUE(image);
      ASSERT_EQ(image->GetDimensions()[0], scene.Width);
      ASSERT_EQ(image->GetDimensions()[1], scene.Height);
      ASSERT_EQ(image->GetNumberOfScalarComponents(), 4);
      const auto layer = [i](const std::vector<Reference::Fragment>& fragments)
      {
        const std::vector<Reference::Pixel> layers = LayersOf(fragments);
        return i < static_cast<int>(layers.size()) ? layers[i] : Reference::Pixel{};
      };
      AnalyticScene overBlack = scene; // the layer's colour times its opacity
      overBlack.Background = { { 0, 0, 0 } };
      for (Rectangle& opaque : overBlack.Opaque)
      {
        opaque.Rgb = { { 0, 0, 0 } };
      }
      const Picture colors = overBlack.Compute(layer);
      const Picture opacities = overBlack.Compute(
        [&](const std::vector<Reference::Fragment>& fragments) {
          return Reference::Pixel{ { { 1 - layer(fragments).Transmittance, 0, 0 } }, 0 };
        });
      double largest = 0;
      for (int y = 0; y < scene.Height; ++y)
      {
        for (int x = 0; x < scene.Width; ++x)
        {
          const auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
          const double opacity = opacities.At(x, y, 0);
          largest = std::max(largest, std::abs(bytes[3] - opacity));
          for (int c = 0; c < 3; ++c)
          {
            const double color = opacity > 0 ? 255 * colors.At(x, y, c) / opacity : 0;
            largest = std::max(largest, std::abs(bytes[c] - color));
          }
        }
      }
      EXPECT_LE(largest, 0.51) << "layer " << i << ", " << samples << " samples";
    }
  }
}

TEST_F(TestDepthPeelLayers, AreOfFrontToBackOnly)
{
  for (int method : { Dual, BucketSort })
  {
    const auto pass = NewPeel(method);
    pass->KeepLayersOn();
    View view(RandomLayers(120, 90, 11, 20, 0.2, 0.7));
    view.SetPass(pass);
    view.Render();
    EXPECT_EQ(pass->GetNumberOfKeptLayers(), 0);
    EXPECT_EQ(pass->GetKeptLayer(0), nullptr);
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("the layer is 0, expected"), std::string::npos) << messages[0];
  }
}

//------------------------------------------------------------------------------
using TestDepthPeelOptions = RenderTest;

TEST_F(TestDepthPeelOptions, OutOfRangeAreErrorsAndChangeNothing)
{
  vtkNew<vtkDepthPeelPass> pass;
  const vtkMTimeType time = pass->GetMTime();
  const struct
  {
    std::function<void()> Set;
    std::string Message;
  } attempts[] = {
    { [&] { pass->SetMethod(-1); }, "Method is -1, expected" },
    { [&] { pass->SetMethod(3); }, "Method is 3, expected" },
    { [&] { pass->SetLayers(-1); }, "Layers is -1, expected" },
    { [&] { pass->SetLayers(65537); }, "Layers is 65537, expected" },
    { [&] { pass->SetTail(-1); }, "Tail is -1, expected" },
    { [&] { pass->SetTail(2); }, "Tail is 2, expected" },
    { [&] { pass->SetMemoryLimit(-1); }, "MemoryLimit is -1, expected" },
    { [&] { pass->SetOption("method", "bucket"); }, "method is 'bucket', expected front-to-back, dual or bucket-sort" },
    { [&] { pass->SetOption("layers", "-1"); }, "layers is '-1', expected" },
    { [&] { pass->SetOption("memory_limit", "-1"); }, "memory_limit is '-1', expected" },
    { [&] { pass->SetOption("tail", "blend"); }, "tail is 'blend', expected drop or average" },
  };
  for (const auto& attempt : attempts)
  {
    attempt.Set();
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u) << attempt.Message;
    EXPECT_NE(messages[0].find(attempt.Message), std::string::npos) << messages[0];
  }
  EXPECT_EQ(pass->GetMTime(), time);
  EXPECT_EQ(pass->GetOption("method"), "dual");
  EXPECT_EQ(pass->GetOption("layers"), "0");
  EXPECT_EQ(pass->GetOption("tail"), "average");
  EXPECT_EQ(pass->GetOption("memory_limit"), "0");
}
