// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes among translucent surfaces: what a ray gathers on its way from one surface to the next is a fragment between
// them.
#include "GLState.h"
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellStorage.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkFragmentStorage.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkVolumetricPass.h>

#include <array>
#include <cmath>
#include <functional>

namespace
{
using Color = std::array<double, 3>;

constexpr double Background[3] = { 0.2, 0.4, 0.6 };
constexpr int Width = 120;
constexpr int Height = 100;

// A cube of edge 1 around the origin, of the values that a function gives.
vtkSmartPointer<vtkImageData> NewCube(const std::function<double(double, double, double)>& value)
{
  constexpr int points = 25;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->SetSpacing(1.0 / (points - 1), 1.0 / (points - 1), 1.0 / (points - 1));
  image->SetOrigin(-0.5, -0.5, -0.5);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* at = image->GetPoint(i);
    out[i] = static_cast<float>(value(at[0], at[1], at[2]));
  }
  return image;
}

// Opacity grows with the value, from 0 to mostOpacity in a distance of 0.1.
vtkSmartPointer<vtkVolume> NewVolume(
  vtkVolumeMapper* mapper, vtkImageData* data, const Color& low, const Color& high, double mostOpacity)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0);
  opacity->AddPoint(1, mostOpacity);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0, low[0], low[1], low[2]);
  colors->AddRGBPoint(1, high[0], high[1], high[2]);
  mapper->SetInputData(data);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  return volume;
}

vtkSmartPointer<vtkGPUVolumeRayCastMapper> NewRayCaster(double sampleDistance)
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(static_cast<float>(sampleDistance));
  return mapper;
}

vtkSmartPointer<vtkVolume> NewCloud(vtkVolumeMapper* mapper)
{
  const auto data = NewCube([](double x, double y, double z)
    { return std::max(0.0, 1 - 1.8 * std::sqrt(x * x + y * y + z * z)) * (0.6 + 0.4 * std::sin(20 * x + 9 * z)); });
  return NewVolume(mapper, data, { { 0.2, 0.5, 1 } }, { { 1, 0.6, 0.1 } }, 0.6);
}

struct Sheet
{
  double Z;
  Color Rgb;
  double Alpha;
};

const std::vector<Sheet> Sheets{ { 0.7, { { 1, 0, 0 } }, 0.3 }, { 0.21, { { 0, 1, 0 } }, 0.4 },
  { -0.12, { { 1, 1, 0 } }, 0.25 }, { -0.8, { { 1, 0, 1 } }, 0.5 } };

void AddSheet(vtkRenderer* renderer, const Sheet& sheet)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-3, -3, sheet.Z);
  source->SetPoint1(3, -3, sheet.Z);
  source->SetPoint2(-3, 3, sheet.Z);
  source->Update();
  renderer->AddActor(NewUnlitActor(source->GetOutput(), { { sheet.Rgb[0], sheet.Rgb[1], sheet.Rgb[2] } }, sheet.Alpha));
}

void AddSheets(vtkRenderer* renderer)
{
  for (const Sheet& sheet : Sheets)
  {
    AddSheet(renderer, sheet);
  }
}

// Through the middle.
void AddOpaque(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-0.1, -0.5, -0.3);
  source->SetPoint1(0.3, -0.5, 0.2);
  source->SetPoint2(-0.1, 0.1, -0.1);
  source->Update();
  renderer->AddActor(NewUnlitActor(source->GetOutput(), { { 0.9, 0.9, 0.8 } }, 1));
}

void SetCamera(vtkRenderer* renderer, const std::array<double, 3>& position, bool parallel = false)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(position.data());
  camera->SetFocalPoint(0, 0, 0);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(0.8);
  camera->SetClippingRange(0.05, 10);
  renderer->SetBackground(Background[0], Background[1], Background[2]);
}

class VolumeView : public View
{
public:
  explicit VolumeView(
    const std::array<double, 3>& position = { { 0.9, 0.7, 2.4 } }, bool parallel = false, int samples = 0)
    : View(Width, Height, samples)
  {
    SetCamera(this->Renderer, position, parallel);
  }
};

struct Technique
{
  const char* Name;
  vtkSmartPointer<vtkFragmentListPass> (*New)();
};

void PrintTo(const Technique& technique, std::ostream* os)
{
  *os << technique.Name;
}

template <typename Pass>
vtkSmartPointer<vtkFragmentListPass> New()
{
  return vtkSmartPointer<Pass>::New();
}

class TestVolumes
  : public RenderTest
  , public testing::WithParamInterface<Technique>
{
};
using TestVolume = RenderTest;
}

