// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Bodies that absorb by their thickness, against rays through boxes.
#include "RenderTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTranslucencyMaterial.h>
#include <vtkTranslucencyPass.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace
{
using Vector = std::array<double, 3>;

constexpr int Size = 60;
constexpr double Infinity = std::numeric_limits<double>::infinity();
const Vector Background{ { 1, 0.8, 0.6 } };

struct Box
{
  Vector Low;
  Vector High;
  Vector Color; // that is left
  double Distance;
};

// A card in a plane of one z, which covers the whole picture.
struct Card
{
  double Z;
  Vector Color;
  double Opacity;
};

Vector operator+(const Vector& a, const Vector& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

Vector operator*(double a, const Vector& b)
{
  return { { a * b[0], a * b[1], a * b[2] } };
}

vtkSmartPointer<vtkTranslucencyMaterial> NewMaterial(const Vector& color, double distance)
{
  const auto material = vtkSmartPointer<vtkTranslucencyMaterial>::New();
  material->SetAttenuationColor(color.data());
  material->SetAttenuationDistance(distance);
  return material;
}

// Its surfaces are not seen: they are black, and let everything through.
vtkSmartPointer<vtkActor> NewBody(vtkAlgorithm* source, vtkTranslucencyMaterial* material)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0, 0, 0);
  actor->ForceTranslucentOn();
  vtkTranslucencyPass::SetTransmissionColor(actor, 1, 1, 1);
  vtkTranslucencyMaterial::SetMaterial(actor, material);
  return actor;
}

vtkSmartPointer<vtkCubeSource> NewSource(const Box& box)
{
  const auto source = vtkSmartPointer<vtkCubeSource>::New();
  source->SetBounds(box.Low[0], box.High[0], box.Low[1], box.High[1], box.Low[2], box.High[2]);
  return source;
}

vtkSmartPointer<vtkActor> NewBody(const Box& box)
{
  return NewBody(NewSource(box), NewMaterial(box.Color, box.Distance));
}

vtkSmartPointer<vtkActor> NewCard(const Card& card)
{
  constexpr double far = 50;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-far, -far, card.Z);
  plane->SetPoint1(far, -far, card.Z);
  plane->SetPoint2(-far, far, card.Z);
  plane->Update();
  return NewUnlitActor(plane->GetOutput(), card.Color, card.Opacity);
}

// A ray through a place of the picture, in pixels, from the near plane on.
struct Ray
{
  Vector Origin;
  Vector Direction; // of length 1

  Ray(vtkCamera* camera, double x, double y)
  {
    Vector up;
    Vector right;
    camera->GetViewUp(up.data());
    camera->GetDirectionOfProjection(this->Direction.data());
    const Vector& d = this->Direction;
    right = { { d[1] * up[2] - d[2] * up[1], d[2] * up[0] - d[0] * up[2], d[0] * up[1] - d[1] * up[0] } };
    right = 1 / std::sqrt(right[0] * right[0] + right[1] * right[1] + right[2] * right[2]) * right;
    up = { { right[1] * d[2] - right[2] * d[1], right[2] * d[0] - right[0] * d[2],
      right[0] * d[1] - right[1] * d[0] } };
    const double across = x * 2 / Size - 1;
    const double upward = y * 2 / Size - 1;
    camera->GetPosition(this->Origin.data());
    const double near = camera->GetClippingRange()[0];
    if (camera->GetParallelProjection())
    {
      const double scale = camera->GetParallelScale();
      this->Origin = this->Origin + scale * across * right + scale * upward * up + near * d;
      return;
    }
    const double half = std::tan(camera->GetViewAngle() * std::acos(-1.0) / 360);
    const Vector ahead = d + half * across * right + half * upward * up;
    this->Origin = this->Origin + near * ahead;
    this->Direction = 1 / std::sqrt(ahead[0] * ahead[0] + ahead[1] * ahead[1] + ahead[2] * ahead[2]) * ahead;
  }

  double ReachZ(double z) const
  {
    const double along = (z - this->Origin[2]) / this->Direction[2];
    return along > 0 ? along : Infinity;
  }

