// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Multi-sampled windows: the picture is the mean of the exact pictures at the samples' positions.
#include "GLState.h"
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkFragmentStorage.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkTranslucencyVTKVersion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace
{
using Position = std::array<double, 2>;

/// Flat and unlit, with corners in the middle of nowhere: its edges cut pixels at all angles.
struct Triangle
{
  std::array<Position, 3> Corners;
  double Depth;
  Reference::Color Rgb;
  double Alpha;
};

enum class Side
{
  Inside,
  Outside,
  OnEdge // whether it is covered depends on the driver's rounding
};

Side SideOf(const Triangle& triangle, const Position& p)
{
  constexpr double Nowhere = 0.006; // pixels: corners are rounded to 1/256
  for (int axis : { 0, 1 })         // nearly all are far away
  {
    const auto [low, high] =
      std::minmax({ triangle.Corners[0][axis], triangle.Corners[1][axis], triangle.Corners[2][axis] });
    if (p[axis] < low - Nowhere || p[axis] > high + Nowhere)
    {
      return Side::Outside;
    }
  }
  bool left = true;
  bool right = true;
  bool close = false;
  for (int i = 0; i < 3; ++i)
  {
    const Position& a = triangle.Corners[i];
    const Position& b = triangle.Corners[(i + 1) % 3];
    const double area = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    const double distance = area / std::hypot(b[0] - a[0], b[1] - a[1]);
    left = left && distance > -Nowhere;
    right = right && distance < Nowhere;
    close = close || std::abs(distance) <= Nowhere;
  }
  return !left && !right ? Side::Outside : close ? Side::OnEdge : Side::Inside;
}

struct TriangleScene
{
  int Width;
  int Height;
  Reference::Color Background{ { 0.2, 0.4, 0.6 } };
  std::vector<Triangle> Opaque;
  std::vector<Triangle> Translucent; // in the order of drawing

  void AddTo(vtkRenderer* renderer) const;

  /// The mean over the samples, and 0 or 1 whether each pixel is beyond doubt.
  Picture Compute(const Compositor& composite, const std::vector<Position>& samples, std::vector<bool>& certain) const;
};

TriangleScene RandomTriangles(int width, int height, unsigned int seed, int opaque, int translucent, double largest)
{
  TriangleScene scene;
  scene.Width = width;
  scene.Height = height;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<int> depths(65534);
  std::iota(depths.begin(), depths.end(), 1);
  std::shuffle(depths.begin(), depths.end(), random);
  for (int i = 0; i < opaque + translucent; ++i)
  {
    Triangle triangle;
    const Position middle{ { unit(random) * scene.Width, unit(random) * scene.Height } };
    for (Position& corner : triangle.Corners)
    {
      corner = { { middle[0] + (unit(random) - 0.5) * largest, middle[1] + (unit(random) - 0.5) * largest } };
    }
    triangle.Depth = depths[i] / 65536.0;
    triangle.Rgb = { { unit(random), unit(random), unit(random) } };
    triangle.Alpha = i < opaque ? 1 : 0.05 + 0.6 * unit(random);
    (i < opaque ? scene.Opaque : scene.Translucent).push_back(triangle);
  }
  return scene;
}

/// Layers of small triangles that share their edges, in any order, with few colours and opacities: neighbours are often
/// the same, or nearly, and often not.
TriangleScene Mosaic(int width, int height, unsigned int seed)
{
  constexpr int Layers = 3;
  constexpr int Cells = 9; // across and down
  TriangleScene scene;
  scene.Width = width;
  scene.Height = height;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int layer = 0; layer < Layers; ++layer)
  {
    std::vector<Position> corners;
    for (int i = 0; i <= Cells; ++i)
    {
      for (int j = 0; j <= Cells; ++j)
      {
        corners.push_back(
          { { (j - 0.3 + 0.6 * unit(random)) * width / Cells, (i - 0.3 + 0.6 * unit(random)) * height / Cells } });
      }
    }
    for (int i = 0; i < Cells * Cells; ++i)
    {
      const int at = i / Cells * (Cells + 1) + i % Cells;
      const int across = at + 1;
      const int down = at + Cells + 1;
      for (const auto& ids : { std::array<int, 3>{ { at, across, down } }, { { down, across, down + 1 } } })
      {
        const double red = 0.3 + (random() % 2) / 40.0 + (random() % 4 == 0 ? 0.5 : 0.0);
        scene.Translucent.push_back({ { { corners[ids[0]], corners[ids[1]], corners[ids[2]] } }, (1 + layer) / 8.0,
          { { red, 0.5, 0.1 + 0.7 * (random() % 4 == 0) } }, random() % 4 == 0 ? 0.7 : 0.4 });
      }
    }
  }
  std::shuffle(scene.Translucent.begin(), scene.Translucent.end(), random);
  return scene;
}

