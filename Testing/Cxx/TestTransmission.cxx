// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Transmission colours: surfaces that let through a part of each of red, green and blue, against pictures computed
// channel by channel.
#include "AbsorbanceShader.h"
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkFragmentStorage.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkLODProp3D.h>
#include <vtkMapper.h>
#include <vtkMomentTransparencyPass.h>
#include <vtkPlaneSource.h>
#include <vtkPointGaussianMapper.h>
#include <vtkProperty.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyStatistics.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

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
  double Bound = 2; // of 255: the framebuffer rounds, and fragments are rounded
};

void PrintTo(const Technique& value, std::ostream* os)
{
  *os << value.Name;
}

// Merging rounds the last layer to half floats each time.
Technique Layers(const std::string& name, int layers, Tail tail)
{
  return { name + std::to_string(layers), name, { { "layers", std::to_string(layers) } },
    [=](const std::vector<Fragment>& fragments) { return Reference::CompositeLayers(fragments, layers, tail); },
    tail == Tail::Merge ? 3.0 : 2.0 };
}

// Sums of absorbance, with a pixel's own bounds. No channel gets more light than all fragments give together.
Technique Absorbance(const std::string& technique, const std::string& option, const std::string& terms, bool corrected,
  const Reference::Visibilities& visibilities)
{
  const auto compute = [=](const std::vector<Reference::Fragment>& fragments)
  {
    Reference::Pixel pixel = Reference::CompositeAbsorbance(fragments, visibilities, {}, corrected);
    for (std::size_t c = 0; c < 3; ++c)
    {
      double light = 0;
      for (const Reference::Fragment& fragment : fragments)
      {
        light += fragment.Alpha * fragment.Rgb[c];
      }
      pixel.Rgb[c] = std::min(pixel.Rgb[c], light);
    }
    return pixel;
  };
  std::string name = technique + terms + (corrected ? "" : "Uncorrected");
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return { name, technique, { { option, terms }, { "alpha_correction", corrected ? "on" : "off" } }, compute };
}

Technique Absorbance(const std::string& technique, const std::string& option, int terms, bool corrected,
  const std::function<double(int, double, double)>& share)
{
  const auto shareOf = [=](double at, double before) { return share(terms, at, before); };
  return Absorbance(technique, option, std::to_string(terms), corrected, Reference::VisibilitiesOf(shareOf));
}

// The same in fixed memory, of words with 9 bits for each channel's sum. What the rounding of each fragment loses in
// these scenes of up to 400 layers is part of it; TestAbsorbancePass compares with the rounded sums.
Technique InWords(Technique technique)
{
  technique.Name += "Words";
  technique.Options.insert(technique.Options.end(), { { "memory", "fixed" }, { "precision", "shared-exponent" } });
  technique.Bound += 10;
  return technique;
}

