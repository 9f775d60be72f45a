// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Techniques of sums against their own theory, computed on the CPU: in double precision, or by the shaders' own text
// where that is no scalar product, or where sums are rounded.
#include "AbsorbanceShader.h"
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFourierOpacityPass.h>
#include <vtkFramebufferPass.h>
#include <vtkMomentTransparencyPass.h>
#include <vtkOpacityShadowMapPass.h>
#include <vtkPixelBufferObject.h>
#include <vtkPlaneSource.h>
#include <vtkTextureObject.h>
#include <vtkTranslucencyOption.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkWaveletTransparencyPass.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
struct Technique
{
  std::string Name;
  std::function<vtkSmartPointer<vtkAbsorbancePass>()> New;
  Reference::Visibilities Exact;   // of the sums as they are
  Reference::Visibilities Rounded; // of sums in half floats
};

void PrintTo(const Technique& technique, std::ostream* os)
{
  *os << technique.Name;
}

Technique Fourier(int coefficients)
{
  const auto create = [coefficients]
  {
    auto pass = vtkSmartPointer<vtkFourierOpacityPass>::New();
    pass->SetCoefficients(coefficients);
    return pass;
  };
  return { "Fourier" + std::to_string(coefficients), create,
    Reference::VisibilitiesOf(
      [coefficients](double at, double before) { return Reference::FourierShare(coefficients, at, before); }),
    TextOf("Fourier", coefficients, true) };
}

Technique Slices(int slices)
{
  const auto create = [slices]
  {
    auto pass = vtkSmartPointer<vtkOpacityShadowMapPass>::New();
    pass->SetSlices(slices);
    return pass;
  };
  return { "Slices" + std::to_string(slices), create,
    Reference::VisibilitiesOf([slices](double at, double before) { return Reference::SliceShare(slices, at, before); }),
    TextOf("Slices", slices, true) };
}

Technique Wavelet(int rank)
{
  const auto create = [rank]
  {
    auto pass = vtkSmartPointer<vtkWaveletTransparencyPass>::New();
    pass->SetRank(rank);
    return pass;
  };
  return { "Wavelet" + std::to_string(rank), create,
    Reference::VisibilitiesOf([rank](double at, double before) { return Reference::WaveletShare(rank, at, before); }),
    TextOf("Wavelet", rank, true) };
}

Technique Moments(int moments)
{
  const auto create = [moments]
  {
    auto pass = vtkSmartPointer<vtkMomentTransparencyPass>::New();
    pass->SetMoments(moments);
    return pass;
  };
  const std::string name = create()->GetOptions().front().Format(moments);
  return { "Moment" + name.substr(0, 1) + name.back(), create, TextOf("Moment", moments, false),
    TextOf("Moment", moments, true) };
}

/// How it is set up, and how many samples the window has.
struct Setup
{
  int Memory;
  int Bounds;
  bool Corrected;
  int Samples;
  int Precision = vtkAbsorbancePass::Single;

  std::string GetName() const
  {
    return std::string(this->Memory == vtkAbsorbancePass::Fixed ? "Fixed" : "Variable") +
      (this->Bounds == vtkAbsorbancePass::Fragments ? "Fragments" : "Props") + (this->Corrected ? "" : "Uncorrected") +
      (this->Precision == vtkAbsorbancePass::Half                ? "Half"
          : this->Precision == vtkAbsorbancePass::SharedExponent ? "Words"
                                                                 : "") +
      (this->Samples > 0 ? std::to_string(this->Samples) : "");
  }
};

void PrintTo(const Setup& setup, std::ostream* os)
{
  *os << setup.GetName();
}

std::vector<Setup> Setups()
{
  std::vector<Setup> setups;
  for (int memory : { vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Variable })
  {
    for (int bounds : { vtkAbsorbancePass::Fragments, vtkAbsorbancePass::Props })
    {
      setups.push_back({ memory, bounds, true, 0 });
      setups.push_back({ memory, bounds, true, 4 });
    }
    setups.push_back({ memory, vtkAbsorbancePass::Fragments, false, 0 });
  }
  setups.push_back({ vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Fragments, true, 0, vtkAbsorbancePass::Half });
  return setups;
}

