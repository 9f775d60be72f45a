// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyChain.h"

#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyRenderStepsPass.h"

#include "vtkCameraPass.h"
#include "vtkCommand.h"
#include "vtkDefaultPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTranslucencyChain);
vtkInformationKeyMacro(vtkTranslucencyChain, CHAIN, ObjectBase);

namespace
{
bool DrawsTranslucentProps(vtkRenderPass* pass)
{
  return vtkTranslucentPass::SafeDownCast(pass) || vtkDepthPeelingPass::SafeDownCast(pass) ||
    vtkOrderIndependentTranslucentPass::SafeDownCast(pass) || vtkTranslucencyPass::SafeDownCast(pass);
}

vtkSmartPointer<vtkRenderPass> NewSequence(const std::vector<vtkRenderPass*>& passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (vtkRenderPass* pass : passes)
  {
    collection->AddItem(pass);
  }
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(collection);
  return sequence;
}

// The passes by which a pass draws, as far as they may draw what is translucent.
std::vector<vtkRenderPass*> GetChildren(vtkRenderPass* pass)
{
  std::vector<vtkRenderPass*> children;
  if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    children = { image->GetDelegatePass() };
  }
  else if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    children = { camera->GetDelegatePass() };
  }
  else if (auto* supersampling = vtkSSAAPass::SafeDownCast(pass))
  {
    children = { supersampling->GetDelegatePass() };
  }
  else if (auto* shadows = vtkShadowMapPass::SafeDownCast(pass))
  {
    children = { shadows->GetOpaqueSequence() };
  }
  else if (auto* steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    children = { steps->GetTranslucentPass() };
  }
  else if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    for (int i = 0; passes && i < passes->GetNumberOfItems(); ++i)
    {
      children.push_back(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)));
    }
  }
  children.erase(std::remove(children.begin(), children.end(), nullptr), children.end());
  return children;
}

// A pass and all below it.
void AddTree(vtkRenderPass* pass, std::vector<vtkRenderPass*>& tree)
{
  tree.push_back(pass);
  for (vtkRenderPass* child : GetChildren(pass))
  {
    AddTree(child, tree);
  }
}

std::vector<vtkRenderPass*> GetTree(vtkRenderPass* root)
{
  std::vector<vtkRenderPass*> tree;
  AddTree(root, tree);
  return tree;
}

bool DrawsWithOtherProcesses(vtkRenderPass* root)
{
  const std::vector<vtkRenderPass*> tree = GetTree(root);
  return std::any_of(tree.begin(), tree.end(), [](vtkRenderPass* pass) { return pass->IsA("vtkIceTCompositePass"); });
}

std::string GetNames(vtkRenderPass* root)
{
  std::string names;
  for (vtkRenderPass* pass : GetTree(root))
  {
    names += (names.empty() ? "" : ", ") + std::string(pass->GetClassName());
  }
  return names;
}
}