  // How far it goes inside a box between two distances.
  double GetInside(const Box& box, double from, double to) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const double a = (box.Low[i] - this->Origin[i]) / this->Direction[i];
      const double b = (box.High[i] - this->Origin[i]) / this->Direction[i];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return std::max(to - from, 0.0);
  }
};

double Transmit(const std::vector<Box>& boxes, const Ray& ray, double from, double to, int channel)
{
  double absorbance = 0;
  for (const Box& box : boxes)
  {
    absorbance -= std::log(box.Color[channel]) / box.Distance * ray.GetInside(box, from, to);
  }
  return std::exp(-absorbance);
}

// What a ray brings, of one channel. The cards are sorted from front to back.
double Trace(const Ray& ray, const std::vector<Box>& boxes, const std::vector<Card>& cards, int channel)
{
  double light = 0;
  double passes = 1;
  double from = 0;
  for (const Card& card : cards)
  {
    const double at = ray.ReachZ(card.Z);
    passes *= Transmit(boxes, ray, from, at, channel);
    light += passes * card.Opacity * card.Color[channel];
    passes *= 1 - card.Opacity;
    from = at;
  }
  return light + passes * Transmit(boxes, ray, from, Infinity, channel) * Background[channel];
}

// Each pixel the mean over a grid of so many by so many rays.
Picture Compute(vtkCamera* camera, const std::vector<Box>& boxes, const std::vector<Card>& cards, int grid = 1)
{
  Picture computed{ Size, Size, std::vector<double>(3 * Size * Size) };
  const int fine = grid * Size;
  for (int i = 0; i < fine * fine; ++i)
  {
    const int x = i % fine;
    const int y = i / fine;
    const Ray ray(camera, (x + 0.5) / grid, (y + 0.5) / grid);
    for (int c = 0; c < 3; ++c)
    {
      computed.Rgb[3 * (y / grid * Size + x / grid) + c] += 255 * Trace(ray, boxes, cards, c) / (grid * grid);
    }
  }
  return computed;
}

class MaterialView : public View
{
public:
  explicit MaterialView(int samples = 0)
    : View(Size, Size, samples)
  {
    this->Renderer->SetBackground(Background[0], Background[1], Background[2]);
  }

  void Draw(const std::string& technique, const Settings& settings = {})
  {
    this->Pass = NewTechnique(technique, settings);
    this->SetPass(this->Pass);
    this->Drawn = this->Render();
  }

  void Add(const std::vector<Box>& boxes, const std::vector<Card>& cards)
  {
    for (const Box& box : boxes)
    {
      this->Renderer->AddActor(NewBody(box));
    }
    for (const Card& card : cards)
    {
      this->Renderer->AddActor(NewCard(card));
    }
  }

  void Look(const Vector& from, const Vector& at, double near, double far)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(from.data());
    camera->SetFocalPoint(at.data());
    camera->SetViewAngle(40);
    camera->SetClippingRange(near, far);
  }

  vtkSmartPointer<vtkTranslucencyPass> Pass;
  Picture Drawn;
};

void ExpectNear(const Picture& drawn, const Picture& computed, double bound, const std::string& what)
{
  const PictureDifference difference = Compare(drawn, computed);
  EXPECT_LE(difference.Largest, bound) << what << ": " << difference;
}

const Box Wine{ { { -1, -1, -0.5 } }, { { 1, 1, 0.5 } }, { { 0.6, 0.1, 0.2 } }, 0.8 };

struct Drawing
{
  std::string Technique;
  Settings Options;
  double Bound = 2; // of 255: the framebuffer rounds, and fragments are rounded
};

// All that keep fragments, and all places for them.
const std::vector<Drawing> Drawings{ { "exact", {} }, { "exact", { { "resolve", "iterative" } } },
  { "exact", { { "storage", "t-buffer" } } }, { "exact", { { "storage", "r-buffer" } } },
  { "exact", { { "storage", "m-buffer" } } }, { "exact", { { "color_format", "rgba8" } }, 3 },
  { "exact", { { "storage", "t-buffer" }, { "color_format", "rgba8" } }, 3 }, { "adaptive", {} },
  { "fourier", { { "memory", "variable" } } }, { "shadowmap", { { "memory", "variable" } } },
  { "wavelet", { { "memory", "variable" } } }, { "moment", { { "memory", "variable" } } } };
}

