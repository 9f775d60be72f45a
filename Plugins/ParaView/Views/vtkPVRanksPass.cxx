// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRanksPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVRanksPass);

//------------------------------------------------------------------------------
vtkPVRanksPass::vtkPVRanksPass() = default;

//------------------------------------------------------------------------------
vtkPVRanksPass::~vtkPVRanksPass() = default;

#if VTK_MODULE_ENABLE_ParaView_icet
#include "vtkPVFramebuffer.h"
#include "vtkTranslucencyVTKVersion.h" // OpenGL's functions

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkIceTContext.h"
#include "vtkIceTSynchronizedRenderers.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <IceT.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
// Members of ParaView's that have no other door: derived classes may name them.
class RanksWithCamera : public vtkIceTSynchronizedRenderers
{
public:
  static vtkCameraPass* Get(vtkIceTSynchronizedRenderers* ranks)
  {
    return ranks->*(&RanksWithCamera::CameraRenderPass);
  }
};

class OpenCompositePass : public vtkIceTCompositePass
{
public:
  static bool HasValues(vtkIceTCompositePass* pass) { return pass->*(&OpenCompositePass::EnableFloatValuePass); }

  // What the pass would have of a frame that it has drawn: on the rank that shows it a picture.
  static void SetPicture(vtkIceTCompositePass* pass, const std::vector<unsigned char>& colors, int width, int height)
  {
    (pass->*(&OpenCompositePass::LastRenderedDepths))->SetNumberOfTuples(0);
    (pass->*(&OpenCompositePass::LastRenderedRGBA32F))->SetNumberOfTuples(0);
    vtkSynchronizedRenderers::vtkRawImage& picture = *(pass->*(&OpenCompositePass::LastRenderedRGBAColors));
    picture.MarkInValid();
    if (!colors.empty())
    {
      picture.Resize(width, height, 4);
      std::copy(colors.begin(), colors.end(), picture.GetRawPtr()->GetPointer(0));
      picture.MarkValid();
    }
  }

  static void Display(vtkIceTCompositePass* pass, const vtkRenderState* state)
  {
    (pass->*(&OpenCompositePass::DisplayResultsIfNeeded))(state);
  }
};

// What a pass draws, by rows from below, premultiplied. It leaves its depths in the framebuffer that is bound.
std::vector<float> Draw(vtkRenderPass* pass, const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  const int area[] = { 0, 0, window->GetActualSize()[0], window->GetActualSize()[1] };
  vtkOpenGLState* gl = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(gl);
  const vtkOpenGLState::ScopedglScissor scissor(gl);
  const vtkOpenGLState::ScopedglClearColor clearColor(gl);
  const unsigned int bound = vtkPVFramebuffer::GetBound();
  vtkPVFramebuffer own;
  own.Allocate(window, area[2], area[3], 0, GL_RGBA16);
  gl->PushFramebufferBindings();
  gl->vtkglBindFramebuffer(GL_FRAMEBUFFER, own.GetName());
  gl->vtkglViewport(0, 0, area[2], area[3]);
  gl->vtkglScissor(0, 0, area[2], area[3]);
  gl->vtkglDepthMask(GL_TRUE);
  gl->vtkglClearColor(0, 0, 0, 0);
  gl->vtkglClearDepth(1);
  gl->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  pass->Render(state);
  vtkPVFramebuffer::Copy(gl, own.GetName(), bound, area, GL_DEPTH_BUFFER_BIT);
  std::vector<float> colors(size_t(4) * area[2] * area[3]);
  glReadPixels(0, 0, area[2], area[3], GL_RGBA, GL_FLOAT, colors.data());
  gl->PopFramebufferBindings();
  own.Free();
  // IceT takes what has no opacity for empty: what only adds light has none.
  for (size_t i = 0; i < colors.size(); i += 4)
  {
    if (colors[i + 3] == 0 && colors[i] + colors[i + 1] + colors[i + 2] > 0)
    {
      colors[i + 3] = std::numeric_limits<float>::min();
    }
  }
  return colors;
}

