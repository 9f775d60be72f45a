// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// VTK's passes around ours: the same picture in every frame, no message, and what the same chain draws with VTK's own
// translucent pass.
#include "Chains.h"
#include "GLState.h"
#include "RenderTest.h"
#include "Room.h"

#include <vtkLightsPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>
#include <vtkTranslucencyFactory.h>
#include <vtkTranslucencyPass.h>
#include <vtkTranslucencyVTKVersion.h>
#include <vtkTranslucentPass.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <array>
#include <set>

namespace
{
/// VTK's translucent pass, which leaves all colour attachments but the first as they are, and blends where the passes
/// around have turned that off, as vtkPanoramicProjectionPass does.
class FirstAttachmentPass : public vtkTranslucentPass
{
public:
  static FirstAttachmentPass* New();
  vtkTypeMacro(FirstAttachmentPass, vtkTranslucentPass);

  void Render(const vtkRenderState* state) override
  {
    vtkOpenGLState* gl = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow())->GetState();
    const vtkOpenGLState::ScopedglEnableDisable blending(gl, GL_BLEND);
    gl->vtkglEnable(GL_BLEND);
    this->MaskOthers(GL_FALSE);
    this->Superclass::Render(state);
    this->MaskOthers(GL_TRUE);
  }

private:
  void MaskOthers(unsigned char mask)
  {
    for (GLuint i = 1; i < 3; ++i)
    {
      glColorMaski(i, mask, mask, mask, mask);
    }
  }
};
vtkStandardNewMacro(FirstAttachmentPass);

/// Draws by another pass, which can be exchanged between frames.
class ExchangeablePass : public vtkRenderPass
{
public:
  static ExchangeablePass* New();
  vtkTypeMacro(ExchangeablePass, vtkRenderPass);

  void Render(const vtkRenderState* state) override { this->Pass->Render(state); }
  void ReleaseGraphicsResources(vtkWindow* window) override { this->Pass->ReleaseGraphicsResources(window); }

  vtkSmartPointer<vtkRenderPass> Pass;
};
vtkStandardNewMacro(ExchangeablePass);

/// One technique of each way to draw: lists, records of pixels, targets, and the window's colours.
bool IsOfItsOwnKind(const std::string& technique)
{
  const std::set<std::string> kinds{ "exact", "mlab", "peel", "weighted", "sorted", "screendoor" };
  return kinds.count(technique) > 0;
}

class TestChains
  : public RenderTest
  , public testing::WithParamInterface<std::tuple<Chain, int>>
{
};
}

//------------------------------------------------------------------------------
TEST_P(TestChains, FramesAreAlikeAndAsBlending)
{
  const auto& [chain, samples] = GetParam();
  Room room(samples);
  if (VTKFailsIn(chain.Name, room.Window))
  {
    GTEST_SKIP() << "VTK's FXAA fails in multi-sampled windows";
  }
  vtkNew<ExchangeablePass> current;
  room.Renderer->SetPass(chain.Make(current));
  current->Pass = vtkSmartPointer<FirstAttachmentPass>::New();
  // With zink, VTK's shadows are those of the frame before, in multi-sampled windows, whatever draws what is
  // translucent.
  room.ShowOthers(true);
  room.Render();
  room.ShowOthers(false);
  const Picture changed = room.Render();
  const Picture blended = room.Render();
  const bool late = IsZink() && Compare(changed, blended).Largest > 0;
  const auto show = [&room, late](bool others)
  {
    room.ShowOthers(others);
    if (late)
    {
      room.Render();
    }
  };
  for (const std::string& name : OwnTechniques())
  {
    SCOPED_TRACE(name);
    if (chain.Nested && !IsOfItsOwnKind(name))
    {
      continue;
    }
    current->Pass = NewTechnique(name);
    show(false);
    const PictureDifference difference = Compare(room.Render(), blended);
    if (BlendsOneSurface(name))
    {
      EXPECT_LE(difference.Largest, chain.Bound) << difference;
    }
    show(true);
    const Picture first = room.Render();
    for (int frame = 1; frame < 4; ++frame)
    {
      EXPECT_EQ(Compare(room.Render(), first).Largest, 0) << "frame " << frame;
    }
    EXPECT_EQ(TakeGLErrors(), std::vector<std::string>());
    for (const std::string& message : TakeMessages())
    {
      ADD_FAILURE() << message;
    }
  }
}