//------------------------------------------------------------------------------
vtkTranslucencyChain* vtkTranslucencyChain::Find(vtkRenderer* renderer)
{
  return vtkTranslucencyChain::SafeDownCast(renderer->GetInformation()->Get(CHAIN()));
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkTranslucencyChain::GetTechnique(vtkRenderer* renderer)
{
  const vtkTranslucencyChain* chain = Find(renderer);
  return chain ? chain->Technique : nullptr;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyChain::Enable(vtkRenderer* renderer, vtkRenderPass* technique)
{
  if (renderer->GetPass() && DrawsWithOtherProcesses(renderer->GetPass()))
  {
    vtkErrorWithObjectMacro(renderer,
      << "the renderer's pass (" << GetNames(renderer->GetPass())
      << ") draws together with those of other processes of "
      << "ParaView, which need the same technique, so it is left as it was: load the plugin Translucency and set "
      << "TranslucencyTechnique of the view");
    return false;
  }
  vtkSmartPointer<vtkTranslucencyChain> chain = Find(renderer);
  if (!chain)
  {
    chain = vtkSmartPointer<vtkTranslucencyChain>::New();
    chain->Renderer = renderer;
    // After the observers of toolkits that give the renderer other passes there.
    constexpr float priority = -1;
    chain->Observer =
      renderer->AddObserver(vtkCommand::StartEvent, chain.Get(), &vtkTranslucencyChain::Update, priority);
    renderer->GetInformation()->Set(CHAIN(), chain);
  }
  chain->TakeOut();
  if (chain->Technique && chain->Technique != technique)
  {
    chain->Release(chain->Technique);
  }
  chain->Technique = technique;
  chain->PutIn(true);
  return true;
}

//------------------------------------------------------------------------------
void vtkTranslucencyChain::Disable(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkTranslucencyChain> chain = Find(renderer);
  if (!chain)
  {
    return;
  }
  chain->TakeOut();
  chain->Release(chain->Technique);
  chain->Release(chain->Steps);
  chain->Release(chain->StepsBelow);
  renderer->RemoveObserver(chain->Observer);
  renderer->GetInformation()->Remove(CHAIN());
}

//------------------------------------------------------------------------------
void vtkTranslucencyChain::Update()
{
  vtkRenderPass* pass = this->Renderer->GetPass();
  if (!pass || GetTree(pass) != this->Tree)
  {
    this->TakeOut();
    this->PutIn(false);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyChain::PutIn(bool replaces)
{
  const auto useOwnSteps = [this]
  {
    if (!this->Steps)
    {
      this->Steps = vtkSmartPointer<vtkTranslucencyRenderStepsPass>::New();
    }
    this->Exchange(nullptr, this->Renderer->GetPass(), this->Steps);
  };
  if (!this->Renderer->GetPass() || DrawsTranslucentProps(this->Renderer->GetPass()))
  {
    useOwnSteps();
  }
  const vtkSmartPointer<vtkRenderPass> root = this->Renderer->GetPass();
  if (!this->PutInto(nullptr, root, false) && !this->PutIntoShadows(root) && !this->PutIntoEmptySteps(root))
  {
    vtkWarningWithObjectMacro(this->Renderer,
      << "there is no place for translucent props that is known in the renderer's pass (" << GetNames(root) << "): "
      << (replaces ? "it is replaced, and what it does is not drawn"
                   : "they are drawn by it instead of by the technique that was enabled"));
    if (replaces)
    {
      useOwnSteps();
      this->PutInto(nullptr, this->Steps, false);
    }
  }
  this->Tree = GetTree(this->Renderer->GetPass());
}

//------------------------------------------------------------------------------
// Whether the technique draws there. Where shadows follow, what is opaque is drawn after it, and over it.
bool vtkTranslucencyChain::PutInto(vtkRenderPass* owner, vtkRenderPass* pass, bool shadowsFollow)
{
  const vtkSmartPointer<vtkRenderPass> technique = shadowsFollow ? NewSequence({}) : this->Technique;
  if (DrawsTranslucentProps(pass))
  {
    this->Exchange(owner, pass, technique);
    this->TakeVolumes(owner, technique);
    return !shadowsFollow;
  }
  if (std::string(pass->GetClassName()) == "vtkDefaultPass") // of which many are subclasses
  {
    const auto sequence =
      NewSequence({ vtkNew<vtkOpaquePass>(), technique, vtkNew<vtkVolumetricPass>(), vtkNew<vtkOverlayPass>() });
    this->Exchange(owner, pass, sequence);
    this->TakeVolumes(sequence, technique);
    return !shadowsFollow;
  }
  if (pass->IsA("vtkPVDefaultPass"))
  {
    if (!this->StepsBelow)
    {
      this->StepsBelow = vtkSmartPointer<vtkTranslucencyRenderStepsPass>::New();
      this->StepsBelow->SetCameraPass(nullptr);
    }
    this->StepsBelow->SetTranslucentPass(technique);
    this->Exchange(owner, pass, this->StepsBelow);
    this->TakeVolumes(this->StepsBelow, technique);
    return !shadowsFollow;
  }
  bool draws = false;
  const std::vector<vtkRenderPass*> children = GetChildren(pass);
  for (auto child = children.begin(); child != children.end(); ++child)
  {
    const bool shadows = std::any_of(child + 1, children.end(), vtkShadowMapPass::SafeDownCast);
    draws = this->PutInto(pass, *child, shadowsFollow || shadows) || draws;
  }
  return draws;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyChain::PutIntoShadows(vtkRenderPass* root)
{
  const std::vector<vtkRenderPass*> tree = GetTree(root);
  const auto last = std::find_if(tree.rbegin(), tree.rend(),
    [](vtkRenderPass* pass) { return vtkShadowMapPass::SafeDownCast(pass) && !GetChildren(pass).empty(); });
  if (last == tree.rend())
  {
    return false;
  }
  vtkRenderPass* opaque = GetChildren(*last).front();
  this->Exchange(*last, opaque, NewSequence({ opaque, this->Technique }));
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyChain::PutIntoEmptySteps(vtkRenderPass* root)
{
  for (vtkRenderPass* pass : GetTree(root))
  {
    auto* steps = vtkRenderStepsPass::SafeDownCast(pass);
    if (steps && !steps->GetTranslucentPass())
    {
      this->Exchange(steps, nullptr, this->Technique);
      this->TakeVolumes(steps, this->Technique);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Gives the technique the volumes that are drawn next, if it draws them among the surfaces.
void vtkTranslucencyChain::TakeVolumes(vtkRenderPass* owner, vtkRenderPass* before)
{
  auto* technique = vtkTranslucencyPass::SafeDownCast(this->Technique);
  if (!technique || this->TookVolumes)
  {
    return;
  }
  vtkSmartPointer<vtkRenderPass> volumes;
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(owner))
  {
    volumes = steps->GetVolumetricPass();
  }
  else
  {
    const std::vector<vtkRenderPass*> children = GetChildren(owner);
    const auto found = std::find_if(
      std::find(children.begin(), children.end(), before), children.end(), vtkVolumetricPass::SafeDownCast);
    volumes = found == children.end() ? nullptr : *found;
  }
  if (volumes)
  {
    this->TookVolumes = true;
    this->Exchange(owner, volumes, NewSequence({}));
    technique->SetVolumetricPass(volumes);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyChain::Exchange(vtkRenderPass* owner, vtkRenderPass* from, vtkRenderPass* to)
{
  const Edit edit{ owner, from, to };
  if (this->Replace(edit.Owner, edit.From, edit.To))
  {
    this->Edits.push_back(edit);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyChain::TakeOut()
{
  for (auto edit = this->Edits.rbegin(); edit != this->Edits.rend(); ++edit)
  {
    this->Replace(edit->Owner, edit->To, edit->From);
  }
  this->Edits.clear();
  auto* technique = vtkTranslucencyPass::SafeDownCast(this->Technique);
  if (technique && this->TookVolumes)
  {
    technique->SetVolumetricPass(nullptr);
  }
  this->TookVolumes = false;
}

//------------------------------------------------------------------------------
// False where there is something else by now.
bool vtkTranslucencyChain::Replace(vtkRenderPass* owner, vtkRenderPass* from, vtkRenderPass* to)
{
  if (!owner)
  {
    const bool found = this->Renderer->GetPass() == from;
    if (found)
    {
      this->Renderer->SetPass(to);
    }
    return found;
  }
  if (auto* sequence = vtkSequencePass::SafeDownCast(owner))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    for (int i = passes ? passes->GetNumberOfItems() - 1 : -1; i >= 0; --i)
    {
      if (passes->GetItemAsObject(i) == from)
      {
        passes->ReplaceItem(i, to);
        return true;
      }
    }
    return false;
  }
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(owner))
  {
    if (steps->GetTranslucentPass() == from)
    {
      steps->SetTranslucentPass(to);
      return true;
    }
    if (steps->GetVolumetricPass() == from)
    {
      steps->SetVolumetricPass(to);
      return true;
    }
    return false;
  }
  const std::vector<vtkRenderPass*> children = GetChildren(owner);
  if (children.empty() || children.front() != from)
  {
    return false;
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(owner))
  {
    image->SetDelegatePass(to);
  }
  else if (auto* camera = vtkCameraPass::SafeDownCast(owner))
  {
    camera->SetDelegatePass(to);
  }
  else if (auto* supersampling = vtkSSAAPass::SafeDownCast(owner))
  {
    supersampling->SetDelegatePass(to);
  }
  else if (auto* shadows = vtkShadowMapPass::SafeDownCast(owner))
  {
    shadows->SetOpaqueSequence(to);
  }
  return true;
}

//------------------------------------------------------------------------------
// What a pass has made in the window's context, before it goes.
void vtkTranslucencyChain::Release(vtkRenderPass* pass)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  // Asked for its context before the first frame, a window that has no X display yet ends the process.
  if (pass && window && !window->GetNeverRendered() && window->GetGenericContext())
  {
    window->PushContext();
    pass->ReleaseGraphicsResources(window);
    window->PopContext();
  }
}
VTK_ABI_NAMESPACE_END