class TestAbsorbancePass
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Technique, Setup>>
{
protected:
  vtkSmartPointer<vtkAbsorbancePass> NewPass() const
  {
    const auto& [technique, setup] = GetParam();
    auto pass = technique.New();
    pass->SetMemory(setup.Memory);
    pass->SetBounds(setup.Bounds);
    pass->SetAlphaCorrection(setup.Corrected);
    pass->SetPrecision(setup.Precision);
    return pass;
  }

  /// The reference's compositor for that pass and scene.
  Compositor GetCompositor(const AnalyticScene& scene) const
  {
    const auto& [technique, setup] = GetParam();
    std::vector<double> range;
    if (setup.Bounds == vtkAbsorbancePass::Props)
    {
      for (const Layer& layer : scene.Translucent)
      {
        for (const Rectangle& rectangle : layer)
        {
          range.push_back(rectangle.Depth);
        }
      }
      std::sort(range.begin(), range.end());
    }
    const bool half = setup.Precision == vtkAbsorbancePass::Half;
    return [visibilities = half ? technique.Rounded : technique.Exact, range, corrected = setup.Corrected](
             const std::vector<Reference::Fragment>& fragments)
    { return Reference::CompositeAbsorbance(fragments, visibilities, range, corrected); };
  }

  Picture DrawTwice(const AnalyticScene& scene) const
  {
    View view(scene, std::get<1>(GetParam()).Samples);
    const auto pass = this->NewPass();
    view.SetPass(pass);
    view.Render();
    EXPECT_GT(pass->GetStatistics()->GetShaderBuilds(), 0);
    const Picture drawn = view.Render();
    EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0) << "in the second frame";
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    return drawn;
  }
};

// What is behind shows through: blending in bytes rounds colour, transmittance and product.
constexpr double Bound = 2;
// Besides, how blending rounds half floats is up to the driver: up to 1e-2 of a visibility.
constexpr double BoundOfHalves = Bound + 0.01 * 255;
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbancePass, IsAsComputed)
{
  for (const AnalyticScene& scene :
    { RandomLayers(200, 160, 11, 3, 0.2, 0.8).Shrunk(5), RandomLayers(100, 80, 12, 30, 0.02, 0.8).Shrunk(5),
      RandomLayers(80, 60, 13, 70, 0.02, 0.3).Shrunk(5), RandomMosaic(100, 80, 14, 20, 0.02, 0.6).Shrunk(5) })
  {
    const PictureDifference difference = Compare(this->DrawTwice(scene), scene.Compute(this->GetCompositor(scene)));
    EXPECT_LE(difference.Largest, std::get<1>(GetParam()).Precision == vtkAbsorbancePass::Half ? BoundOfHalves : Bound)
      << scene.Translucent.size() << " layers: " << difference;
  }
}

//------------------------------------------------------------------------------
// Black in front of white: only the total transmittance is seen.
TEST_P(TestAbsorbancePass, LetsThroughExactlyWhatIsLetThrough)
{
  AnalyticScene scene = RandomLayers(200, 160, 15, 25, 0.02, 0.4).Shrunk(5);
  scene.Background = { { 1, 1, 1 } };
  scene.Opaque.clear();
  for (Layer& layer : scene.Translucent)
  {
    layer[0].Rgb = { { 0, 0, 0 } };
  }
  const PictureDifference difference = Compare(this->DrawTwice(scene), scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, 1) << difference;
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbancePass, OnlyFragmentIsExact)
{
  AnalyticScene scene = RandomMosaic(200, 160, 16, 1, 0.02, 1).Shrunk(5);
  scene.Background = { { 0.2, 0.4, 0.6 } };
  const PictureDifference difference = Compare(this->DrawTwice(scene), scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, 1.5) << difference;
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbancePass, OpaqueFragmentHidesWhatIsBehind)
{
  AnalyticScene scene;
  scene.Background = { { 1, 1, 1 } };
  scene.Translucent = { { { 0, 0, 400, 300, 0.75, { { 1, 1, 1 } }, 0.5 } },
    { { 50, 50, 350, 250, 0.25, { { 0.2, 0.4, 0 } }, 1 } } };
  const PictureDifference difference = Compare(this->DrawTwice(scene), scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, 1) << difference;
}

//------------------------------------------------------------------------------
TEST_P(TestAbsorbancePass, OrderOfDrawingChangesNothing)
{
  const AnalyticScene scene = RandomLayers(100, 80, 17, 40, 0.02, 0.5).Shrunk(5);
  const PictureDifference difference = Compare(this->DrawTwice(scene), this->DrawTwice(scene.Reversed()));
  EXPECT_LE(difference.Largest, 1) << difference;
}