// Those that keep three channels, each of which is what the technique's theory says for it alone.
std::vector<Technique> Colored()
{
  return { { "Exact", "exact", {}, Reference::CompositeExact },
    { "ExactIterative", "exact", { { "resolve", "iterative" } }, Reference::CompositeExact },
    // Opacities in bytes are off by half of 1/255 each: too much for many faint ones.
    { "ExactBytes", "exact", { { "color_format", "rgba8" } }, Reference::CompositeExact, 6 },
    { "PeelBuckets", "peel", { { "method", "bucket-sort" } }, Reference::CompositeExact },
    { "PeelBuckets8", "peel", { { "method", "bucket-sort" }, { "layers", "8" } },
      [](const std::vector<Fragment>& fragments) { return Reference::CompositeLayers(fragments, 8, Tail::Average); } },
    Layers("mlab", 1, Tail::Merge), Layers("mlab", 4, Tail::Merge), Layers("mlab", 32, Tail::Merge),
    Layers("kbuffer", 1, Tail::Drop), Layers("kbuffer", 8, Tail::Drop), Layers("hybrid", 1, Tail::Average),
    Layers("hybrid", 8, Tail::Average),
    { "Kbuffer8Bytes", "kbuffer", { { "layers", "8" }, { "color_format", "rgba8" } },
      [](const std::vector<Fragment>& fragments) { return Reference::CompositeLayers(fragments, 8, Tail::Drop); }, 3 },
    { "WeightedSum", "weighted", { { "method", "sum" } }, Reference::CompositeWeightedSum },
    { "WeightedAverage", "weighted", { { "method", "average" } }, Reference::CompositeWeightedAverage },
    { "WeightedBlended", "weighted", { { "method", "blended" }, { "weight_function", "equation10" } },
      [](const std::vector<Fragment>& fragments)
      {
        return Reference::CompositeWeightedBlended(
          fragments, [](double depth) { return std::max(1e-2, 3e3 * std::pow(1 - depth, 3)); });
      } },
    Absorbance("fourier", "coefficients", 1, true, Reference::FourierShare),
    Absorbance("fourier", "coefficients", 4, false, Reference::FourierShare),
    Absorbance("fourier", "coefficients", 15, true, Reference::FourierShare),
    Absorbance("shadowmap", "slices", 5, true, Reference::SliceShare),
    Absorbance("shadowmap", "slices", 16, false, Reference::SliceShare),
    Absorbance("shadowmap", "slices", 32, true, Reference::SliceShare),
    Absorbance("wavelet", "rank", 1, true, Reference::WaveletShare),
    Absorbance("wavelet", "rank", 3, false, Reference::WaveletShare),
    Absorbance("wavelet", "rank", 5, true, Reference::WaveletShare),
    InWords(Absorbance("wavelet", "rank", 1, true, Reference::WaveletShare)),
    InWords(Absorbance("wavelet", "rank", 3, false, Reference::WaveletShare)),
    InWords(Absorbance("wavelet", "rank", 5, true, Reference::WaveletShare)),
    InWords(Absorbance("shadowmap", "slices", 16, true, Reference::SliceShare)),
    Absorbance("moment", "moments", "power-6", true, TextOf("Moment", vtkMomentTransparencyPass::Power6, false)),
    Absorbance("moment", "moments", "trigonometric-3", false,
      TextOf("Moment", vtkMomentTransparencyPass::Trigonometric3, false)) };
}

// Of those, these.
std::vector<Technique> ColoredOf(const std::set<std::string>& techniques)
{
  std::vector<Technique> chosen = Colored();
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                 [&](const Technique& one) { return techniques.count(one.Technique) == 0; }),
    chosen.end());
  return chosen;
}

struct Scene
{
  std::string Name;
  AnalyticScene Made;
};

// Deep enough for each way in which lists are resolved.
std::vector<Scene> Scenes()
{
  return { { "Layers3", RandomLayers(100, 80, 1, 3, 0.2, 0.8).Shrunk(5).Transmitting(11) },
    { "Layers30", RandomLayers(100, 80, 2, 30, 0.02, 0.8).Shrunk(5).Transmitting(12) },
    { "Layers120", RandomLayers(60, 40, 3, 120, 0.02, 0.3).Shrunk(5).Transmitting(13) },
    { "Layers400", RandomLayers(40, 40, 4, 400, 0.02, 0.1).Shrunk(5).Transmitting(14) },
    { "Mosaic64", RandomMosaic(100, 80, 6, 64, 0.02, 0.3).Shrunk(5).Transmitting(15) } };
}

struct ColoredNode
{
  double Depth;
  Reference::Color Transmittance; // behind it
};

