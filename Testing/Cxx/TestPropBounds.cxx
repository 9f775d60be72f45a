// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Bounds that are kept from frame to frame are those that props would tell: after each way to change them.
#include "vtkTranslucencyPropBounds.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace
{
using Bounds = vtkTranslucencyPropBounds::Bounds;

Bounds Tell(vtkProp* prop)
{
  Bounds bounds;
  std::copy_n(prop->GetBounds(), bounds.size(), bounds.begin());
  return bounds;
}

/// An actor that counts how often it is asked.
class AskedActor : public vtkActor
{
public:
  static AskedActor* New();
  vtkTypeMacro(AskedActor, vtkActor);

  double* GetBounds() override
  {
    ++this->Asked;
    return this->Superclass::GetBounds();
  }
  using vtkActor::GetBounds;

  int Asked = 0;
};
vtkStandardNewMacro(AskedActor);

/// A mapper that draws its data larger.
class LargeMapper : public vtkPolyDataMapper
{
public:
  static LargeMapper* New();
  vtkTypeMacro(LargeMapper, vtkPolyDataMapper);

  void SetSize(double size)
  {
    this->Size = size;
    this->Modified();
  }

  double* GetBounds() override
  {
    this->Superclass::GetBounds();
    std::for_each(this->Bounds, this->Bounds + 6, [this](double& bound) { bound *= this->Size; });
    return this->Bounds;
  }
  using vtkPolyDataMapper::GetBounds;

private:
  double Size = 1;
};
vtkStandardNewMacro(LargeMapper);

/// A sphere, drawn by an actor.
struct Sphere
{
  Sphere()
  {
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
  }

  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<AskedActor> Actor;
};

TEST(TestPropBounds, AnActorIsAskedOnceUntilItChanges)
{
  Sphere sphere;
  vtkTranslucencyPropBounds kept;
  const Bounds first = kept.Get({ sphere.Actor })[0];
  EXPECT_TRUE(vtkMath::AreBoundsInitialized(first.data()));
  for (int frame = 0; frame < 5; ++frame)
  {
    EXPECT_EQ(first, kept.Get({ sphere.Actor })[0]);
  }
  EXPECT_EQ(sphere.Actor->Asked, 1);

  kept.Get({}); // not drawn: forgotten
  EXPECT_EQ(first, kept.Get({ sphere.Actor })[0]);
  EXPECT_EQ(sphere.Actor->Asked, 2);
}

TEST(TestPropBounds, EachChangeIsSeen)
{
  Sphere sphere;
  vtkNew<vtkTransform> transform;
  transform->Translate(1, 0, 0);
  vtkNew<vtkPolyData> data;
  vtkNew<vtkSphereSource> source;
  source->Update();
  vtkNew<vtkPolyData> older;
  older->DeepCopy(source->GetOutput());
  source->SetRadius(9);
  source->Update();
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(source->GetOutput());
  vtkNew<LargeMapper> other;
  other->SetInputConnection(producer->GetOutputPort());

  const std::pair<const char*, std::function<void()>> changes[] = {
    { "position", [&] { sphere.Actor->SetPosition(1, 2, 3); } },
    { "scale", [&] { sphere.Actor->SetScale(2); } },
    { "user transform", [&] { sphere.Actor->SetUserTransform(transform); } },
    { "user transform moved", [&] { transform->Translate(0, 0, 5); } },
    { "source",
      [&]
      {
        sphere.Source->SetRadius(3);
        sphere.Source->Update(); // as VTK's renderer has it done before the pass
      } },
    { "another mapper", [&] { sphere.Actor->SetMapper(other); } },
    { "the mapper's size", [&] { other->SetSize(2); } },
    { "older data",
      [&]
      {
        producer->SetOutput(older);
        producer->Update();
      } },
    { "the first mapper", [&] { sphere.Actor->SetMapper(sphere.Mapper); } },
    { "data",
      [&]
      {
        data->DeepCopy(sphere.Source->GetOutput());
        data->GetPoints()->SetPoint(0, 20, 0, 0);
        sphere.Mapper->SetInputData(data);
      } },
    { "a point",
      [&]
      {
        data->GetPoints()->SetPoint(0, 30, 0, 0);
        data->GetPoints()->Modified();
      } },
  };
  vtkTranslucencyPropBounds kept;
  Bounds before = kept.Get({ sphere.Actor })[0];
  for (const auto& [name, change] : changes)
  {
    SCOPED_TRACE(name);
    change();
    const Bounds now = kept.Get({ sphere.Actor })[0];
    EXPECT_EQ(now, Tell(sphere.Actor));
    EXPECT_NE(now, before);
    before = now;
  }
}

TEST(TestPropBounds, WhatMayChangeByItselfIsAskedAlways)
{
  Sphere sphere;
  vtkNew<vtkGlyph3DMapper> glyphs; // its second input is what it draws at each point
  vtkNew<vtkSphereSource> glyph;
  glyphs->SetInputConnection(sphere.Source->GetOutputPort());
  glyphs->SetSourceConnection(glyph->GetOutputPort());
  sphere.Actor->SetMapper(glyphs);
  vtkNew<AskedActor> part;
  part->SetMapper(sphere.Mapper);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(part);

  vtkTranslucencyPropBounds kept;
  kept.Get({ sphere.Actor, assembly });
  glyph->SetRadius(7);
  part->SetPosition(4, 0, 0);
  const auto now = kept.Get({ sphere.Actor, assembly });
  EXPECT_EQ(sphere.Actor->Asked, 2);
  EXPECT_EQ(now[0], Tell(sphere.Actor));
  EXPECT_EQ(now[1], Tell(assembly));
}

TEST(TestPropBounds, AnEmptyActorHasNone)
{
  vtkNew<vtkActor> bare;
  vtkNew<vtkActor> empty;
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(nothing);
  empty->SetMapper(mapper);
  vtkTranslucencyPropBounds kept;
  for (const Bounds& bounds : kept.Get({ bare, empty }))
  {
    EXPECT_FALSE(vtkMath::AreBoundsInitialized(bounds.data()));
  }
}
}