void TriangleScene::AddTo(vtkRenderer* renderer) const
{
  AnalyticScene empty;
  empty.Width = this->Width;
  empty.Height = this->Height;
  empty.Background = this->Background;
  empty.AddTo(renderer); // background and camera
  for (const auto* triangles : { &this->Opaque, &this->Translucent })
  {
    for (const Triangle& triangle : *triangles)
    {
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      for (const Position& corner : triangle.Corners)
      {
        points->InsertNextPoint(corner[0], corner[1], 1 - 2 * triangle.Depth);
      }
      const vtkIdType ids[3] = { 0, 1, 2 };
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      data->AllocateExact(1, 3);
      data->InsertNextCell(VTK_TRIANGLE, 3, ids);
      renderer->AddActor(NewUnlitActor(data, triangle.Rgb, triangle.Alpha));
    }
  }
}

Picture TriangleScene::Compute(
  const Compositor& composite, const std::vector<Position>& samples, std::vector<bool>& certain) const
{
  Picture picture{ this->Width, this->Height, {} };
  certain.clear();
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      Reference::Color mean{ { 0, 0, 0 } };
      bool sure = true;
      for (const Position& sample : samples)
      {
        const Position p{ { x + sample[0], y + sample[1] } };
        const auto covers = [&](const Triangle& triangle)
        {
          const Side side = SideOf(triangle, p);
          sure = sure && side != Side::OnEdge;
          return side == Side::Inside;
        };
        double depth = 1;
        Reference::Color behind = this->Background;
        for (const Triangle& triangle : this->Opaque)
        {
          if (covers(triangle) && triangle.Depth < depth)
          {
            depth = triangle.Depth;
            behind = triangle.Rgb;
          }
        }
        std::vector<Reference::Fragment> fragments;
        for (const Triangle& triangle : this->Translucent)
        {
          if (covers(triangle) && triangle.Depth < depth)
          {
            fragments.push_back({ triangle.Depth, triangle.Rgb, triangle.Alpha });
          }
        }
        const Reference::Color color = composite(fragments).Over(behind);
        for (int channel = 0; channel < 3; ++channel)
        {
          mean[channel] +=
            255 * std::min(color[channel], 1.0) / static_cast<double>(samples.size()); // as bytes hold it
        }
      }
      picture.Rgb.insert(picture.Rgb.end(), mean.begin(), mean.end());
      certain.push_back(sure);
    }
  }
  return picture;
}

/// Where the driver takes its samples in a pixel, if asked for so many.
std::vector<Position> SamplePositions(View& view, int samples)
{
  view.Window->MakeCurrent();
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  samples = std::min(samples, most);
  GLuint texture = 0;
  GLuint framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_RGBA8, 4, 4, GL_TRUE);
  glGenFramebuffers(1, &framebuffer);
  auto* state = vtkOpenGLRenderWindow::SafeDownCast(view.Window)->GetState();
  state->PushFramebufferBindings();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0);
  glGetIntegerv(GL_SAMPLES, &samples);
  std::vector<Position> positions;
  for (int i = 0; i < samples; ++i)
  {
    GLfloat position[2];
    glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), position);
    positions.push_back({ { position[0], position[1] } });
  }
  state->PopFramebufferBindings();
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
  return positions;
}

struct Sampling
{
  std::string Name;
  int Samples;
  std::function<vtkSmartPointer<vtkTranslucencyPass>()> New;
  Compositor Composite;
  TriangleScene Scene;
};

void PrintTo(const Sampling& value, std::ostream* os)
{
  *os << value.Name;
}

class TestMultiSampling
  : public RenderTest
  , public testing::WithParamInterface<Sampling>
{
};
}

