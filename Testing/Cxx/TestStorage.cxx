// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where fragments lie does not change the picture: every design of storage against linked lists, and what each counts
// against what the closed forms say.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellStorage.h>
#include <vtkFourierOpacityPass.h>
#include <vtkFragmentListPass.h>
#include <vtkLinkedListStorage.h>
#include <vtkMBufferStorage.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRBufferStorage.h>
#include <vtkStorageAccounting.h>
#include <vtkTBufferStorage.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkTranslucencyVTKVersion.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <optional>
#include <random>

namespace
{
constexpr double MiB = 1024.0 * 1024.0;
constexpr double WorstOfOrders =
  1.15; // by how much the error of one order of insertion may be above that of another: measured up to 1.08

struct Storage
{
  std::string Name;
  Settings Options;
  bool KeepsOrder; // of drawing
};

void PrintTo(const Storage& value, std::ostream* os)
{
  *os << value.Name;
}

Storage Sections(const std::string& name, const std::string& design, int length)
{
  return { name + std::to_string(length), { { "storage", design }, { "section_length", std::to_string(length) } },
    true };
}

const Storage LinkedList{ "LinkedList", { { "storage", "linked-list" } }, true };
const Storage TBuffer{ "TBuffer", { { "storage", "t-buffer" } }, true };
const Storage MBuffer{ "MBuffer", { { "storage", "m-buffer" } }, true };
// Its sections do not follow the scene, for each other length of which all shaders are built anew.
const Storage MBufferOf4{ "MBuffer", { { "storage", "m-buffer" }, { "section_length", "4" } }, true };
const Storage RBuffer{ "RBuffer", { { "storage", "r-buffer" } }, false };

vtkSmartPointer<vtkFragmentListPass> New(
  const Storage& storage, const std::string& technique = "exact", const Settings& more = {})
{
  Settings settings = storage.Options;
  settings.insert(settings.end(), more.begin(), more.end());
  const auto made = NewTechnique(technique, settings);
  return vtkFragmentListPass::SafeDownCast(made);
}

vtkCellStorage* CellStorageOf(vtkFragmentListPass* pass)
{
  return vtkCellStorage::SafeDownCast(pass->GetStorage());
}

// From left to right: tens of layers, hundreds of layers on a small part, and nothing; balls over all, whose triangles
// cover pixels in part.
AnalyticScene Mixed()
{
  AnalyticScene scene;
  scene.Width = 240;
  scene.Height = 160;
  scene.Background = { { 0.2, 0.4, 0.6 } };
  scene.Opaque = { { 20, 20, 60, 60, 0.5, { { 1, 1, 1 } }, 1 } };
  std::mt19937 random(31);
  const auto below = [&random](int end) { return static_cast<int>(random() % static_cast<unsigned int>(end)); };
  const auto add = [&](Layer& layer, int left, int bottom, int width, int height, int mostAlpha)
  {
    layer.push_back({ left, bottom, left + width, bottom + height, (1 + below(65000)) / 65536.0,
      { { below(256) / 255.0, below(256) / 255.0, below(256) / 255.0 } }, (1 + below(mostAlpha)) / 255.0 });
  };
  Layer deep; // drawn by one actor
  for (int i = 0; i < 280; ++i)
  {
    add(deep, 130, 50, 4, 4, 10);
  }
  scene.Translucent = { deep };
  for (int i = 0; i < 24; ++i)
  {
    scene.Translucent.emplace_back();
    add(scene.Translucent.back(), below(60), below(100), 10 + below(50), 10 + below(50), 200);
  }
  return scene;
}

void Fill(View& view, bool transmitting)
{
  const AnalyticScene scene = Mixed();
  (transmitting ? scene.Transmitting(7) : scene).AddTo(view.Renderer);
  for (int i = 0; i < 3; ++i)
  {
    AddBall(view.Renderer, false, 70 + 13 * i, 60 + 9 * i, 0);
  }
}

// One of each design, whatever else changes; other lengths of sections, some of which do not come out even with vectors
// and blocks.
const std::vector<Storage> Designs = []
{
  std::vector<Storage> designs;
  for (const std::string& name : AllStorages())
  {
    designs.push_back({ StorageInNames(name), { { "storage", name } }, name != "r-buffer" });
  }
  return designs;
}();
const std::vector<Storage> Lengths{ Sections("T", "t-buffer", 1), Sections("T", "t-buffer", 2),
  Sections("T", "t-buffer", 3), Sections("T", "t-buffer", 8), Sections("T", "t-buffer", 64),
  Sections("M", "m-buffer", 1), Sections("M", "m-buffer", 5) };

struct Technique
{
  std::string Name;
  std::string Technique;
  Settings Options;
  int AnyOrder; // what the order of depth instead of that of drawing changes, at most, in units of 1/255, one more than
                // measured
  int AnyOrderUnmerged; // the same where triangles that meet in a multi-sampled pixel do not share a fragment, and
                        // lists are longer
};

const std::vector<Technique> Techniques{
  { "Exact", "exact", {}, 0, 0 },
  { "Iterative", "exact", { { "resolve", "iterative" } }, 0, 0 },
  { "Adaptive4", "adaptive", { { "nodes", "4" } }, 23, 23 },
  { "Adaptive8", "adaptive", { { "nodes", "8" } }, 19, 23 },
  { "Adaptive16", "adaptive", { { "nodes", "16" } }, 3, 15 },
  { "Fourier", "fourier", {}, 1, 1 },
  { "OpacityShadowMap", "shadowmap", {}, 1, 1 },
};

void PrintTo(const Technique& value, std::ostream* os)
{
  *os << value.Name;
}

void ExpectClosedForms(vtkStorageCountPass* pass)
{
  vtkStorageAccounting::Settings settings;
  settings.TSectionLength = static_cast<int>(pass->GetSectionFragments());
  settings.MSectionLength = settings.TSectionLength;
  const vtkStorageAccounting accounting(settings, { pass->GetHistogram() });
  ASSERT_EQ(accounting.GetError(), "");
  const auto design = vtkStorageDesign::Find(pass->GetStorage()->GetName());
  ASSERT_TRUE(design);
  const vtkStorageAccounting::Cost cost = accounting.GetCost(*design, 0);
  EXPECT_GT(cost.Fragments, 0);
  EXPECT_EQ(cost.Fragments, pass->GetStatistics()->GetFragments());
  EXPECT_EQ(pass->GetStores(), cost.Count.Stores);
  EXPECT_EQ(pass->GetReads(), cost.Count.Reads);
  EXPECT_EQ(pass->GetTableAccesses(), cost.Count.Table);
  EXPECT_EQ(pass->GetSecondDepthAccesses(), cost.Count.SecondDepth);
  EXPECT_EQ(pass->GetFrameBufferAccesses(), cost.Count.FrameBuffer);
  EXPECT_EQ(pass->GetAccesses(), cost.Count.GetTotal());
  EXPECT_DOUBLE_EQ(pass->GetPackedBytes(), cost.Bytes);
}

// Frames from little room on: the first has to grow, the second starts with what that needed.
void ExpectSamePictures(
  const Storage& storage, const Technique& technique, const Settings& more, int samples, bool transmitting)
{
  View view(Mixed(), samples);
  Fill(view, transmitting);
  Settings settings = technique.Options;
  settings.insert(settings.end(), more.begin(), more.end());
  const auto expecting = New(LinkedList, technique.Technique, settings);
  view.SetPass(expecting);
  const Picture expected = view.Render();
  std::optional<Picture> exact; // another order of insertion is another approximation of it, not a worse one
  if (!storage.KeepsOrder && technique.AnyOrder > 0)
  {
    const auto sorting = New(LinkedList);
    view.SetPass(sorting);
    exact = view.Render();
  }
  const auto pass = New(storage, technique.Technique, settings);
  CellStorageOf(pass)->SetInitialFragments(16);
  view.SetPass(pass);
  const int anyOrder = samples > 1 && !KeepsDrawOrder(view) ? technique.AnyOrderUnmerged : technique.AnyOrder;
  for (int frame = 0; frame < 3; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const Picture drawn = view.Render();
    const PictureDifference difference = Compare(drawn, expected);
    EXPECT_LE(difference.Largest, storage.KeepsOrder ? 0 : anyOrder) << difference;
    testing::Test::RecordProperty("largest", std::to_string(difference.Largest));
    if (exact)
    {
      const double error = Compare(expected, *exact).RootMeanSquare;
      const double reordered = Compare(drawn, *exact).RootMeanSquare;
      EXPECT_LE(reordered, error * WorstOfOrders);
      testing::Test::RecordProperty("errors", std::to_string(error) + ", " + std::to_string(reordered));
    }
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    if (pass->GetStorageDesign() !=
      vtkFragmentListPass::MBuffer) // which has room for every pixel, and other sections next time
    {
      EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses() > 1, frame == 0);
    }
  }
}