INSTANTIATE_TEST_SUITE_P(Matrix, TestAbsorbancePass,
  testing::Combine(testing::Values(Fourier(1), Fourier(4), Fourier(15), Slices(5), Slices(32), Wavelet(3), Wavelet(5),
                     Moments(0), Moments(1), Moments(2), Moments(4)),
    testing::ValuesIn(Setups())),
  [](const auto& info) { return std::get<0>(info.param).Name + std::get<1>(info.param).GetName(); });

// Sums in words, of those that are never negative; of one channel they are floats.
INSTANTIATE_TEST_SUITE_P(Words, TestAbsorbancePass,
  testing::Combine(testing::Values(Slices(5), Slices(32), Wavelet(1), Wavelet(3), Wavelet(5)),
    testing::Values(
      Setup{ vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Fragments, true, 0, vtkAbsorbancePass::SharedExponent },
      Setup{ vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Props, false, 0, vtkAbsorbancePass::SharedExponent },
      Setup{ vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Fragments, true, 4, vtkAbsorbancePass::SharedExponent })),
  [](const auto& info) { return std::get<0>(info.param).Name + std::get<1>(info.param).GetName(); });

//------------------------------------------------------------------------------
using TestAbsorbancePassOf = RenderTest;

namespace
{
/// The first pixel of what is drawn to a framebuffer of floats.
std::array<float, 4> DrawInFloats(const AnalyticScene& scene, vtkRenderPass* pass)
{
  View view(scene);
  view.SetTranslucentPass(pass);
  vtkNew<vtkFramebufferPass> floats;
  floats->SetColorFormat(vtkTextureObject::Float32);
  floats->SetDelegatePass(view.Renderer->GetPass());
  view.Renderer->SetPass(floats);
  view.Window->Render();
  std::array<float, 4> pixel{};
  const auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(floats->GetColorTexture()->Download());
  unsigned int size[] = { 1, 1 };
  vtkIdType increments[] = { 0, 0 };
  EXPECT_TRUE(buffer->Download2D(VTK_FLOAT, pixel.data(), size, static_cast<int>(pixel.size()), increments));
  return pixel;
}
}

TEST_F(TestAbsorbancePassOf, EitherMemoryDrawsTheSame)
{
  AnalyticScene scene = RandomLayers(200, 150, 18, 40, 0.02, 0.8);
  for (const Technique& technique : { Fourier(4), Slices(16), Wavelet(3), Moments(1) })
  {
    for (int samples : { 0, 4 })
    {
      View view(scene, samples);
      AddBall(view.Renderer, false, 60, 70, 0.3);
      AddBall(view.Renderer, false, 130, 80, -0.2);
      const auto pass = technique.New();
      view.SetPass(pass);
      const Picture lists = view.Render();
      pass->SetMemory(vtkAbsorbancePass::Fixed);
      const PictureDifference difference = Compare(lists, view.Render());
      EXPECT_LE(difference.Largest, samples > 1 ? 4 : 2)
        << technique.Name << ", " << samples << " samples: " << difference;
      EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 3);
      pass->SetBounds(vtkAbsorbancePass::Props);
      view.Render();
      EXPECT_EQ(pass->GetStatistics()->GetGeometryPasses(), 2);
    }
  }
}

//------------------------------------------------------------------------------
// Fragment by fragment, to what floats tell: each shines in one channel of one picture, drawn in floats.
class TestVisibilities : public RenderTest
{
protected:
  static constexpr int Channels = 3;
  static constexpr int Count = 3 * Channels;

  /// Opacities are half floats, too.
  TestVisibilities()
  {
    constexpr double Opacities[] = { 0.25, 0.375, 0.125, 0.5, 0.0625, 0.625, 0.25, 0.1875, 0.5 };
    this->Scene.Width = this->Scene.Height = 8;
    for (int i = 0; i < Count; ++i)
    {
      const int place = 5 * i % Count; // in any order
      this->Depths.push_back(static_cast<double>(place * place) / ((Count - 1) * (Count - 1)));
      this->Alphas.push_back(Opacities[i]);
      this->Scene.Translucent.push_back(
        { { 0, 0, this->Scene.Width, this->Scene.Height, 0.25 + this->Depths.back() / 2, {}, Opacities[i] } });
    }
  }