//------------------------------------------------------------------------------
TEST_P(TestMultiSampling, IsTheMeanOfTheSamples)
{
  const TriangleScene& scene = GetParam().Scene;
  View view(scene.Width, scene.Height, GetParam().Samples);
  scene.AddTo(view.Renderer);
  const auto pass = GetParam().New();
  view.SetPass(pass);
  view.Render();
  const std::vector<Position> positions = SamplePositions(view, GetParam().Samples);
  ASSERT_GT(positions.size(), 1u);
  std::vector<bool> certain;
  const Picture expected = scene.Compute(GetParam().Composite, positions, certain);
  const double least = positions.size() > 4 ? 0.2 : 0.3; // the more samples, the more borders are too near to one
  ASSERT_GT(std::count(certain.begin(), certain.end(), true), least * certain.size());
  for (int frame = 0; frame < 2; ++frame)
  {
    Picture drawn = view.Render();
    for (std::size_t i = 0; i < drawn.Rgb.size(); ++i)
    {
      drawn.Rgb[i] = certain[i / 3] ? drawn.Rgb[i] : expected.Rgb[i];
    }
    const PictureDifference difference = Compare(drawn, expected);
    EXPECT_LE(difference.Largest, 2) << difference;
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  }
}

namespace
{
template <typename Pass>
std::function<vtkSmartPointer<vtkTranslucencyPass>()> New(const std::function<void(Pass*)>& arrange = nullptr)
{
  return [arrange]
  {
    auto pass = vtkSmartPointer<Pass>::New();
    if (arrange)
    {
      arrange(pass);
    }
    return vtkSmartPointer<vtkTranslucencyPass>(pass);
  };
}

std::function<vtkSmartPointer<vtkTranslucencyPass>()> New(const std::string& technique, const Settings& options)
{
  return [=] { return NewTechnique(technique, options); };
}

Compositor Layers(int count, Reference::Tail tail)
{
  return [=](const std::vector<Reference::Fragment>& fragments)
  { return Reference::CompositeLayers(fragments, count, tail); };
}

// Techniques without lists: each sample has a record, or a value of each target, of its own.
std::vector<Sampling> SamplingsWithoutLists(const TriangleScene& few, const TriangleScene& mosaic)
{
  using Reference::Tail;
  std::vector<Sampling> samplings;
  for (int samples : { 2, 4, 8 })
  {
    const auto add =
      [&](const std::string& name, const std::string& technique, const Settings& options, const Compositor& composite)
    {
      const std::string suffix = std::to_string(samples);
      samplings.push_back({ name + suffix, samples, New(technique, options), composite, few });
      samplings.push_back({ name + "Mosaic" + suffix, samples, New(technique, options), composite, mosaic });
    };
    add("Peel", "peel", {}, Reference::CompositeExact);
    add("PeelFrontToBack", "peel", { { "method", "front-to-back" } }, Reference::CompositeExact);
    add("Mlab32", "mlab", { { "layers", "32" } }, Reference::CompositeExact);
    add("Mlab2", "mlab", { { "layers", "2" } }, Layers(2, Tail::Merge));
    add("KBuffer2", "kbuffer", { { "layers", "2" } }, Layers(2, Tail::Drop));
    add("Hybrid2", "hybrid", { { "layers", "2" } }, Layers(2, Tail::Average));
    add("AdaptiveFixed4", "adaptive", { { "memory", "fixed" }, { "nodes", "4" } },
      [](std::vector<Reference::Fragment> fragments)
      {
        std::reverse(fragments.begin(), fragments.end());
        return Reference::CompositeAdaptive(fragments, 4, Reference::Removal::Underestimate);
      });
    add("WeightedSum", "weighted", { { "method", "sum" } }, Reference::CompositeWeightedSum);
    add("WeightedAverage", "weighted", { { "method", "average" } }, Reference::CompositeWeightedAverage);
    for (const char* memory : { "Fixed", "Variable" })
    {
      add("ShadowMap" + std::string(memory), "shadowmap",
        { { "memory", memory[0] == 'F' ? "fixed" : "variable" }, { "slices", "8" } },
        [](const std::vector<Reference::Fragment>& fragments)
        {
          const auto share = [](double at, double before) { return Reference::SliceShare(8, at, before); };
          return Reference::CompositeAbsorbance(fragments, Reference::VisibilitiesOf(share), {}, true);
        });
    }
  }
  return samplings;
}

std::vector<Sampling> Samplings()
{
  std::vector<Sampling> samplings;
  const TriangleScene few = RandomTriangles(160, 120, 91, 4, 40, 100);
  const TriangleScene deep = RandomTriangles(160, 120, 92, 2, 500, 160);
  const TriangleScene deepest = RandomTriangles(32, 24, 93, 1, 700, 160); // some pixels have more than 256
  const TriangleScene mosaic = Mosaic(64, 48, 94);
  for (int samples : { 2, 4, 8 })
  {
    const std::string suffix = std::to_string(samples);
    samplings.push_back({ "Exact" + suffix, samples, New<vtkABufferPass>(), Reference::CompositeExact, few });
    samplings.push_back({ "ExactDeep" + suffix, samples, New<vtkABufferPass>(), Reference::CompositeExact, deep });
    samplings.push_back(
      { "ExactDeepest" + suffix, samples, New<vtkABufferPass>(), Reference::CompositeExact, deepest });
    samplings.push_back({ "ExactBytes" + suffix, samples,
      New<vtkABufferPass>([](vtkABufferPass* pass) { pass->GetStorage()->SetColorFormat(vtkFragmentStorage::RGBA8); }),
      Reference::CompositeExact, few });
    samplings.push_back({ "ExactMosaic" + suffix, samples, New<vtkABufferPass>(), Reference::CompositeExact, mosaic });
    samplings.push_back({ "ExactMosaicBytes" + suffix, samples,
      New<vtkABufferPass>([](vtkABufferPass* pass) { pass->GetStorage()->SetColorFormat(vtkFragmentStorage::RGBA8); }),
      Reference::CompositeExact, mosaic });
    samplings.push_back({ "Iterative" + suffix, samples,
      New<vtkABufferPass>([](vtkABufferPass* pass) { pass->SetResolve(vtkABufferPass::Iterative); }),
      Reference::CompositeIterative, few });
    samplings.push_back({ "ExactTiles" + suffix, samples,
      New<vtkABufferPass>([](vtkABufferPass* pass) { pass->GetStorage()->SetMemoryLimit(1); }),
      Reference::CompositeExact, deep });
    samplings.push_back({ "Adaptive16" + suffix, samples, New<vtkAdaptiveTransparencyPass>(),
      AdaptiveCompositor(16, Reference::Removal::Underestimate), few });
    samplings.push_back({ "Adaptive16Deep" + suffix, samples, New<vtkAdaptiveTransparencyPass>(),
      AdaptiveCompositor(16, Reference::Removal::Underestimate), deep });
    samplings.push_back({ "Adaptive4" + suffix, samples,
      New<vtkAdaptiveTransparencyPass>([](vtkAdaptiveTransparencyPass* pass) { pass->SetNodeCount(4); }),
      AdaptiveCompositor(4, Reference::Removal::Underestimate), few });
    // Not larger: where few nodes are left, interpolated depths and computed ones may not remove the same.
    for (const auto& [name, scene] : { std::pair("Tolerance", &few), std::pair("ToleranceDeep", &deep) })
    {
      samplings.push_back({ name + suffix, samples,
        New<vtkAdaptiveTransparencyPass>(
          [](vtkAdaptiveTransparencyPass* pass)
          {
            pass->SetNodeCount(2);
            pass->SetTolerance(0.001);
          }),
        [](const std::vector<Reference::Fragment>& fragments)
        { return Reference::CompositeToTolerance(fragments, 2, Reference::Removal::Underestimate, 0.001); },
        *scene });
    }
  }
  const std::vector<Sampling> others = SamplingsWithoutLists(few, mosaic);
  samplings.insert(samplings.end(), others.begin(), others.end());
  return samplings;
}
}

