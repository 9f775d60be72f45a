// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyPeelingGuard.h"

#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkDepthPeelingPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstring>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// What a pass of VTK's has drawn: the first channels of all buffers that are drawn to, within the viewport, and the
// depths.
std::vector<float> ReadDrawn(vtkOpenGLState* state)
{
  GLint most = 0;
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &most);
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  state->PushReadFramebufferBinding();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, vtkTranslucencyGLState::GetDrawFramebuffer());
  GLint readBuffer = 0;
  glGetIntegerv(GL_READ_BUFFER, &readBuffer);
  constexpr std::size_t channels = 4;
  const std::size_t pixels = static_cast<std::size_t>(viewport[2]) * viewport[3];
  std::vector<float> all;
  for (GLint i = 0; i < most; ++i)
  {
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER0 + static_cast<GLenum>(i), &buffer);
    if (buffer != GL_NONE)
    {
      all.resize(all.size() + channels * pixels);
      glReadBuffer(static_cast<GLenum>(buffer));
      glReadPixels(viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA, GL_FLOAT,
        all.data() + all.size() - channels * pixels);
    }
  }
  GLint depth = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &depth);
  if (depth != GL_NONE)
  {
    all.resize(all.size() + pixels);
    glReadPixels(viewport[0], viewport[1], viewport[2], viewport[3], GL_DEPTH_COMPONENT, GL_FLOAT,
      all.data() + all.size() - pixels);
  }
  glReadBuffer(static_cast<GLenum>(readBuffer));
  state->PopReadFramebufferBinding();
  return all;
}

bool IsPowerOfTwo(int number)
{
  return (number & (number - 1)) == 0;
}
}

// Stands for the pass that draws the translucent props while VTK peels.
class vtkTranslucencyGuardedPass : public vtkRenderPass
{
public:
  static vtkTranslucencyGuardedPass* New();
  vtkTypeMacro(vtkTranslucencyGuardedPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    if (this->Drawings++ == 0) // what it spoils VTK does not draw again
    {
      this->Found = this->Unreached->LookAhead(
        state, this->Window, [this](const vtkRenderState* some) { this->Delegate->Render(some); });
    }
    std::vector<vtkProp*> reached;
    for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
    {
      vtkProp* prop = vtkTranslucencyProp(state, i);
      if (!this->Unreached->Has(prop))
      {
        reached.push_back(prop);
      }
    }
    vtkRenderState others(state->GetRenderer());
    vtkTranslucencySetProps(others, reached, state);
    this->Delegate->Render(&others);
    this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
    this->EndIfNothingChanges();
  }

  vtkRenderPass* Delegate = nullptr;
  vtkDepthPeelingPass* Peeling = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkTranslucencyUnreached* Unreached = nullptr;
  std::string Found;

private:
  void EndIfNothingChanges()
  {
    constexpr int few = 16; // they end before that
    if (this->Drawings < few - 1)
    {
      return;
    }
    if (IsPowerOfTwo(this->Drawings + 1))
    {
      this->Drawn = ReadDrawn(this->Window->GetState());
    }
    else if (IsPowerOfTwo(this->Drawings))
    {
      const std::vector<float> now = ReadDrawn(this->Window->GetState());
      const bool same = now.size() == this->Drawn.size() &&
        std::memcmp(now.data(), this->Drawn.data(), now.size() * sizeof(float)) == 0; // NaN is what it was, too
      if (same)
      {
        this->Peeling->SetMaximumNumberOfPeels(1);
      }
    }
  }

  int Drawings = 0;
  std::vector<float> Drawn;
};
vtkStandardNewMacro(vtkTranslucencyGuardedPass);

//------------------------------------------------------------------------------
vtkTranslucencyPeelingGuard::vtkTranslucencyPeelingGuard()
  : Unreached({ "opaqueDepth", "lastDepthPeel",
      "translucentZTexture" }) // what VTK's two passes declare, the first one for each stage
{
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyPeelingGuard::Render(vtkDepthPeelingPass* peeling, const vtkRenderState* state,
  vtkOpenGLRenderWindow* window, const std::function<void()>& render)
{
  const vtkSmartPointer<vtkRenderPass> delegate = peeling->GetTranslucentPass();
  const int most = peeling->GetMaximumNumberOfPeels();
  vtkNew<vtkTranslucencyGuardedPass> guarded;
  guarded->Delegate = delegate;
  guarded->Peeling = peeling;
  guarded->Window = window;
  guarded->Unreached = &this->Unreached;
  peeling->SetTranslucentPass(guarded);
  render();
  peeling->SetTranslucentPass(delegate);
  peeling->SetMaximumNumberOfPeels(most);

  std::vector<vtkProp*> unreached;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    if (this->Unreached.Has(prop))
    {
      unreached.push_back(prop);
    }
  }
  if (!unreached.empty())
  {
    window->GetState()->vtkglDepthMask(GL_FALSE);
    vtkTranslucencyGLState::UsePlainBlending(window->GetState());
    vtkRenderState others(state->GetRenderer());
    vtkTranslucencySetProps(others, unreached, state);
    delegate->Render(&others);
  }
  return guarded->Found.empty()
    ? ""
    : guarded->Found + " can't be peeled, since its shaders can't be reached; it is drawn over what can, by blending";
}
VTK_ABI_NAMESPACE_END