// Eq. 5 for each channel, and Eq. 7 with the mean of the three steps; the step that goes moves to the nearer node
// (Figure 4). Corrected: widths count as wider by 1/256 of the distance from the first node to the last.
void Insert(std::vector<ColoredNode>& nodes, const Rectangle& rectangle, std::size_t most, bool corrected)
{
  const auto place =
    std::find_if(nodes.begin(), nodes.end(), [&](const ColoredNode& node) { return node.Depth > rectangle.Depth; });
  const Reference::Color before =
    place == nodes.begin() ? Reference::Color{ { 1, 1, 1 } } : std::prev(place)->Transmittance;
  const auto inserted = nodes.insert(place, { rectangle.Depth, before });
  for (auto node = inserted; node != nodes.end(); ++node)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      node->Transmittance[c] *= 1 - rectangle.Alpha * (1 - rectangle.Transmission[c]);
    }
  }
  if (nodes.size() <= most)
  {
    return;
  }
  const double wider = corrected ? (nodes.back().Depth - nodes.front().Depth) / 256 : 0;
  const auto loss = [&nodes, wider](std::size_t k)
  {
    double step = 0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      step += (nodes[k - 1].Transmittance[c] - nodes[k].Transmittance[c]) / 3;
    }
    return step * (nodes[k].Depth - nodes[k - 1].Depth + wider);
  };
  std::size_t least = 1;
  for (std::size_t k = 2; k < nodes.size(); ++k)
  {
    least = loss(k) < loss(least) ? k : least;
  }
  nodes[least - 1].Transmittance = nodes[least].Transmittance;
  nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(least));
}

// Adaptive transparency with so many nodes of three transmittances. Kept fragments are inserted from the last drawn on.
// Corrected: where there are more fragments than nodes, those without nodes weigh by means, and each channel is scaled
// so that the weights add up to what it hides, up to the light of all fragments.
AnalyticScene::Painter ColoredAdaptive(std::size_t nodeCount, bool lastFirst, bool corrected)
{
  return [=](std::vector<Rectangle> covering, const Reference::Color& opaque)
  {
    if (lastFirst)
    {
      std::reverse(covering.begin(), covering.end());
    }
    std::vector<ColoredNode> nodes;
    for (const Rectangle& rectangle : covering)
    {
      Insert(nodes, rectangle, nodeCount, corrected);
    }
    const bool correct = corrected && covering.size() > nodeCount;
    Reference::Color color = opaque;
    for (std::size_t c = 0; c < 3; ++c)
    {
      double light = 0;
      double all = 0;
      double weights = 0;
      double transmittance = 1;
      for (const Rectangle& rectangle : covering)
      {
        const double opacity = rectangle.Alpha * (1 - rectangle.Transmission[c]);
        const auto behind = std::find_if(
          nodes.begin(), nodes.end(), [&](const ColoredNode& node) { return node.Depth >= rectangle.Depth; });
        const auto after = [&](std::ptrdiff_t count)
        { return count == 0 ? 1 : nodes[static_cast<std::size_t>(count) - 1].Transmittance[c]; };
        const std::ptrdiff_t inFront = behind - nodes.begin();
        const bool hasNode = behind != nodes.end() && behind->Depth == rectangle.Depth;
        const double visibility =
          !correct || hasNode ? after(inFront) : Reference::MeanOf(after(inFront - 1), after(inFront), opacity);
        light += visibility * rectangle.Alpha * rectangle.Rgb[c];
        all += rectangle.Alpha * rectangle.Rgb[c];
        weights += visibility * opacity;
        transmittance *= 1 - opacity;
      }
      if (correct)
      {
        light = std::min(light * (1 - transmittance) / weights, all);
      }
      color[c] = transmittance * opaque[c] + std::min(light, 1.0);
    }
    return color;
  };
}