// One exact frame of whatever is in the view: picture and counts.
void ExpectSameAsInLinkedLists(View& view, const Storage& storage)
{
  const auto expecting = New(LinkedList);
  view.SetPass(expecting);
  const Picture expected = view.Render();
  const auto pass = New(storage);
  view.SetPass(pass);
  EXPECT_EQ(Compare(view.Render(), expected).Largest, 0);
  EXPECT_EQ(pass->GetStatistics()->GetFragments(), expecting->GetStatistics()->GetFragments());
  EXPECT_EQ(pass->GetStatistics()->GetDeepestPixel(), expecting->GetStatistics()->GetDeepestPixel());
}
}

//------------------------------------------------------------------------------
class TestStorage
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Storage, int>>
{
};

TEST_P(TestStorage, DrawsAsLinkedListsDo)
{
  const auto& [storage, samples] = GetParam();
  ExpectSamePictures(storage, Techniques[0], {}, samples, false);
}

TEST_P(TestStorage, DrawsAsLinkedListsDoInBytes)
{
  const auto& [storage, samples] = GetParam();
  ExpectSamePictures(storage, Techniques[0], { { "color_format", "rgba8" } }, samples, false);
}

// Each format with one number of samples: what takes the time is the driver's compiler.
TEST_P(TestStorage, DrawsAsLinkedListsDoWithTransmissionColors)
{
  const auto& [storage, samples] = GetParam();
  ExpectSamePictures(
    storage, Techniques[0], { { "color_format", samples > 1 ? "rgba8" : "half-float" } }, samples, true);
}

