// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// What is drawn by a driver that lacks what the storage needs, or what every technique needs: CMakeLists.txt runs this
// with one extension switched off in Mesa at a time.
#include "RenderTest.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyStatistics.h>

#include <cstdlib>

class TestFallback : public RenderTest
{
protected:
  void SetUp() override
  {
    RenderTest::SetUp();
    const char* overridden = std::getenv("MESA_EXTENSION_OVERRIDE");
    ASSERT_TRUE(overridden) << "to be run with MESA_EXTENSION_OVERRIDE=-GL_...";
    this->Extension = overridden + 1;
  }

  std::string Extension;
};

//------------------------------------------------------------------------------
TEST_F(TestFallback, WarnsOnceAndPeels)
{
  const AnalyticScene scene = RandomLayers(200, 160, 71, 20, 0.1, 0.6);
  const Picture exact = scene.Compute(Reference::CompositeExact);
  View view(scene);
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  view.SetPass(pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    const PictureDifference difference = Compare(view.Render(), exact);
    EXPECT_LE(difference.Largest, 4) << difference; // peeling accumulates in bytes
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
  }
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("Warning"), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find("lacks " + this->Extension), std::string::npos) << messages[0];
  EXPECT_NE(
    pass->GetMissing(vtkOpenGLRenderWindow::SafeDownCast(view.Window)).find(this->Extension), std::string::npos);
}

//------------------------------------------------------------------------------
TEST_F(TestFallback, PeelsTheSameAmongRenderSteps)
{
  const AnalyticScene scene = RandomLayers(200, 160, 71, 20, 0.1, 0.6);
  View view(scene);
  vtkNew<vtkABufferPass> pass;
  view.SetTranslucentPass(pass);
  const PictureDifference difference = Compare(view.Render(), scene.Compute(Reference::CompositeExact));
  EXPECT_LE(difference.Largest, 4) << difference;
  EXPECT_EQ(TakeMessages().size(), 1u);
}

//------------------------------------------------------------------------------
// Without what every technique needs only VTK is left, whose peeling draws nothing there: it is blended.
TEST_F(TestFallback, DrawsWithMultiSampling)
{
  const AnalyticScene scene = RandomLayers(200, 160, 71, 20, 0.1, 0.6);
  View view(scene, 4);
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  const Picture picture = view.Render();
  if (this->Extension == "GL_ARB_shader_bit_encoding")
  {
    AnalyticScene opaque = scene;
    opaque.Translucent.clear();
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "blending");
    EXPECT_GT(Compare(picture, opaque.Compute(Reference::CompositeExact)).RootMeanSquare, 0.05)
      << "nothing translucent was drawn";
  }
  else
  {
    const PictureDifference difference = Compare(picture, scene.Compute(Reference::CompositeExact));
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
    EXPECT_LE(difference.Largest, 1) << difference;
  }
  EXPECT_EQ(TakeMessages().size(), 1u);
}

//------------------------------------------------------------------------------
// Without what every technique needs VTK draws. CMakeLists.txt runs this so.
class TestFallbackOfTargets
  : public TestFallback
  , public testing::WithParamInterface<std::string>
{
};

TEST_P(TestFallbackOfTargets, NamesWhatTheDriverLacks)
{
  const AnalyticScene scene = RandomLayers(200, 160, 71, 20, 0.1, 0.6);
  const auto pass = NewTechnique(this->GetParam());
  View view(scene);
  view.SetPass(pass);
  EXPECT_LE(Compare(view.Render(), scene.Compute(Reference::CompositeExact)).Largest, 4); // in bytes
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("lacks " + this->Extension), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find("by VTK's depth peeling"), std::string::npos) << messages[0];
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, TestFallbackOfTargets, testing::Values("peel", "weighted"), [](const auto& info) { return info.param; });

//------------------------------------------------------------------------------
// Where fragments come in any order, and shaders can't tell helper invocations, which must not wait. CMakeLists.txt
// runs this without the extension by which they can.
class TestFallbackOfRetries : public TestFallback
{
protected:
  void Draw(vtkTranslucencyPass* pass)
  {
    const AnalyticScene scene = RandomLayers(200, 160, 71, 20, 0.1, 0.6);
    View view(scene);
    view.SetPass(pass);
    EXPECT_LE(Compare(view.Render(), scene.Compute(Reference::CompositeExact)).Largest, 4); // peeling: in bytes
  }
};

TEST_F(TestFallbackOfRetries, IsForSpinLocksAndSections)
{
  std::vector<vtkSmartPointer<vtkTranslucencyPass>> passes{ NewTechnique("exact", { { "storage", "t-buffer" } }),
    NewTechnique("exact", { { "storage", "m-buffer" } }),
    NewTechnique("mlab", { { "critical_section", "spinlock" } }) };
  View view(8, 8);
  view.Render();
  if (vtkTranslucencyCapabilities::Probe(vtkOpenGLRenderWindow::SafeDownCast(view.Window)).Interlock.empty())
  {
    passes.push_back(NewTechnique("mlab"));
    passes.push_back(NewTechnique("peel", { { "method", "bucket-sort" } }));
    passes.push_back(NewTechnique("adaptive", { { "memory", "fixed" } }));
  }
  for (const auto& pass : passes)
  {
    this->Draw(pass);
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("lacks " + this->Extension), std::string::npos) << messages[0];
  }
}

TEST_F(TestFallbackOfRetries, IsNotForListsAndQueues)
{
  for (const char* storage : { "linked-list", "r-buffer" })
  {
    const auto pass = NewTechnique("exact", { { "storage", storage } });
    this->Draw(pass);
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
    EXPECT_TRUE(TakeMessages().empty());
  }
}