// By the context that is current: all ranks' parts on rank 0, and nothing on the others.
std::vector<unsigned char> Compose(const std::vector<float>& part, int width, int height, const std::vector<int>& order)
{
  icetResetTiles();
  icetAddTile(0, 0, width, height, 0);
  icetStrategy(ICET_STRATEGY_SEQUENTIAL);
  icetSetColorFormat(ICET_IMAGE_COLOR_RGBA_FLOAT);
  icetSetDepthFormat(ICET_IMAGE_DEPTH_NONE);
  icetCompositeMode(ICET_COMPOSITE_MODE_BLEND);
  icetEnable(ICET_ORDERED_COMPOSITE);
  const std::vector<IceTInt> ranks(order.begin(), order.end());
  icetCompositeOrder(ranks.data());
  const float background[] = { 0, 0, 0, 0 };
  const IceTImage whole = icetCompositeImage(part.data(), nullptr, nullptr, nullptr, nullptr, background);
  std::vector<unsigned char> colors;
  if (icetImageGetColorFormat(whole) != ICET_IMAGE_COLOR_NONE)
  {
    const float* found = icetImageGetColorcf(whole);
    colors.resize(part.size());
    std::transform(found, found + part.size(), colors.begin(),
      [](float value) { return static_cast<unsigned char>(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f); });
  }
  return colors;
}
}

//------------------------------------------------------------------------------
bool vtkPVRanksPass::CanRender(vtkSynchronizedRenderers* ranks, vtkRenderer* renderer, vtkRenderPass* pass)
{
  auto* icet = vtkIceTSynchronizedRenderers::SafeDownCast(ranks);
  vtkIceTCompositePass* composite = icet ? icet->GetIceTCompositePass() : nullptr;
  if (!pass || !composite || composite->GetRenderPass() != pass)
  {
    return false;
  }
  vtkOrderedCompositingHelper* order = composite->GetOrderedCompositingHelper();
  vtkMultiProcessController* controller = composite->GetController();
  const bool ordered = composite->GetUseOrderedCompositing() && order && controller &&
    static_cast<int>(order->GetBoundingBoxes().size()) == controller->GetNumberOfProcesses();
  const int* tiles = composite->GetTileDimensions();
  const double* viewport = renderer->GetViewport();
  const bool whole = tiles[0] == 1 && tiles[1] == 1 && composite->GetImageReductionFactor() == 1 && viewport[0] == 0 &&
    viewport[1] == 0 && viewport[2] == 1 && viewport[3] == 1;
  return ordered && whole && !composite->GetDataReplicatedOnAllProcesses() && !renderer->GetSelector() &&
    !OpenCompositePass::HasValues(composite) && vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
}

//------------------------------------------------------------------------------
void vtkPVRanksPass::PutIn(vtkSynchronizedRenderers* ranks)
{
  this->Ranks = vtkIceTSynchronizedRenderers::SafeDownCast(ranks);
  RanksWithCamera::Get(this->Ranks)->SetDelegatePass(this);
}

//------------------------------------------------------------------------------
void vtkPVRanksPass::TakeOut()
{
  if (this->Ranks)
  {
    RanksWithCamera::Get(this->Ranks)->SetDelegatePass(this->Ranks->GetIceTCompositePass());
    this->Ranks = nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkPVRanksPass::Render(const vtkRenderState* state)
{
  vtkIceTCompositePass* composite = this->Ranks->GetIceTCompositePass();
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Context)
  {
    this->Context = vtkSmartPointer<vtkIceTContext>::New();
  }
  this->Context->SetController(composite->GetController());
  if (!this->Context->IsValid())
  {
    vtkErrorMacro("IceT has no context for these ranks: they need MPI");
    return;
  }
  const std::vector<float> part = Draw(composite->GetRenderPass(), state, window);
  this->NumberOfRenderedProps = composite->GetRenderPass()->GetNumberOfRenderedProps();
  this->Context->MakeCurrent();
  const int width = window->GetActualSize()[0];
  const int height = window->GetActualSize()[1];
  const std::vector<int> order =
    composite->GetOrderedCompositingHelper()->ComputeSortOrder(renderer->GetActiveCamera());
  OpenCompositePass::SetPicture(composite, Compose(part, width, height, order), width, height);
  OpenCompositePass::Display(composite, state);
}

#else // a ParaView without MPI, whose ranks are one
//------------------------------------------------------------------------------
bool vtkPVRanksPass::CanRender(vtkSynchronizedRenderers*, vtkRenderer*, vtkRenderPass*)
{
  return false;
}

//------------------------------------------------------------------------------
void vtkPVRanksPass::PutIn(vtkSynchronizedRenderers*) {}

//------------------------------------------------------------------------------
void vtkPVRanksPass::TakeOut() {}

//------------------------------------------------------------------------------
void vtkPVRanksPass::Render(const vtkRenderState*) {}
#endif