//------------------------------------------------------------------------------
TEST_P(TestVolumes, OfOneDensityAsComputed)
{
  constexpr double opacity = 0.12; // in a distance of 0.1
  const Color rgb{ { 0.1, 0.8, 0.9 } };
  const auto data = NewCube([](double, double, double) { return 1.0; });
  for (bool volumeFirst : { true, false })
  {
    VolumeView view({ { 0, 0, 3 } }, true);
    const auto volume = NewVolume(NewRayCaster(0.001), data, rgb, rgb, opacity);
    if (volumeFirst)
    {
      view.Renderer->AddViewProp(volume);
    }
    for (std::size_t i = 0; i < Sheets.size(); ++i)
    {
      AddSheet(view.Renderer, Sheets[volumeFirst ? i : Sheets.size() - 1 - i]);
    }
    if (!volumeFirst)
    {
      view.Renderer->AddViewProp(volume);
    }
    const auto pass = GetParam().New();
    view.SetPass(pass);
    const Picture drawn = view.Render();
    for (int channel = 0; channel < 3; ++channel)
    {
      // From back to front: inside, the ray crosses the cube from sheet to sheet; outside, there are only sheets.
      double inside = Background[channel];
      double outside = Background[channel];
      double at = -0.5;
      const auto cross = [&](double to)
      {
        const double transmittance = std::pow(1 - opacity, std::max(0.0, to - at) / 0.1);
        inside = inside * transmittance + rgb[channel] * (1 - transmittance);
        at = std::max(at, to);
      };
      for (auto sheet = Sheets.rbegin(); sheet != Sheets.rend(); ++sheet)
      {
        cross(std::min(0.5, sheet->Z));
        inside += sheet->Alpha * (sheet->Rgb[channel] - inside);
        outside += sheet->Alpha * (sheet->Rgb[channel] - outside);
        if (sheet->Z < 0.5 && std::next(sheet) != Sheets.rend() && std::next(sheet)->Z > 0.5)
        {
          cross(0.5);
        }
      }
      EXPECT_NEAR(drawn.At(Width / 2 + 7, Height / 2 - 5, channel), 255 * inside, 1.5) << volumeFirst << " " << channel;
      EXPECT_NEAR(drawn.At(3, 4, channel), 255 * outside, 1) << volumeFirst << " " << channel;
    }
    view.Render();
    EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);
    EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 1);
  }
}