// Surfaces that hide nothing, or next to nothing, of some or all channels add their light all the same.
void ExpectLight(const Technique& technique)
{
  AnalyticScene scene;
  scene.Width = 40;
  scene.Height = 30;
  scene.Background = { { 102 / 255.0, 51 / 255.0, 153 / 255.0 } };
  const Reference::Color light{ { 0.2, 0.1, 0 } };
  const Reference::Color white{ { 1, 1, 1 } };
  const Reference::Color nearlyWhite{ { 1, 1 - 1e-6, 1 - 1e-7 } };
  scene.Translucent = { { { 0, 0, 10, 30, 0.25, light, 0.5, white } },          // alone
    { { 20, 0, 30, 30, 0.25, { { 0.4, 0.4, 0.4 } }, 0.5, { { 1, 0, 0.5 } } } }, // hides none of the red
    { { 30, 0, 40, 30, 0.25, light, 0.25, nearlyWhite } } };
  const bool keepsAll = technique.Name != "kbuffer1"; // but the nearest
  if (keepsAll)
  {
    for (double depth : { 0.75, 0.25, 0.5 })
    {
      scene.Translucent.push_back({ { 10, 0, 20, 30, depth, light, depth, white } });
    }
  }
  for (int samples : { 0, 4 })
  {
    View view(scene, samples);
    view.SetPass(NewTechnique(technique.Technique, technique.Options));
    const Picture drawn = view.Render();
    const auto expect = [&](int x, const Reference::Color& expected)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(drawn.Rgb[3 * x + c], expected[c], technique.Bound)
          << "at " << x << ", channel " << c << ", " << samples << " samples";
      }
    };
    expect(5, { { 102 + 25.5, 51 + 12.75, 153 } });
    expect(25, { { 102 + 51, 51 / 2.0 + 51, 0.75 * 153 + 51 } });
    expect(35, { { 102 + 12.75, 51 + 6.375, 153 } });
    if (keepsAll)
    {
      expect(15, { { 102 + 1.5 * 51, 51 + 1.5 * 25.5, 153 } });
    }
  }
}
}

class TestTransmission
  : public RenderTest
  , public testing::WithParamInterface<Technique>
{
};