class TestMaterial : public RenderTest
{
};

// A slab's absorption equals the formula from every angle.
TEST_F(TestMaterial, AbsorbsFromEveryAngle)
{
  MaterialView view;
  view.Add({ Wine }, {});
  for (const bool parallel : { false, true })
  {
    for (int angle = 0; angle < 360; angle += 36)
    {
      const double turned = (angle + 5) * std::acos(-1.0) / 180;
      view.Look({ { 5 * std::sin(turned), 1.5, 5 * std::cos(turned) } }, { { 0, 0, 0 } }, 1, 20);
      vtkCamera* camera = view.Renderer->GetActiveCamera();
      camera->SetParallelProjection(parallel);
      camera->SetParallelScale(1.6);
      view.Draw("exact");
      const Picture computed = Compute(camera, { Wine }, {});
      ExpectNear(view.Drawn, computed, 1, (parallel ? "parallel, " : "perspective, ") + std::to_string(angle));
    }
  }
}

// Bodies that overlap, and translucent cards before, in and behind them.
TEST_F(TestMaterial, AbsorbsForEveryTechniqueThatKeepsFragments)
{
  const std::vector<Box> boxes{ Wine, { { { -0.4, -0.9, -1.5 } }, { { 1.3, 0.4, 0.2 } }, { { 0.2, 0.9, 0.5 } }, 1.5 } };
  const std::vector<Card> cards{ { 1, { { 0, 0, 1 } }, 0.2 }, { 0.25, { { 1, 1, 0 } }, 0.4 },
    { -2, { { 0, 1, 0 } }, 0.3 } };
  for (const Drawing& drawing : Drawings)
  {
    MaterialView view;
    view.Add(boxes, cards);
    view.Look({ { 0.7, 0.8, 5 } }, { { 0, 0, 0 } }, 1, 20);
    view.Draw(drawing.Technique, drawing.Options);
    std::string what = drawing.Technique;
    for (const auto& [keyword, value] : drawing.Options)
    {
      what += ' ' + keyword + '=' + value;
    }
    // Sums know the order of three cards nearly.
    const bool sums = drawing.Technique != "exact" && drawing.Technique != "adaptive";
    ExpectNear(view.Drawn, Compute(view.Renderer->GetActiveCamera(), boxes, cards), sums ? 40 : drawing.Bound, what);
  }
}

TEST_F(TestMaterial, AbsorbsFromTheViewerOn)
{
  MaterialView view;
  const std::vector<Box> boxes{ { { { -2, -2, -1 } }, { { 2, 2, 6 } }, { { 0.5, 0.7, 0.9 } }, 2 }, Wine };
  view.Add(boxes, {});
  view.Look({ { 0.2, 0.1, 5 } }, { { 0, 0, 0 } }, 0.5, 20);
  view.Draw("exact");
  ExpectNear(view.Drawn, Compute(view.Renderer->GetActiveCamera(), boxes, {}), 1, "from inside");
}

TEST_F(TestMaterial, AbsorbsUpToOpaqueSurfaces)
{
  MaterialView view;
  const std::vector<Card> opaque{ { 0.1, { { 0.9, 0.5, 0.7 } }, 1 } };
  view.Add({ Wine }, opaque);
  view.Look({ { 0.7, 0.8, 5 } }, { { 0, 0, 0 } }, 1, 20);
  view.Draw("exact");
  ExpectNear(view.Drawn, Compute(view.Renderer->GetActiveCamera(), { Wine }, opaque), 2, "opaque inside");
}