namespace
{
/// Where passes are nested, the window's samples have been lost on the way.
std::vector<std::tuple<Chain, int>> ChainsAndSamples()
{
  std::vector<std::tuple<Chain, int>> cases;
  for (const Chain& chain : Chains())
  {
    cases.emplace_back(chain, 0);
    if (!chain.Nested)
    {
      cases.emplace_back(chain, 4);
    }
  }
  return cases;
}
}

INSTANTIATE_TEST_SUITE_P(Chains, TestChains, testing::ValuesIn(ChainsAndSamples()),
  [](const auto& info) { return std::get<0>(info.param).Name + "Samples" + std::to_string(std::get<1>(info.param)); });

namespace
{
/// Draws steps into a framebuffer of two colour attachments, and makes props write to both, as vtkSSAOPass does.
class TwoAttachmentsPass : public vtkOpenGLRenderPass
{
public:
  static TwoAttachmentsPass* New();
  vtkTypeMacro(TwoAttachmentsPass, vtkOpenGLRenderPass);

  void Render(const vtkRenderState* state) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
    const int* size = window->GetSize();
    const std::array<float, 4> value{ { 0.25F, 0.5F, 0.75F, 1 } };
    GLuint framebuffer = 0;
    std::array<GLuint, 3> buffers{}; // colours, what is to be left, depths
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(3, buffers.data());
    window->GetState()->PushFramebufferBindings();
    window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const std::array<GLenum, 3> attachments{ { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_DEPTH_ATTACHMENT } };
    const std::array<GLenum, 3> formats{ { GL_RGBA8, GL_RGBA32F, GL_DEPTH_COMPONENT32F } };
    for (int i = 0; i < 3; ++i)
    {
      glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, this->Samples, formats[i], size[0], size[1]);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
    }
    glDrawBuffers(2, attachments.data());

    this->PreRender(state);
    vtkOpenGLState* gl = window->GetState();
    gl->vtkglViewport(0, 0, size[0], size[1]);
    gl->vtkglScissor(0, 0, size[0], size[1]);
    gl->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->vtkglDepthMask(GL_TRUE);
    gl->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glClearBufferfv(GL_COLOR, 1, value.data());
    vtkNew<vtkLightsPass>()->Render(state);
    this->Pass->Render(state);
    GLint second = 0;
    glGetIntegerv(GL_DRAW_BUFFER1, &second);
    this->FoundAgain = second == GL_COLOR_ATTACHMENT1;
    this->PostRender(state);

    // Samples can't be read, but are resolved by a copy.
    GLuint copy = 0;
    GLuint resolved = 0;
    glGenFramebuffers(1, &copy);
    glGenRenderbuffers(1, &resolved);
    gl->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, copy);
    glBindRenderbuffer(GL_RENDERBUFFER, resolved);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, size[0], size[1]);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved);
    this->Changed = this->CountChanges(GL_COLOR_ATTACHMENT1, framebuffer, copy, size, value);
    this->Drawn = this->CountChanges(GL_COLOR_ATTACHMENT0, framebuffer, copy, size, { { 0, 0, 0, 0 } });
    gl->PopFramebufferBindings();
    glDeleteFramebuffers(1, &copy);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &resolved);
    glDeleteRenderbuffers(3, buffers.data());
  }

  bool PostReplaceShaderValues(
    std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*) override
  {
    vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::Light::Impl", "//VTK::Light::Impl\n  gl_FragData[1] = vec4(1.0);\n", false);
    return true;
  }

  vtkSmartPointer<vtkRenderPass> Pass;
  int Samples = 0;
  int Changed = 0; // pixels of the second attachment
  int Drawn = 0;   // pixels of the first
  bool FoundAgain = false;