//------------------------------------------------------------------------------
TEST_P(TestTransmission, IsAsComputedForEachChannel)
{
  for (const Scene& scene : Scenes())
  {
    SCOPED_TRACE(scene.Name);
    const Picture computed = scene.Made.Compute(GetParam().Compute);
    for (int samples : { 0, 4 })
    {
      SCOPED_TRACE(samples);
      const auto pass = NewTechnique(GetParam().Technique, GetParam().Options);
      View view(scene.Made, samples);
      view.SetPass(pass);
      const PictureDifference difference = Compare(view.Render(), computed);
      EXPECT_LE(difference.Largest, GetParam().Bound) << difference;
      EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(TestTransmission, OfWhiteAddsLight)
{
  ExpectLight(GetParam());
}

//------------------------------------------------------------------------------
TEST_P(TestTransmission, ComesAndGoes)
{
  const AnalyticScene plain = RandomLayers(100, 75, 1, 3, 0.2, 0.8);
  const AnalyticScene scene = plain.Transmitting(11);
  const auto pass = NewTechnique(GetParam().Technique, GetParam().Options);
  View view(scene);
  view.SetPass(pass);
  const Picture colored = view.Render();
  const vtkTypeInt64 bytes = pass->GetStatistics()->GetBytes();
  EXPECT_EQ(Compare(colored, view.Render()).Largest, 0);
  EXPECT_EQ(pass->GetStatistics()->GetShaderBuilds(), 0);

  vtkActorCollection* actors = view.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    vtkTranslucencyPass::SetTransmissionColor(actor, 0, 0, 0);
  }
  const Picture without = view.Render();
  EXPECT_EQ(Compare(without, Draw(plain, NewTechnique(GetParam().Technique, GetParam().Options))).Largest, 0);
  EXPECT_GT(Compare(without, colored).Largest, 20);
  EXPECT_GE(bytes, pass->GetStatistics()->GetBytes());
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, TestTransmission, testing::ValuesIn(Colored()), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
using TestTransmissionOfAdaptive = RenderTest;

TEST_F(TestTransmissionOfAdaptive, CompressesThreeTransmittancesAtOnce)
{
  constexpr double bound = 2;
  const AnalyticScene scene = RandomLayers(100, 75, 2, 40, 0.02, 0.8).Transmitting(12);
  const Picture exact = scene.Compute(Reference::CompositeExact);
  for (const char* memory : { "variable", "fixed" })
  {
    for (int nodes : { 1, 4, 8, 40 })
    {
      for (const auto& [samples, corrected] : { std::pair(0, true), std::pair(4, true), std::pair(0, false) })
      {
        if (!corrected && nodes != 4)
        {
          continue;
        }
        SCOPED_TRACE(std::string(memory) + " " + std::to_string(nodes) + " " + std::to_string(samples) +
          (corrected ? "" : " uncorrected"));
        View view(scene, samples);
        view.SetPass(NewTechnique("adaptive",
          { { "memory", memory }, { "nodes", std::to_string(nodes) },
            { "alpha_correction", corrected ? "on" : "off" } }));
        const Picture drawn = view.Render();
        if (!KeepsDrawOrder(view))
        {
          GTEST_SKIP() << "the driver inserts fragments in an order of its own";
        }
        const bool kept = memory[0] == 'v';
        const PictureDifference difference =
          Compare(drawn, scene.Compute(ColoredAdaptive(static_cast<std::size_t>(nodes), kept, corrected)));
        EXPECT_LE(difference.Largest, bound) << difference;
        EXPECT_EQ(Compare(drawn, exact).Largest <= bound, nodes == 40);
      }
    }
  }
}

//------------------------------------------------------------------------------
class TestMeanTransmission
  : public RenderTest
  , public testing::WithParamInterface<std::string>
{
};

// A technique that keeps one transmittance draws what it draws of surfaces that hide the mean of the three, and says so
// once.
TEST_P(TestMeanTransmission, OfTechniquesWithOneTransmittance)
{
  const AnalyticScene scene = RandomLayers(100, 75, 1, 3, 0.2, 0.8).Transmitting(11);
  const auto pass = NewTechnique(GetParam());
  if (pass->KeepsTransmissionColors())
  {
    EXPECT_EQ(Draw(scene, pass).Width, 100); // without a warning
    return;
  }
  View view(scene);
  view.SetPass(pass);
  const Picture drawn = view.Render();
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("takes the transmission colours of 3 props by their mean"), std::string::npos)
    << messages[0];

  AnalyticScene mean = scene.MeanTransmission();
  for (Layer& layer : mean.Translucent)
  {
    for (Rectangle& rectangle : layer)
    {
      const double hides = 1 - rectangle.Transmission[0];
      rectangle.Transmission = { { 0, 0, 0 } };
      rectangle.Alpha *= hides;
      for (double& channel : rectangle.Rgb)
      {
        channel /= hides;
      }
    }
  }
  const PictureDifference difference = Compare(drawn, Draw(mean, NewTechnique(GetParam())));
  // Its chances follow from all bits of a colour.
  EXPECT_LE(difference.Largest, GetParam() == "stochastic" ? 30 : 1) << difference;
}

INSTANTIATE_TEST_SUITE_P(Techniques, TestMeanTransmission,
  testing::ValuesIn(
    []
    {
      std::vector<std::string> names;
      for (int i = 0; i < vtkTranslucencyFactory::GetNumberOfTechniques(); ++i)
      {
        const std::string name = vtkTranslucencyFactory::GetTechniqueName(i);
        const auto pass = vtkSmartPointer<vtkRenderPass>::Take(vtkTranslucencyFactory::CreateTechnique(name));
        if (vtkTranslucencyPass::SafeDownCast(pass)) // not VTK's own
        {
          names.push_back(name);
        }
      }
      return names;
    }()),
  [](const auto& info) { return info.param; });

//------------------------------------------------------------------------------
using TestTransmissionColor = RenderTest;

// A white surface hides nothing and adds its light; a red one leaves red.
TEST_F(TestTransmissionColor, FiltersWhatLiesBehind)
{
  AnalyticScene scene;
  scene.Width = 40;
  scene.Height = 30;
  scene.Background = { { 102 / 255.0, 51 / 255.0, 153 / 255.0 } };
  scene.Translucent = { { { 0, 0, 20, 30, 0.25, { { 0.2, 0, 0 } }, 0.5, { { 1, 1, 1 } } } },
    { { 20, 0, 40, 30, 0.25, { { 0, 0, 0 } }, 1, { { 1, 0, 0.5 } } } } };
  const std::vector<double> adds{ 102 + 25.5, 51, 153 };
  const std::vector<double> filters{ 102, 0, 76.5 };
  for (const Technique& technique : Colored())
  {
    SCOPED_TRACE(technique.Name);
    const Picture drawn = Draw(scene, NewTechnique(technique.Technique, technique.Options));
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(drawn.At(10, 15, c), adds[c], 1);
      EXPECT_NEAR(drawn.At(30, 15, c), filters[c], 1);
    }
  }
}

//------------------------------------------------------------------------------
// Of many surfaces that hide nothing, more than what registers take, all light is there; half of its red lacks behind
// one that hides red.
TEST_F(TestTransmissionColor, WhiteAddsLight)
{
  AnalyticScene scene;
  scene.Width = 40;
  scene.Height = 30;
  scene.Background = { { 102 / 255.0, 51 / 255.0, 153 / 255.0 } };
  for (int i = 1; i <= 40; ++i)
  {
    scene.Translucent.push_back(
      { { 0, 0, 40, 30, 0.5 + i / 128.0, { { 0.25, 0.125, 0.25 } }, 1 / 32.0, { { 1, 1, 1 } } } });
  }
  scene.Translucent.push_back({ { 20, 0, 40, 30, 1 / 128.0, { { 0, 0, 0 } }, 0.5, { { 0, 1, 1 } } } });
  const std::vector<double> light{ 40 * 0.25 / 32 * 255, 40 * 0.125 / 32 * 255, 40 * 0.25 / 32 * 255 };
  for (const Technique& technique : ColoredOf({ "exact", "fourier", "shadowmap" }))
  {
    SCOPED_TRACE(technique.Name);
    const Picture drawn = Draw(scene, NewTechnique(technique.Technique, technique.Options));
    for (int c = 0; c < 3; ++c)
    {
      const double whole = light[c] + 255 * scene.Background[c];
      EXPECT_NEAR(drawn.At(10, 15, c), whole, 1.5) << c;
      if (c > 0 || technique.Technique != "fourier") // whose series rise slowly
      {
        EXPECT_NEAR(drawn.At(30, 15, c), c == 0 ? whole / 2 : whole, 1.5) << c;
      }
    }
  }
}

//------------------------------------------------------------------------------
// Two black surfaces, so close that they seem to hide each other, do not make the light before them brighter than it
// is.
TEST_F(TestTransmissionColor, WhiteDoesNotDazzle)
{
  const auto whole = [](double depth, double color, double alpha, double transmission)
  {
    return Layer{ { 0, 0, 40, 30, depth, { { color, color, color } }, alpha,
      { { transmission, transmission, transmission } } } };
  };
  AnalyticScene scene;
  scene.Width = 40;
  scene.Height = 30;
  scene.Translucent = { whole(0.125, 0.25, 0.5, 1), whole(0.25, 0, 1 / 64.0, 0), whole(0.5, 0, 0.99, 0),
    whole(0.5 + 1 / 4096.0, 0, 0.99, 0), whole(0.875, 0, 1 / 64.0, 0) };
  for (const Technique& technique : ColoredOf({ "exact", "fourier", "shadowmap" }))
  {
    SCOPED_TRACE(technique.Name);
    EXPECT_LE(Draw(scene, NewTechnique(technique.Technique, technique.Options)).At(20, 15, 0), 255 * 0.125 + 1);
  }
}

//------------------------------------------------------------------------------
// Targets of a fixed size have room for one transmittance.
TEST_F(TestTransmissionColor, OfSumsInFixedMemoryIsTakenByItsMean)
{
  const AnalyticScene scene = RandomLayers(100, 75, 2, 30, 0.02, 0.8).Transmitting(12);
  for (const std::string technique : { "fourier", "shadowmap" })
  {
    const Picture drawn = Draw(scene, NewTechnique(technique, { { "memory", "fixed" } }));
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("by their mean"), std::string::npos) << messages[0];
    const PictureDifference difference = Compare(drawn, Draw(scene.MeanTransmission(), NewTechnique(technique)));
    EXPECT_LE(difference.Largest, 2) << difference;
  }
}