INSTANTIATE_TEST_SUITE_P(
  Samples, TestMultiSampling, testing::ValuesIn(Samplings()), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestMultiSamplingOf = RenderTest;

// llvmpipe also shades pixels beside the scissor rectangle.
TEST_F(TestMultiSamplingOf, TilesChangesNoPixel)
{
  const TriangleScene scene = RandomTriangles(160, 120, 92, 2, 500, 160);
  View view(scene.Width, scene.Height, 4);
  scene.AddTo(view.Renderer);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture whole = view.Render();
  for (double limit : { 1.0, 2.0, 4.0 })
  {
    pass->GetStorage()->SetMemoryLimit(limit);
    EXPECT_EQ(Compare(whole, view.Render()).Largest, 0) << limit;
    EXPECT_GT(pass->GetStatistics()->GetTiles(), 1) << limit;
  }
}

//------------------------------------------------------------------------------
// Short lists are drawn before single samples have their turns, and take no screen then.
TEST_F(TestMultiSamplingOf, TurnsOfSamplesAreForLongListsOnly)
{
  const auto draw = [](int windowSamples)
  {
    const TriangleScene scene = RandomTriangles(32, 24, 93, 1, 700, 160);
    View view(scene.Width, scene.Height, windowSamples);
    scene.AddTo(view.Renderer);
    vtkNew<vtkABufferPass> pass;
    view.SetPass(pass);
    view.Render();
    return pass->GetStatistics()->GetScreenPasses();
  };
  constexpr int samples = 4;
  EXPECT_EQ(draw(samples), draw(0) + samples + 1) << "the long lists of each, and their mean";
}

//------------------------------------------------------------------------------
// Triangles as small as pixels: their fragments share nodes, where the driver lets them.
TEST_F(TestMultiSamplingOf, FineMeshTakesFewMoreFragmentsThanOneSample)
{
  const auto fragments = [](int samples, bool merges)
  {
    AnalyticScene scene;
    View view(scene, samples);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(20.3, 10.6, 0.5);
    plane->SetPoint1(370.2, 40.1, 0.4);
    plane->SetPoint2(60.4, 280.7, -0.3);
    plane->SetResolution(300, 250);
    plane->Update();
    view.Renderer->AddActor(NewUnlitActor(plane->GetOutput(), { { 0.4, 0.5, 0.6 } }, 0.3));
    vtkNew<vtkABufferPass> pass;
    view.SetPass(pass);
    const Picture drawn = view.Render();
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    EXPECT_NEAR(drawn.At(200, 150, 1), 255 * 0.5 * 0.3, 1);
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(view.Window);
    const bool kept = vtkTranslucencyCapabilities::Probe(window).KeepsDrawOrder;
    return merges && !kept ? 0.0 : static_cast<double>(pass->GetStatistics()->GetFragments());
  };
  EXPECT_GT(fragments(1, false), 50000);
  EXPECT_LT(fragments(4, true), 1.1 * fragments(1, false));
}

//------------------------------------------------------------------------------
// Nothing tells the one's fragments from the other's but that they cover the same samples.
TEST_F(TestMultiSamplingOf, CoincidentSurfacesBothCount)
{
  AnalyticScene scene;
  const Rectangle rectangle{ 50, 40, 200, 150, 0.5, { { 1, 1, 1 } }, 0.4 };
  scene.Translucent = { { rectangle }, { rectangle } };
  View view(scene, 4);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, 1) << difference;
}