//------------------------------------------------------------------------------
TEST_P(TestVolumes, AddedInAnyOrderGiveTheSamePicture)
{
  Picture first;
  for (bool volumeFirst : { true, false })
  {
    VolumeView view;
    AddOpaque(view.Renderer);
    const auto volume = NewCloud(NewRayCaster(0.01));
    if (volumeFirst)
    {
      view.Renderer->AddViewProp(volume);
    }
    AddSheets(view.Renderer);
    if (!volumeFirst)
    {
      view.Renderer->AddViewProp(volume);
    }
    const auto pass = GetParam().New();
    view.SetPass(pass);
    const Picture drawn = view.Render();
    if (volumeFirst)
    {
      first = drawn;
    }
    EXPECT_EQ(Compare(first, drawn).Largest, 0);
    // Frames that grow, tiles and what stands in a chain draw the same.
    EXPECT_EQ(Compare(first, view.Render()).Largest, 0);
    pass->GetStorage()->SetMemoryLimit(0.2);
    EXPECT_EQ(Compare(first, view.Render()).Largest, 0);
    EXPECT_GT(pass->GetStatistics()->GetTiles(), 1);
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetTranslucentPass(pass);
    pass->SetVolumetricPass(steps->GetVolumetricPass());
    steps->SetVolumetricPass(nullptr);
    view.SetPass(steps);
    EXPECT_EQ(Compare(first, view.Render()).Largest, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, TestVolumes,
  testing::Values(Technique{ "exact", New<vtkABufferPass> }, Technique{ "adaptive", New<vtkAdaptiveTransparencyPass> }),
  [](const auto& info) { return info.param.Name; });

namespace
{
struct Storage
{
  std::string Name;
  Settings Options;
  int Passes; // over the geometry in the first frame, at least: gathering may have to grow the storage, and then
              // inserting
};

void PrintTo(const Storage& storage, std::ostream* os)
{
  *os << storage.Name;
}

class TestVolumesInStorage
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Storage, const char*, int>>
{
protected:
  static vtkSmartPointer<vtkFragmentListPass> NewPass(const Settings& settings)
  {
    const auto pass = NewTechnique(std::get<1>(GetParam()), settings);
    return vtkFragmentListPass::SafeDownCast(pass);
  }
};
}

//------------------------------------------------------------------------------
// What a ray gathers is inserted into lists that the storage has already sorted.
TEST_P(TestVolumesInStorage, AreAsInLinkedLists)
{
  const auto& [storage, technique, samples] = GetParam();
  VolumeView view({ { 0.9, 0.7, 2.4 } }, false, samples);
  AddOpaque(view.Renderer);
  AddSheets(view.Renderer);
  const auto linked = NewPass({});
  view.SetPass(linked);
  const Picture sheets = view.Render();
  const vtkTypeInt64 stored = linked->GetStatistics()->GetFragments();
  view.Renderer->AddViewProp(NewCloud(NewRayCaster(0.01)));
  const Picture expected = view.Render();
  EXPECT_GT(Compare(sheets, expected).RootMeanSquare, 0.03) << "the volume is seen";
  const vtkTypeInt64 fragments = linked->GetStatistics()->GetFragments();
  EXPECT_GT(fragments, stored) << "the volume's are inserted";

  const auto pass = NewPass(storage.Options);
  vtkCellStorage::SafeDownCast(pass->GetStorage())->SetInitialFragments(16);
  view.SetPass(pass);
  for (double limit : { 0.0, 0.0, 0.0, 0.3, 0.3 })
  {
    SCOPED_TRACE(limit);
    const bool first = pass->GetStatistics()->GetFragments() == 0;
    pass->GetStorage()->SetMemoryLimit(limit);
    EXPECT_EQ(Compare(view.Render(), expected).Largest, 0);
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    EXPECT_EQ(pass->GetStatistics()->GetFragments(), fragments);
    EXPECT_EQ(pass->GetStatistics()->GetTiles() > 1, limit > 0);
    if (first)
    {
      EXPECT_GE(pass->GetStatistics()->GetGeometryPasses(), storage.Passes);
    }
  }
  const auto counting = NewCounting(storage.Options);
  view.SetPass(counting);
  view.Render();
  EXPECT_EQ(counting->GetStatistics()->GetFragments(), fragments);
  EXPECT_EQ(counting->GetStores(), fragments);
  if (counting->GetStorageDesign() != vtkFragmentListPass::RBuffer) // which reads what is in its queue in every pass
  {
    EXPECT_EQ(counting->GetReads(), fragments);
  }
}

namespace
{
// All but the linked lists, which others draw.
std::vector<Storage> OtherStorages()
{
  std::vector<Storage> storages;
  for (const std::string& name : AllStorages())
  {
    if (name != "linked-list")
    {
      // The M-buffer has room for some fragments of each pixel from the start.
      storages.push_back({ StorageInNames(name), { { "storage", name } }, name == "m-buffer" ? 2 : 3 });
    }
  }
  return storages;
}

Storage Sections(const char* name, const char* design, const char* length, int passes)
{
  return { name, { { "storage", design }, { "section_length", length } }, passes };
}

std::string NameOf(const testing::TestParamInfo<std::tuple<Storage, const char*, int>>& info)
{
  const auto& [storage, technique, samples] = info.param;
  return storage.Name + ("_" + std::string(technique)) + "Samples" + std::to_string(samples);
}
}

INSTANTIATE_TEST_SUITE_P(Designs, TestVolumesInStorage,
  testing::Combine(testing::ValuesIn(OtherStorages()), testing::Values("exact", "adaptive"), testing::Values(0, 4)),
  NameOf);

// Inserted fragments find room in the sections that gathering has to spare, or not.
INSTANTIATE_TEST_SUITE_P(SectionLengths, TestVolumesInStorage,
  testing::Combine(testing::Values(Sections("T1", "t-buffer", "1", 3), Sections("T64", "t-buffer", "64", 2),
                     Sections("M1", "m-buffer", "1", 3), Sections("M64", "m-buffer", "64", 2)),
    testing::Values("exact"), testing::Values(0)),
  NameOf);

namespace
{
struct Cast
{
  const char* Name;
  std::array<double, 3> Position{ { 0.9, 0.7, 2.4 } };
  bool Parallel = false;
  int Samples = 0;
  std::function<void(vtkGPUVolumeRayCastMapper*, vtkVolume*)> Change = [](vtkGPUVolumeRayCastMapper*, vtkVolume*) {};
};

void PrintTo(const Cast& cast, std::ostream* os)
{
  *os << cast.Name;
}

class TestRays
  : public RenderTest
  , public testing::WithParamInterface<Cast>
{
protected:
  void AddVolume(View& view)
  {
    const auto mapper = NewRayCaster(0.01);
    const auto volume = NewCloud(mapper);
    GetParam().Change(mapper, volume);
    view.Renderer->AddViewProp(volume);
    AddOpaque(view.Renderer);
  }
};
}

//------------------------------------------------------------------------------
// Each sample of a ray belongs to one segment: what hardly is there changes nothing but the rounding of colours to half
// floats.
TEST_P(TestRays, AreCastThroughInvisibleSurfacesAsWithout)
{
  VolumeView view(GetParam().Position, GetParam().Parallel, GetParam().Samples);
  this->AddVolume(view);
  const Picture alone = view.Render();
  for (int i = 0; i < 12; ++i)
  {
    AddSheet(view.Renderer, { 0.65 - 0.113 * i, { { 0.5, 0.5, 0.5 } }, 1e-4 });
  }
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const PictureDifference difference = Compare(alone, view.Render());
  EXPECT_LE(difference.Largest, 2) << difference;
  EXPECT_LE(difference.RootMeanSquare, 0.002) << difference;
  EXPECT_GE(pass->GetStatistics()->GetDeepestPixel(), 13);
  view.Renderer->RemoveAllViewProps();
  EXPECT_GT(Compare(alone, view.Render()).RootMeanSquare, 0.05) << "the volume is seen";
}

namespace
{
// Some rays then have a last sample that lies at their end, to rounding.
void Clip(vtkGPUVolumeRayCastMapper* mapper, vtkVolume*)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 0, 0.1);
  plane->SetNormal(0.4, 0.1, -0.8);
  mapper->AddClippingPlane(plane);
}
}