// Without an opaque surface behind, an open body ends at the last translucent surface.
TEST_F(TestMaterial, EndsOpenBodiesAtTheLastSurface)
{
  MaterialView view;
  const auto body = NewBody(Wine);
  body->GetProperty()->BackfaceCullingOn();
  view.Renderer->AddActor(body);
  const std::vector<Card> cards{ { 0, { { 0.9, 0.5, 0.7 } }, 0.5 } };
  view.Add({}, cards);
  view.Look({ { 0, 0, 5 } }, { { 0, 0, 0 } }, 1, 20);
  view.Draw("exact");
  Box half = Wine;
  half.Low[2] = 0;
  const Picture computed = Compute(view.Renderer->GetActiveCamera(), { half }, cards);
  // Around the middle, where the ray enters by the front.
  ExpectNear(Crop(view.Drawn, 20, 20, 20, 20), Crop(computed, 20, 20, 20, 20), 1, "open");
}

TEST_F(TestMaterial, MirroredBodiesAbsorbTheSame)
{
  Box mirrored = Wine;
  mirrored.Low[0] = -0.2;
  mirrored.High[0] = 1.4;
  MaterialView view;
  const auto body = NewBody({ { { -1.4, -1, -0.5 } }, { { 0.2, 1, 0.5 } }, Wine.Color, Wine.Distance });
  body->SetScale(-1, 1, 1);
  view.Renderer->AddActor(body);
  const std::vector<Card> behind{ { -3, { { 0.9, 0.5, 0.7 } }, 1 } }; // what does not end absorbs up to it
  view.Add({}, behind);
  view.Look({ { 0.7, 0.8, 5 } }, { { 0, 0, 0 } }, 1, 20);
  view.Draw("exact");
  ExpectNear(view.Drawn, Compute(view.Renderer->GetActiveCamera(), { mirrored }, behind), 2, "mirrored");
}

// Where surfaces end within a pixel, their depths are those that they would have in its middle.
TEST_F(TestMaterial, AbsorbsWithSamples)
{
  for (const char* technique : { "exact", "adaptive" })
  {
    MaterialView view(8);
    const std::vector<Card> cards{ { 0.25, { { 1, 1, 0 } }, 0.4 } };
    view.Add({ Wine }, cards);
    view.Look({ { 3, 2, 4 } }, { { 0, 0, 0 } }, 1, 20);
    view.Draw(technique);
    const Picture computed = Compute(view.Renderer->GetActiveCamera(), { Wine }, cards, 8);
    EXPECT_LE(Compare(view.Drawn, computed).RootMeanSquare, 0.006) << technique;
    ExpectNear(Crop(view.Drawn, 25, 25, 10, 10), Crop(computed, 25, 25, 10, 10), 2, technique);
  }
}

// A material without attenuation changes nothing, and neither does one that was taken away.
TEST_F(TestMaterial, IsWithoutEffectUntilSomethingIsSet)
{
  MaterialView view;
  const auto body = NewBody(NewSource(Wine), nullptr);
  body->GetProperty()->SetColor(0.3, 0.5, 0.7);
  body->GetProperty()->SetOpacity(0.3);
  view.Renderer->AddActor(body);
  view.Look({ { 0.7, 0.8, 5 } }, { { 0, 0, 0 } }, 1, 20);
  view.Draw("exact");
  const Picture before = view.Drawn;
  vtkNew<vtkTranslucencyMaterial> material;
  vtkTranslucencyMaterial::SetMaterial(body, material);
  EXPECT_EQ(vtkTranslucencyMaterial::GetMaterial(body), material.Get());
  EXPECT_TRUE(view.Render() == before);
  material->SetAttenuationDistance(1);
  EXPECT_TRUE(view.Render() == before);
  material->SetAttenuationColor(0.5, 0.5, 0.5);
  EXPECT_FALSE(view.Render() == before);
  vtkTranslucencyMaterial::SetMaterial(body, nullptr);
  EXPECT_EQ(vtkTranslucencyMaterial::GetMaterial(body), nullptr);
  EXPECT_TRUE(view.Render() == before);
}