//------------------------------------------------------------------------------
// Without what coverage masks need, edges are not smoothed, but everything is drawn, and right inside of edges.
TEST_F(TestMultiSamplingOf, RectanglesOnPixelBordersNeedsNoMasks)
{
  const AnalyticScene scene = RandomLayers(200, 160, 81, 30, 0.05, 0.6);
  View view(scene, 4);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  Picture drawn = view.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(view.Window);
  const std::string missing = vtkTranslucencyCapabilities::Probe(window).MissingForSamples;
  // zink can't turn multi-sampling off: on diagonals, rectangles have two fragments a pixel (Documentation/Drivers.md).
  const double bound = IsZink() && !missing.empty() ? 40 : 1.5;
  for (int frame = 0; frame < 2; ++frame)
  {
    const PictureDifference difference = Compare(drawn, scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, bound) << difference;
    EXPECT_LE(difference.RootMeanSquare, 0.006) << difference;
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    drawn = view.Render();
  }
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), missing.empty() ? 0u : 1u);
  if (!missing.empty())
  {
    EXPECT_NE(messages[0].find(missing), std::string::npos) << messages[0];
  }
}

//------------------------------------------------------------------------------
// Their shaders set gl_FragDepth: the samples that pass are not known from the early test, but from a copy of the
// opaque depth.
TEST_F(TestMultiSamplingOf, ImpostorsAreDrawn)
{
  AnalyticScene scene;
  scene.Opaque.push_back({ 0, 0, 200, 300, 0.01, { { 1, 1, 1 } }, 1 });
  View view(scene, 4);
  AddBall(view.Renderer, true, 200, 150, -0.6);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture drawn = view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  EXPECT_EQ(drawn.At(300, 20, 0), 0) << "beside the ball";
  EXPECT_GT(drawn.At(230, 150, 0), 10) << "the ball";
}