private:
  static int CountChanges(GLenum attachment, GLuint from, GLuint to, const int* size, const std::array<float, 4>& value)
  {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glReadBuffer(attachment);
    glBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, to);
    std::vector<std::array<float, 4>> pixels(static_cast<std::size_t>(size[0]) * size[1]);
    glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_FLOAT, pixels.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    return static_cast<int>(
      std::count_if(pixels.begin(), pixels.end(), [&value](const auto& pixel) { return pixel != value; }));
  }
};
vtkStandardNewMacro(TwoAttachmentsPass);

using TestChainsOfFallbacks = RenderTest;

class TestChainsOfAttachments
  : public RenderTest
  , public testing::WithParamInterface<int>
{
};
}

//------------------------------------------------------------------------------
TEST_P(TestChainsOfAttachments, OthersThanTheFirstAreLeft)
{
  Room room(0);
  vtkNew<TwoAttachmentsPass> attachments;
  attachments->Samples = GetParam();
  room.Renderer->SetPass(attachments);
  attachments->Pass = vtkSmartPointer<vtkTranslucentPass>::New();
  room.Render();
  EXPECT_GT(attachments->Changed, 200) << "what VTK draws goes to both";
  for (const std::string& name : OwnTechniques())
  {
    SCOPED_TRACE(name);
    attachments->Pass = NewTechnique(name);
    room.Render();
    EXPECT_GT(attachments->Drawn, 200);
    EXPECT_EQ(attachments->Changed, 0);
    EXPECT_TRUE(attachments->FoundAgain);
    EXPECT_EQ(TakeGLErrors(), std::vector<std::string>());
  }
}

INSTANTIATE_TEST_SUITE_P(
  Samples, TestChainsOfAttachments, testing::Values(0, 4), [](const auto& info) { return std::to_string(info.param); });

//------------------------------------------------------------------------------
// Depth peeling of VTK's own has framebuffers of its own, too.
TEST_F(TestChainsOfFallbacks, DrawWithinSSAO)
{
  for (const Chain& chain : Chains())
  {
    if (chain.Name == "SSAO" || chain.Name == "SSAAOverSSAO")
    {
      SCOPED_TRACE(chain.Name);
      Room room(0);
      room.ShowOthers(false);
      vtkNew<ExchangeablePass> current;
      room.Renderer->SetPass(chain.Make(current));
      current->Pass = vtkSmartPointer<FirstAttachmentPass>::New();
      const Picture blended = room.Render();
      current->Pass = NewTechnique("exact", { { "memory_limit", "0.0001" } });
      for (int frame = 0; frame < 3; ++frame)
      {
        const PictureDifference difference = Compare(room.Render(), blended);
        EXPECT_LE(difference.Largest, chain.Bound) << difference;
      }
      EXPECT_EQ(TakeMessages().size(), 1u) << "that it falls back";
    }
  }
}

//------------------------------------------------------------------------------
using TestChainsInWindows = RenderTest;

// The passes around are released with their window: what changes the props' keys while it draws holds nothing in the
// end.
TEST_F(TestChainsInWindows, GoWithThem)
{
  for (const Chain& chain : Chains())
  {
    SCOPED_TRACE(chain.Name);
    vtkWeakPointer<vtkRenderPass> outermost;
    {
      Room room(0);
      vtkNew<ExchangeablePass> current;
      current->Pass = NewTechnique("exact");
      const vtkSmartPointer<vtkRenderPass> made = chain.Make(current);
      outermost = made;
      room.Renderer->SetPass(made);
      room.Render();
      room.Render();
    }
    EXPECT_EQ(outermost, nullptr);
  }
}