//------------------------------------------------------------------------------
// Over rounds to the window's bytes at each layer, and ends at 1 there: no layer adds more light than it hides.
TEST_F(TestTransmissionColor, OfSortedObjectsIsExact)
{
  AnalyticScene scene = RandomLayers(100, 75, 201, 15, 0.2, 0.8).Transmitting(16);
  for (Layer& layer : scene.Translucent)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      layer[0].Rgb[c] *= 1 - layer[0].Transmission[c];
    }
  }
  const Picture computed = scene.Compute(Reference::CompositeExact);
  for (const auto& [which, bound] : { std::pair("over", 6.0), { "under", 1.5 } })
  {
    ExpectLight({ which, "sorted", { { "operator", which } }, {}, 2 });
    for (int samples : { 0, 4 })
    {
      SCOPED_TRACE(which + std::to_string(samples));
      const auto pass = NewTechnique("sorted", { { "operator", which } });
      View view(scene, samples);
      view.SetPass(pass);
      const PictureDifference difference = Compare(view.Render(), computed);
      EXPECT_LE(difference.Largest, bound) << difference;
      EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(TestTransmissionColor, ChangesNothingWhereNothingHides)
{
  const AnalyticScene plain = RandomLayers(100, 75, 211, 12, 0.01, 0.1);
  const AnalyticScene scene = plain.Transmitting(11);
  for (int samples : { 0, 4 })
  {
    View with(scene, samples);
    View without(plain, samples);
    with.SetPass(NewTechnique("additive"));
    without.SetPass(NewTechnique("additive"));
    EXPECT_EQ(Compare(with.Render(), without.Render()).Largest, 0);
  }
}

//------------------------------------------------------------------------------
TEST_F(TestTransmissionColor, OutsideItsRangeIsAnError)
{
  vtkNew<vtkActor> actor;
  vtkTranslucencyPass::SetTransmissionColor(actor, 0.25, 0.5, 0.75);
  for (double bad : { -0.1, 1.5, std::numeric_limits<double>::quiet_NaN() })
  {
    vtkTranslucencyPass::SetTransmissionColor(actor, 0.5, bad, 0.5);
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("expected three numbers from 0 to 1"), std::string::npos) << messages[0];
  }
  double color[3];
  EXPECT_TRUE(vtkTranslucencyPass::GetTransmissionColor(actor, color));
  EXPECT_EQ(color[0], 0.25);
  EXPECT_EQ(color[1], 0.5);
  EXPECT_EQ(color[2], 0.75);
  EXPECT_TRUE(vtkTranslucencyPass::GetTransmissionColor(vtkNew<vtkActor>(), color));
  EXPECT_EQ(color[1], 0);
}

//------------------------------------------------------------------------------
TEST_F(TestTransmissionColor, OfAKeySetByHandIsReportedOnce)
{
  const AnalyticScene scene = RandomLayers(40, 30, 1, 3, 0.2, 0.8).Transmitting(11);
  View view(scene);
  view.SetPass(NewTechnique("exact"));
  vtkActor* last = view.Renderer->GetActors()->GetLastActor();
  last->GetPropertyKeys()->Set(
    vtkTranslucencyPass::TRANSMISSION_COLOR(), 2.0, -1.0, std::numeric_limits<double>::quiet_NaN());
  const Picture drawn = view.Render();
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("TRANSMISSION_COLOR"), std::string::npos) << messages[0];
  vtkTranslucencyPass::SetTransmissionColor(last, 1, 0, 0);
  EXPECT_EQ(Compare(drawn, view.Render()).Largest, 0);
}

