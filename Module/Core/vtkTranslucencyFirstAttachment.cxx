// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyFirstAttachment.h"

#include "vtkTranslucencyVTKVersion.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
bool DrawsToOthers(vtkObjectBase* pass)
{
  return pass->IsA("vtkSSAOPass");
}

void SetHooks(vtkInformation* keys, const std::vector<vtkObjectBase*>& hooks)
{
  // One by one: VTK does not release what it holds if the key goes as a whole.
  for (int k = keys->Length(vtkOpenGLRenderPass::RenderPasses()) - 1; k >= 0; --k)
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), k);
  }
  for (vtkObjectBase* hook : hooks)
  {
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), hook);
  }
}
}

//------------------------------------------------------------------------------
vtkTranslucencyFirstAttachment::vtkTranslucencyFirstAttachment(const vtkRenderState* state)
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &most);
  for (int i = 0; i < most; ++i)
  {
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER0 + i, &buffer);
    this->DrawBuffers.push_back(static_cast<GLenum>(buffer));
  }
  while (!this->DrawBuffers.empty() && this->DrawBuffers.back() == GL_NONE)
  {
    this->DrawBuffers.pop_back();
  }
  // Not through the window's cache, for which the framebuffer stays as its owner has made it.
  if (this->DrawBuffers.size() > 1)
  {
    glDrawBuffers(1, this->DrawBuffers.data());
  }

  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    vtkInformation* keys = prop->GetPropertyKeys();
    std::vector<vtkObjectBase*> hooks;
    for (int k = 0; keys && k < keys->Length(vtkOpenGLRenderPass::RenderPasses()); ++k)
    {
      hooks.push_back(keys->Get(vtkOpenGLRenderPass::RenderPasses(), k));
    }
    if (std::any_of(hooks.begin(), hooks.end(), DrawsToOthers))
    {
      this->Hooks.emplace_back(prop, hooks);
      hooks.erase(std::remove_if(hooks.begin(), hooks.end(), DrawsToOthers), hooks.end());
      SetHooks(keys, hooks);
    }
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyFirstAttachment::~vtkTranslucencyFirstAttachment()
{
  for (const auto& [prop, hooks] : this->Hooks)
  {
    SetHooks(prop->GetPropertyKeys(), hooks);
  }
  if (this->DrawBuffers.size() > 1)
  {
    glDrawBuffers(static_cast<GLsizei>(this->DrawBuffers.size()), this->DrawBuffers.data());
  }
}
VTK_ABI_NAMESPACE_END