  /// Of fragment i in channel i % 3.
  std::vector<double> Measure(
    const std::function<vtkSmartPointer<vtkAbsorbancePass>()>& create, int memory, int precision) const
  {
    std::vector<double> visibilities;
    for (int first = 0; first < Count; first += Channels)
    {
      AnalyticScene shining = this->Scene;
      for (int channel = 0; channel < Channels; ++channel)
      {
        shining.Translucent[first + channel][0].Rgb[channel] = 1;
      }
      const auto pass = create();
      pass->SetMemory(memory);
      pass->SetPrecision(precision);
      pass->AlphaCorrectionOff();
      const std::array<float, 4> drawn = DrawInFloats(shining, pass);
      EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
      for (int channel = 0; channel < Channels; ++channel)
      {
        visibilities.push_back(drawn[channel] / this->Alphas[first + channel]);
      }
    }
    return visibilities;
  }

  AnalyticScene Scene;
  std::vector<double> Depths;
  std::vector<double> Alphas;
};

TEST_F(TestVisibilities, AreThoseOfTheText)
{
  for (const Technique& technique : { Fourier(4), Slices(16), Wavelet(1), Wavelet(2), Wavelet(3), Wavelet(4),
         Wavelet(5), Moments(0), Moments(1), Moments(2), Moments(3), Moments(4), Moments(5) })
  {
    for (const auto& [memory, precision] : { std::pair(vtkAbsorbancePass::Variable, vtkAbsorbancePass::Single),
           std::pair(vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Single),
           std::pair(vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Half) })
    {
      const bool half = precision == vtkAbsorbancePass::Half;
      const std::vector<double> expected = (half ? technique.Rounded : technique.Exact)(this->Depths, this->Alphas);
      const std::vector<double> measured = this->Measure(technique.New, memory, precision);
      for (int i = 0; i < Count; ++i)
      {
        EXPECT_NEAR(measured[i], expected[i], half ? 1e-2 : 1e-3)
          << technique.Name << ", memory " << memory << ", precision " << precision << ", fragment " << i;
      }
    }
  }
}

//------------------------------------------------------------------------------
// Channels that hide differently share the exponents of their sums.
TEST_F(TestVisibilities, InWordsAreThoseOfTheText)
{
  for (int i = 0; i < Count; ++i)
  {
    this->Scene.Translucent[i][0].Transmission = { { 0.25 * (i % 3), 0.125 * (i % 5), 0.5 * (i % 2) } };
  }
  for (const auto& [technique, name, terms] :
    { std::tuple(Slices(16), "Slices", 16), std::tuple(Wavelet(1), "Wavelet", 1), std::tuple(Wavelet(2), "Wavelet", 2),
      std::tuple(Wavelet(3), "Wavelet", 3), std::tuple(Wavelet(4), "Wavelet", 4),
      std::tuple(Wavelet(5), "Wavelet", 5) })
  {
    const AbsorbanceVariant text = FindVariant(name, terms, false, true);
    const std::vector<double> measured =
      this->Measure(technique.New, vtkAbsorbancePass::Fixed, vtkAbsorbancePass::SharedExponent);
    for (int i = 0; i < Count; ++i)
    {
      std::vector<Absorber> absorbers;
      for (int j = 0; j < Count; ++j)
      {
        const Reference::Color& transmission = this->Scene.Translucent[j][0].Transmission;
        const auto opacity = [&](int channel)
        { return static_cast<float>(this->Alphas[j] * (1 - transmission[channel % Channels])); };
        absorbers.push_back({ static_cast<float>(this->Depths[j]), opacity(i), { opacity(i + 1), opacity(i + 2) } });
      }
      EXPECT_NEAR(measured[i], text(absorbers)[i], 1e-2) << technique.Name << ", fragment " << i;
    }
  }
}

//------------------------------------------------------------------------------
// Longer than what registers take, and not taken for lists that have to be sorted: theory is told from the exact
// picture.
TEST_F(TestAbsorbancePassOf, LongListsAreWhole)
{
  AnalyticScene scene = RandomLayers(16, 12, 19, 1500, 0.001, 0.02);
  for (Layer& layer : scene.Translucent)
  {
    layer[0].Rgb = { { layer[0].Depth, 1 - layer[0].Depth, 0 } }; // what is seen of which depth shows in the mean
  }
  const Compositor composite = [](const std::vector<Reference::Fragment>& fragments)
  { return Reference::CompositeAbsorbance(fragments, Fourier(1).Exact, {}, true); };
  vtkNew<vtkFourierOpacityPass> pass;
  pass->SetCoefficients(1);
  const PictureDifference difference = Compare(Draw(scene, pass), scene.RoundedToHalf().Compute(composite));
  EXPECT_LE(difference.Largest, 2) << difference;
  EXPECT_GT(pass->GetStatistics()->GetDeepestPixel(), 500);
  EXPECT_GT(Compare(scene.Compute(composite), scene.Compute(Reference::CompositeExact)).Largest, 5);
}