//------------------------------------------------------------------------------
// Of props that draw other props it is theirs.
TEST_F(TestTransmissionColor, OfAssembliesAndLevelsOfDetail)
{
  AnalyticScene scene = RandomLayers(100, 75, 1, 1, 0.3, 0.5);
  scene.Translucent[0][0].Transmission = { { 0.9, 0.3, 0.1 } };
  const Picture expected = scene.Compute(Reference::CompositeExact);
  for (const std::string kind : { "assembly", "lod" })
  {
    SCOPED_TRACE(kind);
    View view(scene);
    view.SetPass(NewTechnique("exact"));
    const vtkSmartPointer<vtkActor> actor = view.Renderer->GetActors()->GetLastActor();
    view.Renderer->RemoveActor(actor);
    vtkTranslucencyPass::SetTransmissionColor(actor, 0, 0, 0);
    vtkSmartPointer<vtkProp> whole;
    if (kind == "assembly")
    {
      auto assembly = vtkSmartPointer<vtkAssembly>::New();
      assembly->AddPart(actor);
      whole = assembly;
    }
    else
    {
      auto levels = vtkSmartPointer<vtkLODProp3D>::New();
      levels->AddLOD(actor->GetMapper(), actor->GetProperty(), 0);
      whole = levels;
    }
    vtkTranslucencyPass::SetTransmissionColor(whole, 0.9, 0.3, 0.1);
    view.Renderer->AddViewProp(whole);
    const PictureDifference difference = Compare(view.Render(), expected);
    EXPECT_LE(difference.Largest, 2) << difference;
  }
}