TEST_F(TestMaterial, OtherTechniquesSayWhichAbsorb)
{
  for (const Drawing& drawing : std::vector<Drawing>{ { "weighted", {} }, { "mlab", {} }, { "kbuffer", {} },
         { "additive", {} }, { "sorted", {} }, { "stochastic", {} }, { "peel", {} },
         { "adaptive", { { "memory", "fixed" } } }, { "wavelet", { { "memory", "fixed" } } } })
  {
    MaterialView view;
    view.Add({ Wine }, {});
    view.Draw(drawing.Technique, drawing.Options);
    view.Render(); // says nothing more
    std::vector<std::string> said;
    for (const std::string& message : TakeMessages())
    {
      if (message.find("attenuation") != std::string::npos)
      {
        said.push_back(message);
      }
    }
    ASSERT_EQ(said.size(), 1u) << drawing.Technique;
    EXPECT_NE(said[0].find("1 props without their attenuation: it keeps not all fragments"), std::string::npos)
      << said[0];
  }
}

TEST_F(TestMaterial, TellsUpTo31AttenuationsApart)
{
  MaterialView view;
  std::vector<Box> boxes;
  for (int i = 0; i < 31; ++i)
  {
    const double z = -0.2 * i;
    boxes.push_back({ { { -1, -1, z - 0.1 } }, { { 1, 1, z } }, { { 0.5, 0.7, 0.9 } }, 0.5 + 0.1 * i });
  }
  view.Add(boxes, {});
  view.Look({ { 0.7, 0.8, 5 } }, { { 0, 0, 0 } }, 1, 20);
  view.Draw("exact");
  ExpectNear(view.Drawn, Compute(view.Renderer->GetActiveCamera(), boxes, {}), 1, "31");
  view.Renderer->AddActor(NewBody({ { { -1, -1, 1 } }, { { 1, 1, 2 } }, { { 0.1, 0.7, 0.9 } }, 1 }));
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("32 different attenuations, expected at most 31"), std::string::npos) << messages[0];
}

// A lit card that covers the picture, and the cosine of the angle at which each pixel sees it.
class CardView : public MaterialView
{
public:
  explicit CardView(double opacity)
  {
    this->Card = NewCard({ 0, { { 0.2, 0.5, 0.9 } }, opacity });
    this->Card->GetProperty()->LightingOn();
    this->Card->GetProperty()->SetAmbient(1);
    this->Card->GetProperty()->SetDiffuse(0);
    this->Card->ForceTranslucentOn();
    vtkTranslucencyMaterial::SetMaterial(this->Card, this->Material);
    this->Renderer->AddActor(this->Card);
    this->Look({ { 0, 0, 2 } }, { { 0, 0, 0 } }, 1, 20);
    this->Renderer->GetActiveCamera()->SetViewAngle(120);
  }

  // From the cosine and a channel to what is expected.
  void ExpectEach(const std::function<double(double, int)>& expected, const std::string& what)
  {
    Picture computed{ Size, Size, std::vector<double>(3 * Size * Size) };
    for (int i = 0; i < Size * Size; ++i)
    {
      const Ray ray(this->Renderer->GetActiveCamera(), i % Size + 0.5, i / Size + 0.5);
      for (int c = 0; c < 3; ++c)
      {
        computed.Rgb[3 * i + c] = 255 * expected(-ray.Direction[2], c);
      }
    }
    ExpectNear(this->Drawn, computed, 1.5, what);
  }

  const Vector Color{ { 0.2, 0.5, 0.9 } };
  vtkSmartPointer<vtkActor> Card;
  vtkNew<vtkTranslucencyMaterial> Material;
};

const std::vector<Drawing> Surfaces{ { "exact", {} }, { "adaptive", { { "memory", "fixed" } } }, { "mlab", {} },
  { "kbuffer", {} }, { "peel", {} }, { "peel", { { "method", "bucket-sort" } } }, { "weighted", {} }, { "sorted", {} },
  { "fourier", { { "memory", "fixed" } } }, { "wavelet", { { "memory", "fixed" } } } };

TEST_F(TestMaterial, GrazingOpacityGoesOverToThePropsOwn)
{
  for (const Drawing& drawing : Surfaces)
  {
    CardView view(0.2);
    view.Material->SetGrazingOpacity(0.9);
    view.Material->SetGrazingExponent(1.5);
    view.Draw(drawing.Technique, drawing.Options);
    view.ExpectEach(
      [&](double cosine, int c)
      {
        const double opacity = 0.9 + (0.2 - 0.9) * std::pow(cosine, 1.5);
        return opacity * view.Color[c] + (1 - opacity) * Background[c];
      },
      drawing.Technique);
  }
}