//------------------------------------------------------------------------------
// Depths are linear in a perspective, too: both rectangles fill the view, at the ends of the range of the props as of
// the fragments.
TEST_F(TestAbsorbancePassOf, PropsBoundsHoldInPerspective)
{
  for (int memory : { vtkAbsorbancePass::Fixed, vtkAbsorbancePass::Variable })
  {
    View view(60, 60);
    for (double z : { 0.0, -3.0, -10.0 })
    {
      vtkNew<vtkPlaneSource> plane;
      plane->SetOrigin(-50, -50, z);
      plane->SetPoint1(50, -50, z);
      plane->SetPoint2(-50, 50, z);
      plane->Update();
      view.Renderer->AddActor(NewUnlitActor(plane->GetOutput(), { { 1 + z / 10, 0.5, -z / 10 } }, 0.6));
    }
    vtkNew<vtkCamera> camera;
    camera->SetPosition(0, 0, 1);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(0.1, 100);
    view.Renderer->SetActiveCamera(camera);
    vtkNew<vtkFourierOpacityPass> pass;
    pass->SetMemory(memory);
    view.SetPass(pass);
    const Picture ofFragments = view.Render();
    pass->SetBounds(vtkAbsorbancePass::Props);
    EXPECT_LE(Compare(view.Render(), ofFragments).Largest, 1);

    const std::vector<Reference::Fragment> fragments = { { 0, { { 1, 0.5, 0 } }, 0.6 },
      { 0.3, { { 0.7, 0.5, 0.3 } }, 0.6 }, { 1, { { 0, 0.5, 1 } }, 0.6 } };
    const Reference::Pixel expected = Reference::CompositeAbsorbance(fragments, Fourier(4).Exact, {}, true);
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(ofFragments.At(30, 30, channel), 255 * expected.Rgb[channel], 1) << channel;
    }
  }
}

//------------------------------------------------------------------------------
// A prop that does not count, nor one that is out of sight, must not widen the range; one behind the camera must not
// turn it round.
TEST_F(TestAbsorbancePassOf, HiddenPropsDoNotWidenTheRange)
{
  const AnalyticScene scene = RandomLayers(100, 80, 20, 10, 0.2, 0.6);
  View view(scene);
  vtkNew<vtkFourierOpacityPass> pass;
  pass->SetBounds(vtkAbsorbancePass::Props);
  view.SetPass(pass);
  const Picture before = view.Render();
  vtkNew<vtkPlaneSource> plane;
  plane->SetCenter(0, 0, -0.99);
  plane->Update();
  const auto hidden = NewUnlitActor(plane->GetOutput(), { { 1, 1, 1 } }, 0.5);
  hidden->VisibilityOff();
  view.Renderer->AddActor(hidden);
  EXPECT_EQ(Compare(view.Render(), before).Largest, 0);
}

//------------------------------------------------------------------------------
TEST_F(TestAbsorbancePassOf, VariableReleasesWhatFixedHolds)
{
  View view(RandomLayers(200, 150, 21, 10, 0.1, 0.5));
  vtkNew<vtkFourierOpacityPass> pass;
  view.SetPass(pass);
  view.Render();
  const vtkTypeInt64 lists = pass->GetStatistics()->GetBytes();
  pass->SetMemory(vtkAbsorbancePass::Fixed);
  view.Render();
  const vtkTypeInt64 bytesOfPixel = 8 + 4 * 9 + 16 + 4;
  EXPECT_GE(pass->GetStatistics()->GetBytes(), bytesOfPixel * 200 * 150);
  EXPECT_LE(pass->GetStatistics()->GetBytes(), bytesOfPixel * 200 * 150 + 10000);
  pass->SetMemory(vtkAbsorbancePass::Variable);
  view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetBytes(), lists);
}