INSTANTIATE_TEST_SUITE_P(Casts, TestRays,
  testing::Values(Cast{ "Perspective" }, Cast{ "FromTheSide", { { 2.2, 0.4, 0.9 } } },
    Cast{ "Parallel", { { 0.9, 0.7, 2.4 } }, true }, Cast{ "FromWithin", { { 0.1, 0.05, 0.4 } } },
    Cast{ "FourSamples", { { 0.9, 0.7, 2.4 } }, false, 4 },
    Cast{ "FourSamplesDenseToItsEdges", { { 0.9, 0.7, 2.4 } }, false, 4,
      [](auto*, auto* volume) { volume->GetProperty()->GetScalarOpacity()->AddPoint(0, 0.999); } },
    Cast{ "Jittered", { { 0.9, 0.7, 2.4 } }, false, 0, [](auto* mapper, auto*) { mapper->SetUseJittering(1); } },
    Cast{ "Shaded", { { 0.9, 0.7, 2.4 } }, false, 0, [](auto*, auto* volume) { volume->GetProperty()->ShadeOn(); } },
    Cast{ "Isosurfaces", { { 0.9, 0.7, 2.4 } }, false, 0,
      [](auto* mapper, auto* volume)
      {
        mapper->SetBlendMode(vtkVolumeMapper::ISOSURFACE_BLEND);
        volume->GetProperty()->GetIsoSurfaceValues()->GenerateValues(3, 0.1, 0.6);
      } },
    Cast{ "Slice", { { 0.9, 0.7, 2.4 } }, false, 0,
      [](auto* mapper, auto* volume)
      {
        mapper->SetBlendMode(vtkVolumeMapper::SLICE_BLEND);
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0.4, 0.3, 0.9);
        volume->GetProperty()->SetSliceFunction(plane);
      } },
    Cast{ "DenseToItsEdges", { { 0.9, 0.7, 2.4 } }, false, 0,
      [](auto*, auto* volume) { volume->GetProperty()->GetScalarOpacity()->AddPoint(0, 0.999); } },
    Cast{ "ColorsScaled", { { 0.9, 0.7, 2.4 } }, false, 0,
      [](auto* mapper, auto*)
      {
        mapper->SetFinalColorWindow(0.6f);
        mapper->SetFinalColorLevel(0.4f);
      } },
    Cast{ "Clipped", { { 0.9, 0.7, 2.4 } }, false, 0, Clip },
    Cast{ "ClippedFromTheLeft", { { 0.15, 0.7, 2.56 } }, false, 0, Clip },
    Cast{ "Cropped", { { 0.9, 0.7, 2.4 } }, false, 0,
      [](auto* mapper, auto*)
      {
        mapper->SetCropping(1);
        mapper->SetCroppingRegionPlanes(-0.3, 0.2, -0.2, 0.4, -0.1, 0.3);
      } },
    Cast{ "Transformed", { { 0.9, 0.7, 2.4 } }, false, 0,
      [](auto*, auto* volume)
      {
        volume->SetScale(1.4, 0.6, 0.8);
        volume->RotateY(40);
        volume->SetPosition(0.1, 0.1, -0.2);
      } }),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