TEST_F(TestMaterial, ReflectanceHidesWhatIsTransmitted)
{
  for (const double transmission : { 0.0, 1.0 })
  {
    for (const Drawing& drawing : Surfaces)
    {
      CardView view(0.6);
      view.Material->SetReflectance(0.1);
      vtkTranslucencyPass::SetTransmissionColor(view.Card, transmission, transmission, transmission);
      view.Draw(drawing.Technique, drawing.Options);
      view.ExpectEach(
        [&](double cosine, int c)
        {
          const double reflects = 0.1 + 0.9 * std::pow(1 - cosine, 5);
          const double opacity = reflects + (1 - reflects) * 0.6;
          const double hides = reflects + (1 - reflects) * 0.6 * (1 - transmission);
          return std::min(1.0, opacity * view.Color[c] + (1 - hides) * Background[c]);
        },
        drawing.Technique + " at " + std::to_string(transmission));
    }
  }
  for (const std::string& message : TakeMessages()) // of techniques that keep one transmittance
  {
    EXPECT_NE(message.find("by their mean"), std::string::npos) << message;
  }
}

TEST_F(TestMaterial, EmissionAddsToTheColor)
{
  for (const Drawing& drawing : Surfaces)
  {
    CardView view(0.25);
    view.Material->SetEmissionColor(0.3, 0.1, 0);
    view.Draw(drawing.Technique, drawing.Options);
    const Vector emission{ { 0.3, 0.1, 0 } };
    view.ExpectEach(
      [&](double, int c) { return 0.25 * (view.Color[c] + emission[c]) + 0.75 * Background[c]; }, drawing.Technique);
  }
}

TEST_F(TestMaterial, FacesTheViewerWithoutNormals)
{
  CardView view(0.2);
  view.Card->GetProperty()->LightingOff();
  view.Material->SetGrazingOpacity(0.9);
  view.Material->SetGrazingExponent(2);
  view.Draw("exact");
  view.Render();
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("without normals"), std::string::npos) << messages[0];
  view.ExpectEach([&](double, int c) { return 0.2 * view.Color[c] + 0.8 * Background[c]; }, "unlit");
}

// Frames that refine a view begin anew when a material changes.
TEST_F(TestMaterial, ChangesAreSeenByWhatRefinesAView)
{
  CardView view(0.5);
  view.Draw("stochastic", { { "accumulate", "64" } });
  const Picture before = view.Drawn;
  view.Render();
  view.Material->SetEmissionColor(0.1, 0.1, 0.1);
  view.Render();
  view.Material->SetEmissionColor(0, 0, 0);
  EXPECT_TRUE(view.Render() == before);
}

TEST_F(TestMaterial, RefusesNumbersOutOfRange)
{
  const double nan = std::nan("");
  vtkNew<vtkTranslucencyMaterial> material;
  material->SetAttenuationColor(0.5, 0.6, 0.7);
  material->SetAttenuationDistance(2);
  const vtkMTimeType before = material->GetMTime();
  for (const double channel : { 0.0, -1.0, 1.5, nan, Infinity })
  {
    material->SetAttenuationColor(0.5, channel, 0.5);
  }
  for (const double distance : { 0.0, -1.0, nan })
  {
    material->SetAttenuationDistance(distance);
  }
  EXPECT_EQ(TakeMessages().size(), 8u);
  for (const double number : { -0.1, 1.1, nan })
  {
    material->SetReflectance(number);
    material->SetGrazingOpacity(number);
    material->SetGrazingExponent(1000 * number);
    material->SetEmissionColor(0.1, number > 1 ? Infinity : number, 0.1);
  }
  EXPECT_EQ(TakeMessages().size(), 12u);
  EXPECT_EQ(material->GetMTime(), before);
  EXPECT_EQ(material->GetAttenuationColor()[1], 0.6);
  EXPECT_EQ(material->GetAttenuationDistance(), 2);
  vtkTranslucencyMaterial::SetMaterial(nullptr, material);
  EXPECT_EQ(TakeMessages().size(), 1u);
}