//------------------------------------------------------------------------------
TEST_F(TestAbsorbancePassOf, EachPrecisionReleasesWhatAnotherHolds)
{
  const AnalyticScene scene = RandomLayers(200, 150, 1, 5, 0.1, 0.6);
  View view(scene);
  const auto pass = NewTechnique("wavelet", { { "memory", "fixed" } });
  view.SetPass(pass);
  const auto bytes = [&](const char* precision)
  {
    EXPECT_TRUE(pass->SetOption("precision", precision));
    view.Render();
    return pass->GetStatistics()->GetBytes();
  };
  const vtkTypeInt64 single = bytes("single");
  const vtkTypeInt64 half = bytes("half");
  const vtkTypeInt64 words = bytes("shared-exponent");
  EXPECT_LT(half, single);
  EXPECT_EQ(bytes("half"), half);
  EXPECT_EQ(bytes("shared-exponent"), words);
  EXPECT_EQ(bytes("single"), single);
}

//------------------------------------------------------------------------------
TEST_F(TestAbsorbancePassOf, BadValuesAreErrorsAndChangeNothing)
{
  vtkNew<vtkFourierOpacityPass> fourier;
  vtkNew<vtkOpacityShadowMapPass> map;
  vtkNew<vtkWaveletTransparencyPass> wavelet;
  vtkNew<vtkMomentTransparencyPass> moment;
  const auto getMTimes = [&]
  { return fourier->GetMTime() + map->GetMTime() + wavelet->GetMTime() + moment->GetMTime(); };
  const vtkMTimeType before = getMTimes();
  const std::pair<std::function<void()>, std::string> bad[] = {
    { [&] { fourier->SetCoefficients(0); }, "Coefficients is 0, expected 1 to 15" },
    { [&] { fourier->SetCoefficients(16); }, "Coefficients is 16, expected 1 to 15" },
    { [&] { map->SetSlices(0); }, "Slices is 0, expected 1 to 32" },
    { [&] { map->SetSlices(33); }, "Slices is 33, expected 1 to 32" },
    { [&] { map->SetMemory(2); }, "Memory is 2, expected variable (0) or fixed (1)" },
    { [&] { fourier->SetBounds(-1); }, "Bounds is -1, expected fragments (0) or props (1)" },
    { [&] { fourier->SetPrecision(2); }, "Precision is 2, expected single (0) or half (1)" },
    { [&] { wavelet->SetPrecision(3); }, "Precision is 3, expected single (0), half (1) or shared-exponent (2)" },
    { [&] { fourier->SetDepthWarp(2); }, "DepthWarp is 2, expected linear (0) or logarithmic (1)" },
    { [&] { wavelet->SetRank(0); }, "Rank is 0, expected 1 to 5" },
    { [&] { wavelet->SetRank(6); }, "Rank is 6, expected 1 to 5" },
    { [&] { moment->SetMoments(6); }, "Moments is 6, expected power-4 (0), power-6 (1), power-8 (2), " },
    { [&] { moment->SetOverestimation(1.01); }, "Overestimation is 1.01, expected 0 to 1" },
    { [&] { moment->SetOverestimation(std::nan("")); }, "Overestimation is nan, expected 0 to 1" },
    { [&] { fourier->SetOption("alpha_correction", "maybe"); }, "alpha_correction is 'maybe', expected off or on" },
    { [&] { map->SetOption("slices", "3.5"); }, "slices is '3.5', expected an integer in 1..32" },
  };
  for (const auto& [set, expected] : bad)
  {
    set();
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u) << expected;
    EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
  }
  EXPECT_EQ(getMTimes(), before);
}

//------------------------------------------------------------------------------
TEST_F(TestAbsorbancePassOf, OptionsStartWithTheirDefaultsAndTakeTheirEnds)
{
  for (const Technique& technique :
    { Technique{ "", [] { return vtkSmartPointer<vtkFourierOpacityPass>::New(); }, {}, {} },
      Technique{ "", [] { return vtkSmartPointer<vtkOpacityShadowMapPass>::New(); }, {}, {} },
      Technique{ "", [] { return vtkSmartPointer<vtkWaveletTransparencyPass>::New(); }, {}, {} },
      Technique{ "", [] { return vtkSmartPointer<vtkMomentTransparencyPass>::New(); }, {}, {} } })
  {
    const auto pass = technique.New();
    for (const vtkTranslucencyOption& option : pass->GetOptions())
    {
      EXPECT_EQ(option.Get(), option.Default) << option.Name;
      if (std::isfinite(option.Maximum))
      {
        option.Set(option.Maximum);
        EXPECT_EQ(option.Get(), option.Maximum) << option.Name;
      }
      option.Set(option.Minimum);
      EXPECT_EQ(option.Get(), option.Minimum) << option.Name;
    }
  }
}