// Edges make the fragment shader another one. Where an opaque surface hides a part of it, a driver has lost fragments
// of one storage.
TEST_P(TestStorage, DrawsEdgesAsLinkedListsDo)
{
  const auto& [storage, samples] = GetParam();
  View view(240, 160, samples);
  AddBall(view.Renderer, false, 60, 60, 0);
  view.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(1);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(20, 20, -0.2);
  plane->SetPoint1(220, 20, 0);
  plane->SetPoint2(20, 140, 0.2);
  plane->SetResolution(8, 8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  view.Renderer->AddActor(actor);
  vtkProperty* property = actor->GetProperty();
  property->SetOpacity(0.5);
  property->EdgeVisibilityOn();
  property->SetEdgeColor(1, 1, 1);
  property->SetLineWidth(2);
  ExpectSameAsInLinkedLists(view, storage);
}

// Points that are drawn as spheres discard fragments, and set their depth.
TEST_P(TestStorage, DrawsImpostorsAsLinkedListsDo)
{
  const auto& [storage, samples] = GetParam();
  View view(240, 160, samples);
  AddBall(view.Renderer, true, 100, 80, 0);
  AddBall(view.Renderer, true, 140, 80, 0.1);
  ExpectSameAsInLinkedLists(view, storage);
}

// What shaders count, and what the closed forms expect from nothing but the histogram.
TEST_P(TestStorage, CountsWhatTheClosedFormsSay)
{
  const auto& [storage, samples] = GetParam();
  View view(Mixed(), samples);
  Fill(view, false);
  const auto exact = New(LinkedList); // which draws what the others do
  view.SetPass(exact);
  const Picture expected = view.Render();
  const auto pass = NewCounting(storage.Options);
  vtkTranslucencyStatistics* statistics = pass->GetStatistics();
  EXPECT_EQ(pass->GetAccesses(), -1);
  EXPECT_EQ(pass->GetPackedBytes(), -1);
  EXPECT_EQ(pass->GetPixelsHolding(1), -1);
  view.SetPass(pass);
  for (double limit : { 0.0, 1.5 }) // in one tile, and in several
  {
    SCOPED_TRACE(limit);
    pass->GetStorage()->SetMemoryLimit(limit);
    EXPECT_EQ(Compare(view.Render(), expected).Largest, 0);
    EXPECT_EQ(statistics->GetFallback(), "");
    EXPECT_EQ(statistics->GetTiles() > 1, limit > 0);
    ExpectClosedForms(pass);
    const auto deepest = pass->GetHistogram().Pixels.rbegin();
    EXPECT_EQ(pass->GetPixelsHolding(deepest->first), deepest->second);
    EXPECT_GT(deepest->first, 256) << "sorted where they lie";
    EXPECT_EQ(statistics->GetDeepestPixel(), deepest->first);
  }
}

TEST_P(TestStorage, KeepsTheLimit)
{
  const auto& [storage, samples] = GetParam();
  View view(Mixed(), samples);
  Fill(view, false);
  const auto pass = New(storage);
  view.SetPass(pass);
  const Picture expected = view.Render();
  const vtkTypeInt64 fragments = pass->GetStatistics()->GetFragments();
  for (double limit : { 0.2, 0.8, 1.5 })
  {
    SCOPED_TRACE(limit);
    pass->GetStorage()->SetMemoryLimit(limit);
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_EQ(Compare(view.Render(), expected).Largest, 0);
      EXPECT_GT(pass->GetStatistics()->GetTiles(), 1);
      EXPECT_EQ(pass->GetStatistics()->GetFragments(), fragments);
      EXPECT_LE(pass->GetStorage()->GetBytes(), limit * MiB);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Designs, TestStorage, testing::Combine(testing::ValuesIn(Designs), testing::Values(1, 4)),
  [](const auto& info) { return std::get<0>(info.param).Name + "Samples" + std::to_string(std::get<1>(info.param)); });

//------------------------------------------------------------------------------
class TestStorageLengths
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Storage, int>>
{
};

TEST_P(TestStorageLengths, DrawAsLinkedListsDo)
{
  const auto& [storage, samples] = GetParam();
  ExpectSamePictures(
    storage, Techniques[0], { { "color_format", samples > 1 ? "rgba8" : "half-float" } }, samples, false);
}

INSTANTIATE_TEST_SUITE_P(Lengths, TestStorageLengths,
  testing::Combine(testing::ValuesIn(Lengths), testing::Values(1, 4)),
  [](const auto& info) { return std::get<0>(info.param).Name + "Samples" + std::to_string(std::get<1>(info.param)); });

//------------------------------------------------------------------------------
class TestStorageOfTechniques
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Storage, Technique, int>>
{
};

TEST_P(TestStorageOfTechniques, DrawsAsLinkedListsDo)
{
  const auto& [storage, technique, samples] = GetParam();
  ExpectSamePictures(storage, technique, {}, samples, false);
}

// All techniques but the first one, which others draw.
INSTANTIATE_TEST_SUITE_P(Designs, TestStorageOfTechniques,
  testing::Combine(testing::Values(TBuffer, MBufferOf4, RBuffer),
    testing::ValuesIn(std::vector<Technique>(Techniques.begin() + 1, Techniques.end())), testing::Values(1, 4)),
  [](const auto& info)
  {
    return std::get<0>(info.param).Name + std::get<1>(info.param).Name + "Samples" +
      std::to_string(std::get<2>(info.param));
  });

//------------------------------------------------------------------------------
using TestStorageOrder = RenderTest;

// What the R-buffer's order does to adaptive transparency is what drawing from the farthest on would do.
TEST_F(TestStorageOrder, RBuffersFragmentsComeFromTheNearestOn)
{
  const AnalyticScene scene = RandomMosaic(80, 60, 61, 60, 0.02, 0.3);
  View view(scene);
  const auto byDepth = [](std::vector<Reference::Fragment> fragments)
  {
    std::stable_sort(fragments.begin(), fragments.end(),
      [](const Reference::Fragment& a, const Reference::Fragment& b) { return a.Depth > b.Depth; });
    return fragments;
  };
  for (int nodes : { 4, 8, 16 })
  {
    SCOPED_TRACE(nodes);
    const Compositor composite = AdaptiveCompositor(nodes, Reference::Removal::Underestimate);
    const Picture expected = scene.RoundedToHalf().Compute(
      [&](const std::vector<Reference::Fragment>& fragments) { return composite(byDepth(fragments)); });
    const auto pass = New(RBuffer, "adaptive", { { "nodes", std::to_string(nodes) } });
    view.SetPass(pass);
    EXPECT_LE(Compare(view.Render(), expected).Largest, nodes < 16 ? 2 : 1);
    const auto lists = New(LinkedList, "adaptive", { { "nodes", std::to_string(nodes) } });
    view.SetPass(lists);
    EXPECT_GT(Compare(view.Render(), expected).Largest, nodes < 16 ? 2 : 1) << "the order matters";
  }
}

// A pass over a queue is one, in however many drawings.
TEST_F(TestStorageOrder, QueuesThatAreReadInPartsGiveTheSamePictureAndCounts)
{
  for (int samples : { 1, 4 })
  {
    SCOPED_TRACE(samples);
    View view(RandomMosaic(40, 30, 62, 12, 0.02, 0.3), samples);
    AddBall(view.Renderer, false, 20, 10, 0);
    const auto whole = NewCounting(RBuffer.Options);
    view.SetPass(whole);
    const Picture expected = view.Render();
    for (int most : { 8, 500 })
    {
      SCOPED_TRACE(most);
      const auto parts = NewCounting(RBuffer.Options);
      vtkRBufferStorage::SafeDownCast(parts->GetStorage())->SetQueueReads(most);
      view.SetPass(parts);
      EXPECT_EQ(Compare(view.Render(), expected).Largest, 0);
      EXPECT_EQ(parts->GetStatistics()->GetFallback(), "");
      EXPECT_EQ(parts->GetStatistics()->GetFragments(), whole->GetStatistics()->GetFragments());
      EXPECT_EQ(parts->GetReads(), whole->GetReads());
      EXPECT_EQ(parts->GetSecondDepthAccesses(), whole->GetSecondDepthAccesses());
      EXPECT_EQ(parts->GetFrameBufferAccesses(), whole->GetFrameBufferAccesses());
      EXPECT_GT(parts->GetStatistics()->GetScreenPasses(), whole->GetStatistics()->GetScreenPasses());
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
// Notes what is read of buffers while it lives, each of which waits for the GPU.
class WatchedReads
{
public:
  WatchedReads()
  {
    Reads.clear();
    Read = glGetBufferSubData;
    glGetBufferSubData = [](GLenum target, GLintptr offset, GLsizeiptr bytes, void* data)
    {
      Reads.push_back(bytes);
      Read(target, offset, bytes, data);
    };
  }
  ~WatchedReads() { glGetBufferSubData = Read; }
  WatchedReads(const WatchedReads&) = delete;
  WatchedReads& operator=(const WatchedReads&) = delete;

  static inline std::vector<vtkTypeInt64> Reads; // bytes

private:
  static inline decltype(glGetBufferSubData) Read = nullptr;
};
}

TEST_F(TestStorageOrder, OneWaitAFrameIsEnough)
{
  View view(RandomLayers(400, 300, 67, 10, 0.02, 0.5));
  view.Render();
  if (KeepsDrawOrder(view))
  {
    GTEST_SKIP() << "the application has a part in counting";
  }
  for (const char* technique : { "exact", "adaptive", "fourier" })
  {
    for (const Storage& storage : { LinkedList, TBuffer, MBuffer })
    {
      SCOPED_TRACE(technique + storage.Name);
      const auto pass = New(storage, technique);
      view.SetPass(pass);
      view.Render();
      view.Render();
      const WatchedReads watch;
      view.Render();
      const vtkTypeInt64 counters = 25 * 19 * 64; // of the frame before, which nothing is drawn to any more
      const vtkTypeInt64 words = 32;
      EXPECT_EQ(WatchedReads::Reads, (std::vector<vtkTypeInt64>{ counters, words }));
    }
  }
}

//------------------------------------------------------------------------------
class TestStorageRoom
  : public RenderTest
  , public testing::WithParamInterface<Storage>
{
};

TEST_P(TestStorageRoom, WhatDidNotFitIsDrawnOnce)
{
  View view(RandomLayers(120, 90, 68, 40, 0.02, 0.5));
  for (const char* technique : { "exact", "adaptive", "fourier" })
  {
    SCOPED_TRACE(technique);
    const auto pass = New(GetParam(), technique);
    CellStorageOf(pass)->SetInitialFragments(120 * 90);
    view.SetPass(pass);
    const Picture first = view.Render();
    EXPECT_EQ(Compare(view.Render(), first).Largest, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Designs, TestStorageRoom, testing::ValuesIn(Designs), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestStorageOfPoints = RenderTest;

namespace
{
// Points as large as a pixel, in the order of their indices.
vtkSmartPointer<vtkActor> NewPoints(
  int count, const std::function<std::array<double, 2>(int)>& pixelOf, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> depth(0.01, 0.99);
  std::uniform_int_distribution<int> byte(0, 255);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto pixel = pixelOf(static_cast<int>(i));
    points->InsertNextPoint(pixel[0] + 0.5, pixel[1] + 0.5, 1 - 2 * depth(random));
    vertices->InsertNextCell(1, &i);
    for (int channel = 0; channel < 4; ++channel)
    {
      colors->InsertNextValue(static_cast<unsigned char>(channel < 3 ? byte(random) : 1 + byte(random) / 20));
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->SetScalars(colors);
  auto actor = NewUnlitActor(data, { { 1, 1, 1 } }, 0.5);
  actor->GetProperty()->SetPointSize(1);
  return actor;
}

void ExpectTheSameFrom(const std::vector<Storage>& storages, int width, int height, int count,
  const std::function<std::array<double, 2>(int)>& pixelOf, vtkTypeInt64 deepest)
{
  AnalyticScene empty;
  empty.Width = width;
  empty.Height = height;
  View view(empty);
  view.Renderer->AddActor(NewPoints(count, pixelOf, 41));
  Picture expected;
  for (const Storage& storage : storages)
  {
    SCOPED_TRACE(storage.Name);
    const auto pass = NewCounting(storage.Options);
    view.SetPass(pass);
    const Picture drawn = view.Render();
    vtkTranslucencyStatistics* statistics = pass->GetStatistics();
    EXPECT_EQ(statistics->GetFragments(), count);
    EXPECT_EQ(statistics->GetDeepestPixel(), pass->GetHistogram().Pixels.rbegin()->first);
    if (deepest > 0)
    {
      EXPECT_EQ(statistics->GetDeepestPixel(), deepest);
    }
    ExpectClosedForms(pass);
    if (expected.Rgb.empty())
    {
      expected = drawn;
    }
    EXPECT_EQ(Compare(drawn, expected).Largest, 0);
  }
}

std::array<double, 2> OnOnePixel(int)
{
  return { { 20, 10 } };
}
}

TEST_F(TestStorageOfPoints, AMillionOver4096Pixels)
{
  std::mt19937 random(42);
  std::uniform_int_distribution<int> pixel(0, 63);
  std::vector<std::array<double, 2>> pixels(1000000);
  for (auto& at : pixels)
  {
    at = { { static_cast<double>(pixel(random)), static_cast<double>(pixel(random)) } };
  }
  ExpectTheSameFrom(
    { LinkedList, TBuffer, Sections("T", "t-buffer", 1), Sections("T", "t-buffer", 64), MBuffer, RBuffer }, 64, 64,
    1000000, [&](int i) { return pixels[i]; }, 0);
}

TEST_F(TestStorageOfPoints, OnePixelOf100000)
{
  ExpectTheSameFrom({ LinkedList, TBuffer, MBuffer }, 40, 30, 100000, OnOnePixel, 100000);
}

// As many passes as fragments, each of which reads what is left.
TEST_F(TestStorageOfPoints, OnePixelOf3000InTheRBuffer)
{
  ExpectTheSameFrom({ LinkedList, RBuffer }, 40, 30, 3000, OnOnePixel, 3000);
}

// 5,000,050,000 reads, one behind the other: a quarter of an hour, so only by --gtest_also_run_disabled_tests.
TEST_F(TestStorageOfPoints, DISABLED_OnePixelOf100000InTheRBuffer)
{
  ExpectTheSameFrom({ LinkedList, RBuffer }, 40, 30, 100000, OnOnePixel, 100000);
}

//------------------------------------------------------------------------------
using TestStorageProperties = RenderTest;

TEST_F(TestStorageProperties, MBuffersSectionsFollowTheScene)
{
  View view(RandomMosaic(150, 100, 51, 13, 0.05, 0.5));
  const auto pass = New(MBuffer);
  auto* storage = vtkMBufferStorage::SafeDownCast(pass->GetStorage());
  view.SetPass(pass);
  const Picture first = view.Render();
  EXPECT_NE(storage->GetSectionLength(), 13);
  EXPECT_EQ(Compare(view.Render(), first).Largest, 0);
  EXPECT_EQ(storage->GetSectionLength(), 13);
  EXPECT_EQ(Compare(view.Render(), first).Largest, 0);
  EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0) << "the length stays, so do the shaders";

  pass->SetSectionLength(3);
  EXPECT_FALSE(storage->GetAutomaticSectionLength());
  EXPECT_EQ(Compare(view.Render(), first).Largest, 0);
  EXPECT_EQ(Compare(view.Render(), first).Largest, 0);
  EXPECT_EQ(storage->GetSectionLength(), 3);
  storage->AutomaticSectionLengthOn();
  view.Render();
  EXPECT_EQ(storage->GetSectionLength(), 13);
}

// What the T-buffer is for.
TEST_F(TestStorageProperties, EmptyPixelsCostTheTBufferTheirEntry)
{
  const auto bytesOf = [](const Storage& storage, int width)
  {
    AnalyticScene scene;
    scene.Width = width;
    scene.Height = 256;
    scene.Translucent = { { { 0, 0, 64, 64, 0.5, { { 1, 0, 0 } }, 0.5 } } };
    View view(scene);
    const auto pass = New(storage);
    CellStorageOf(pass)->SetInitialFragments(16);
    view.SetPass(pass);
    view.Render();
    return static_cast<double>(pass->GetStorage()->GetBytes());
  };
  const double pixels = 256 * 256;
  const double counters = 2 * 64.0 / 256; // and their copy
  EXPECT_DOUBLE_EQ(bytesOf(TBuffer, 512) - bytesOf(TBuffer, 256), pixels * (4 + counters));
  EXPECT_GE(bytesOf(MBuffer, 512) - bytesOf(MBuffer, 256), pixels * (4 + counters + 12));
}

// Fragments that resolves fetch have to be within the reach of fetches, whatever else there is room for.
TEST_F(TestStorageProperties, HoldNoMoreThanTheDriverCanFetch)
{
  const vtkFragmentStorage::Rectangle viewport{ { 0, 0, 10, 10 } };
  vtkTranslucencyCapabilities capabilities;
  capabilities.MaximumBlockBytes = 1 << 30;
  capabilities.MaximumTexels = 1200;
  const auto expectMost = [&](vtkFragmentStorage* storage, int units)
  {
    SCOPED_TRACE(storage->GetClassName());
    storage->BeginFrame({}, capabilities);
    EXPECT_TRUE(storage->Fits(units, viewport, capabilities));
    EXPECT_FALSE(storage->Fits(units + 1, viewport, capabilities));
  };
  vtkNew<vtkLinkedListStorage> lists;
  vtkNew<vtkTBufferStorage> sections; // of four fragments in three texels
  expectMost(lists, 1200);
  expectMost(sections, 400);
  capabilities.KeepsDrawOrder = true; // four nodes at a time
  expectMost(lists, 300);
  expectMost(sections, 400);
  lists->SetColorFormat(vtkFragmentStorage::RGBA8); // three words in a texel of three
  expectMost(lists, 300);
  lists->SetChannelsAndSamples(3, 1);
  expectMost(lists, 300);
  lists->SetColorFormat(vtkFragmentStorage::HalfFloat); // nodes of five words are not fetched
  EXPECT_TRUE(lists->Fits(301, viewport, capabilities));
}

TEST_F(TestStorageProperties, AnotherDesignKeepsTheOthersSettings)
{
  vtkNew<vtkABufferPass> pass;
  pass->GetStorage()->SetMemoryLimit(12);
  pass->GetStorage()->SetColorFormat(vtkFragmentStorage::RGBA8);
  pass->SetSectionLength(7); // before there are sections
  pass->SetStorageDesign(vtkFragmentListPass::TBuffer);
  EXPECT_EQ(pass->GetStorageDesign(), vtkFragmentListPass::TBuffer);
  EXPECT_EQ(pass->GetStorage()->GetMemoryLimit(), 12);
  EXPECT_EQ(pass->GetStorage()->GetColorFormat(), vtkFragmentStorage::RGBA8);
  EXPECT_EQ(vtkTBufferStorage::SafeDownCast(pass->GetStorage())->GetSectionLength(), 7);
}

TEST_F(TestStorageProperties, WhatFixedMemoryDoesNotUseIsToldOnce)
{
  const AnalyticScene scene = RandomLayers(40, 30, 52, 3, 0.1, 0.5);
  View view(scene);
  vtkNew<vtkFourierOpacityPass> pass;
  pass->SetMemory(vtkFourierOpacityPass::Fixed);
  view.SetPass(pass);
  view.Render();
  EXPECT_TRUE(TakeMessages().empty());
  pass->SetStorageDesign(vtkFragmentListPass::MBuffer);
  for (const char* expected : { "StorageDesign is m-buffer, but Memory is Fixed",
         "StorageDesign is m-buffer, MemoryLimit is 12, but Memory is Fixed" })
  {
    view.Render();
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
    view.Render();
    EXPECT_TRUE(TakeMessages().empty());
    pass->GetStorage()->SetMemoryLimit(12);
  }
}

TEST_F(TestStorageProperties, ASectionLengthWithoutSectionsIsToldOnce)
{
  const AnalyticScene scene = RandomLayers(40, 30, 52, 3, 0.1, 0.5);
  View view(scene);
  vtkNew<vtkABufferPass> pass;
  pass->SetSectionLength(7);
  view.SetPass(pass);
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(
    messages[0].find("SectionLength is 7, but linked-list has no sections, expected the storage t-buffer or m-buffer"),
    std::string::npos)
    << messages[0];
  view.Render();
  EXPECT_TRUE(TakeMessages().empty());
}

TEST_F(TestStorageProperties, BadValuesAreErrorsAndChangeNothing)
{
  const auto expect = [](const std::string& text)
  {
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u) << text;
    EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
  };
  vtkNew<vtkABufferPass> pass;
  pass->SetStorageDesign(vtkFragmentListPass::MBuffer);
  pass->SetSectionLength(5);
  for (int length : { 0, 65, 10000, -1 })
  {
    pass->SetSectionLength(length);
    expect("SectionLength is " + std::to_string(length) + ", expected 1 to 64");
    vtkSectionStorage::SafeDownCast(pass->GetStorage())->SetSectionLength(length);
    expect("SectionLength is " + std::to_string(length) + ", expected 1 to 64");
  }
  EXPECT_EQ(pass->GetSectionLength(), 5);
  EXPECT_EQ(CellStorageOf(pass)->GetSectionFragments(), 5);
  pass->SetStorageDesign(4);
  expect("StorageDesign is 4, expected");
  pass->SetStorageDesign(-1);
  expect("StorageDesign is -1, expected");
  EXPECT_EQ(pass->GetStorageDesign(), vtkFragmentListPass::MBuffer);
  CellStorageOf(pass)->SetInitialFragments(-1);
  expect("InitialFragments is -1, expected 0 or more");
  EXPECT_EQ(CellStorageOf(pass)->GetInitialFragments(), 0);
  vtkNew<vtkRBufferStorage> queues;
  queues->SetQueueReads(0);
  expect("QueueReads is 0, expected 1 or more");
  EXPECT_EQ(queues->GetQueueReads(), 32768);
  vtkNew<vtkMBufferStorage> automatic;
  automatic->SetSectionLength(0);
  expect("SectionLength is 0");
  EXPECT_TRUE(automatic->GetAutomaticSectionLength());
}

// Tables of pixels take memory before there is any fragment.
TEST_F(TestStorageProperties, ALimitTooSmallForTheTablesIsAnErrorAndFallsBack)
{
  for (const Storage& storage : { TBuffer, MBuffer, RBuffer })
  {
    SCOPED_TRACE(storage.Name);
    const AnalyticScene scene = RandomLayers(400, 300, 13, 10, 0.02, 0.5);
    View view(scene);
    const auto pass = New(storage);
    pass->GetStorage()->SetMemoryLimit(0.002);
    view.SetPass(pass);
    view.Render();
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("MemoryLimit is 0.002 MiB, expected at least"), std::string::npos) << messages[0];
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
  }
}