TEST_F(TestVolume, StandsInAViewportAsInAWindow)
{
  VolumeView alone;
  View pair(Width * 2 + 30, Height + 20);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0, 0, 0.4, 0.5);
  pair.Window->AddRenderer(left);
  const double width = Width * 2 + 30;
  const double height = Height + 20;
  pair.Renderer->SetViewport((width - Width - 7) / width, 15 / height, (width - 7) / width, (15.0 + Height) / height);
  SetCamera(pair.Renderer, { { 0.9, 0.7, 2.4 } });
  SetCamera(left, { { 0.9, 0.7, 2.4 } });
  vtkNew<vtkABufferPass> passAlone;
  vtkNew<vtkABufferPass> passOfLeft;
  vtkNew<vtkABufferPass> passOfRight;
  for (vtkRenderer* renderer : { alone.Renderer.Get(), pair.Renderer.Get(), left.Get() })
  {
    renderer->AddViewProp(NewCloud(NewRayCaster(0.01)));
    AddOpaque(renderer);
    AddSheets(renderer);
  }
  alone.SetPass(passAlone);
  left->SetPass(passOfLeft);
  pair.SetPass(passOfRight);
  const PictureDifference difference = Compare(alone.Render(), Crop(pair.Render(), Width + 23, 15, Width, Height));
  EXPECT_LE(difference.Largest, 1) << difference;
}

//------------------------------------------------------------------------------
TEST_F(TestVolume, WithoutSurfacesIsAsWithoutAPass)
{
  VolumeView view;
  view.Renderer->AddViewProp(NewCloud(NewRayCaster(0.01)));
  const Picture stock = view.Render();
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  view.SetPass(pass);
  EXPECT_EQ(Compare(stock, view.Render()).Largest, 0);
  vtkTranslucencyFactory::Enable(view.Renderer, "exact");
  EXPECT_EQ(Compare(stock, view.Render()).Largest, 0);
}

//------------------------------------------------------------------------------
// What casts its rays elsewhere is drawn over the surfaces, as VTK's steps do, and the pass says so, once.
TEST_F(TestVolume, ThatCantBeDividedIsDrawnOverTheSurfacesWithAWarning)
{
  const auto reduced = NewRayCaster(0.01);
  reduced->SetImageSampleDistance(2);
  vtkNew<vtkFixedPointVolumeRayCastMapper> onTheCpu;
  for (vtkVolumeMapper* mapper : { static_cast<vtkVolumeMapper*>(reduced), static_cast<vtkVolumeMapper*>(onTheCpu) })
  {
    VolumeView view;
    view.Renderer->AddViewProp(NewCloud(mapper));
    AddSheets(view.Renderer);
    vtkNew<vtkABufferPass> inAChain;
    view.SetTranslucentPass(inAChain);
    const Picture over = view.Render();
    vtkNew<vtkABufferPass> pass;
    view.SetPass(pass);
    EXPECT_LE(Compare(over, view.Render()).Largest, 1);
    EXPECT_LE(Compare(over, view.Render()).Largest, 1);
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find(
                std::string("volumes of ") + mapper->GetClassName() + " are drawn over the translucent surfaces"),
      std::string::npos)
      << messages[0];
  }
}

//------------------------------------------------------------------------------
TEST_F(TestVolume, LeavesTheStateOfOpenGLAsItWas)
{
  VolumeView view;
  view.Renderer->AddViewProp(NewCloud(NewRayCaster(0.01)));
  AddSheets(view.Renderer);
  class Spy : public vtkRenderPass
  {
  public:
    static Spy* New() { return new Spy; }
    void Render(const vtkRenderState* state) override
    {
      this->Inner->Render(state); // what VTK allocates and binds once is there then
      this->Before = QueryGLState();
      this->Inner->Render(state);
      this->After = QueryGLState();
      this->Errors = TakeGLErrors();
    }
    vtkRenderPass* Inner = nullptr;
    GLState Before;
    GLState After;
    std::vector<std::string> Errors;
  };
  vtkNew<Spy> spy;
  vtkNew<vtkABufferPass> pass;
  vtkNew<vtkVolumetricPass> volumes;
  pass->SetVolumetricPass(volumes);
  spy->Inner = pass;
  view.SetTranslucentPass(spy);
  view.Render();
  EXPECT_EQ(spy->Before, spy->After);
  EXPECT_EQ(spy->Errors, std::vector<std::string>());
}
