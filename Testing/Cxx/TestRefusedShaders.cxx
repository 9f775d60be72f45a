// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Drivers that have an extension, but whose compiler does not know it in shaders of VTK's version of GLSL, as the
// specifications of some extensions allow. CMakeLists.txt runs this with an interlock claimed.
#include "RenderTest.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkTranslucencyCapabilities.h>
#include <vtkTranslucencyStatistics.h>
#include <vtkTranslucencyVTKVersion.h>

namespace
{
std::string Unknown; // an extension, or what the names of several have in common
decltype(glShaderSource) Compilers = nullptr;

void TakeSource(GLuint shader, GLsizei count, const GLchar* const* strings, const GLint* lengths)
{
  ASSERT_EQ(count, 1);
  ASSERT_EQ(lengths, nullptr);
  std::string source = *strings;
  for (std::size_t at = source.find(Unknown); at != std::string::npos; at = source.find(Unknown, at + Unknown.size()))
  {
    source.replace(at, Unknown.size(), std::string(Unknown.size(), 'x'));
  }
  const GLchar* text = source.c_str();
  Compilers(shader, 1, &text, nullptr);
}

class TestRefusedShaders : public RenderTest
{
protected:
  // From now on the compiler does not know an extension. Needs a context.
  static void Forget(const std::string& extension)
  {
    Unknown = extension;
    Compilers = glShaderSource;
    glShaderSource = TakeSource;
  }

  void TearDown() override
  {
    if (Compilers)
    {
      glShaderSource = Compilers;
      Compilers = nullptr;
    }
    RenderTest::TearDown();
  }

  static vtkTranslucencyCapabilities Probe(View& view)
  {
    return vtkTranslucencyCapabilities::Probe(vtkOpenGLRenderWindow::SafeDownCast(view.Window));
  }

  const AnalyticScene Scene = RandomLayers(200, 160, 71, 20, 0.1, 0.6);
};
}

//------------------------------------------------------------------------------
TEST_F(TestRefusedShaders, OfStorageBlocksAreWarnedOfOnceAndPeeledInstead)
{
  View view(this->Scene);
  view.Render();
  EXPECT_EQ(Probe(view).MissingForStorage, "");
  Forget("GL_ARB_shader_storage_buffer_object");
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  for (int frame = 0; frame < 2; ++frame)
  {
    const PictureDifference difference = Compare(view.Render(), this->Scene.Compute(Reference::CompositeExact));
    EXPECT_LE(difference.Largest, 4) << difference; // peeling accumulates in bytes
    EXPECT_EQ(pass->GetStatistics()->GetFallback(), "peeling");
  }
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("Warning"), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find("lacks a compiler for storage blocks (shader Common/Trial.glsl does not compile"),
    std::string::npos)
    << messages[0];
}

//------------------------------------------------------------------------------
TEST_F(TestRefusedShaders, OfCoverageMasksAreDrawnWithOneSample)
{
  View view(this->Scene, 4);
  view.Render();
  if (!Probe(view).MissingForSamples.empty())
  {
    GTEST_SKIP() << "the driver has no masks";
  }
  Forget("GL_ARB_post_depth_coverage");
  vtkNew<vtkABufferPass> pass;
  view.SetPass(pass);
  view.Render();
  view.Render();
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("drawing it with one sample a pixel"), std::string::npos) << messages[0];
}

//------------------------------------------------------------------------------
TEST_F(TestRefusedShaders, OfFetchedColorsAreReplacedByBuffers)
{
  View view(this->Scene);
  view.Render();
  if (!Probe(view).MissingForFetch.empty())
  {
    GTEST_SKIP() << "the driver fetches no colours";
  }
  const auto fetching = NewTechnique("mlab");
  view.SetPass(fetching);
  const Picture expected = view.Render();
  Forget("GL_EXT_shader_framebuffer_fetch");
  const auto pass = NewTechnique("mlab");
  view.SetPass(pass);
  EXPECT_LE(Compare(view.Render(), expected).Largest, 1);
  EXPECT_EQ(pass->GetStatistics()->GetFallback(), "");
}

//------------------------------------------------------------------------------
TEST_F(TestRefusedShaders, OfInterlocksLeaveSpinLocks)
{
  View view(this->Scene);
  view.Render();
  if (Probe(view).Interlock != "GL_ARB_fragment_shader_interlock")
  {
    GTEST_SKIP() << "the driver has no interlock";
  }
  Forget("_fragment_shader_interlock"); // NVIDIA's, too
  EXPECT_EQ(Probe(view).Interlock, "");
}