//------------------------------------------------------------------------------
// Fragments that join neighbours in a multi-sampled window keep their three opacities; limits cut the picture into
// tiles.
TEST_F(TestTransmissionColor, InTilesGivesTheSamePicture)
{
  const AnalyticScene scene = RandomLayers(200, 150, 2, 30, 0.02, 0.8).Transmitting(12);
  for (int samples : { 0, 4 })
  {
    const auto pass = NewTechnique("exact");
    View view(scene, samples);
    view.SetPass(pass);
    const Picture whole = view.Render();
    EXPECT_TRUE(pass->SetOption("memory_limit", "1.5"));
    EXPECT_EQ(Compare(whole, view.Render()).Largest, 0);
    EXPECT_GT(pass->GetStatistics()->GetTiles(), 1);
  }
}

//------------------------------------------------------------------------------
// VTK adds emissive splats to the picture. Any technique draws them as what is white: it hides nothing. Without, they
// are surfaces.
TEST_F(TestTransmissionColor, OfEmissiveSplatsIsWhite)
{
  AnalyticScene scene = RandomLayers(100, 75, 3, 2, 0.3, 0.6);
  vtkNew<vtkPlaneSource> grid;
  grid->SetResolution(4, 4);
  grid->SetOrigin(10, 10, 0);
  grid->SetPoint1(90, 10, 0);
  grid->SetPoint2(10, 65, 0);
  for (const std::string& name : OwnTechniques())
  {
    for (const std::string kind : { "actor", "assembly" })
    {
      SCOPED_TRACE(name + " " + kind);
      vtkNew<vtkPointGaussianMapper> mapper;
      mapper->SetInputConnection(grid->GetOutputPort());
      mapper->SetScaleFactor(6);
      vtkNew<vtkActor> splats;
      splats->SetMapper(mapper);
      splats->GetProperty()->SetColor(0.4, 0.2, 0.1);
      splats->GetProperty()->SetOpacity(0.5);
      View view(scene);
      view.Renderer->AddActor(splats);
      vtkNew<vtkAssembly> assembly;
      vtkProp* whole = splats;
      if (kind == "assembly")
      {
        view.Renderer->RemoveActor(splats);
        assembly->AddPart(splats);
        view.Renderer->AddActor(assembly);
        whole = assembly;
      }
      view.SetPass(NewTechnique(name));
      const Picture emissive = view.Render();
      vtkTranslucencyPass::SetTransmissionColor(whole, 1, 1, 1);
      const Picture white = view.Render();
      EXPECT_EQ(Compare(emissive, white).Largest, 0) << Compare(emissive, white);
      mapper->EmissiveOff();
      EXPECT_EQ(Compare(view.Render(), white).Largest, 0);
      vtkTranslucencyPass::SetTransmissionColor(whole, 0, 0, 0);
      const Picture surfaces = view.Render();
      if (name != "additive") // which lets nothing hide
      {
        EXPECT_GT(Compare(surfaces, white).Largest, 10);
      }
      mapper->EmissiveOn();
      EXPECT_EQ(Compare(view.Render(), surfaces).Largest, 0) << "of black ones, the key says more";
      for (const std::string& message : TakeMessages())
      {
        EXPECT_NE(message.find("1 props (white for 1 with emissive splats) by their mean"), std::string::npos)
          << message;
      }
    }
  }
}
