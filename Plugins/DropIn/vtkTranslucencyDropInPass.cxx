// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyDropInPass.h"

#include "vtkTranslucencyFactory.h"
#include "vtkTranslucencyPass.h"

#include "vtkObjectFactory.h"
#include "vtkRenderState.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

#include <dlfcn.h>

vtkStandardNewMacro(vtkTranslucencyDropInPass);

//------------------------------------------------------------------------------
void vtkTranslucencyDropInPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique:\n";
  this->Technique->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkTranslucencyDropInPass::Render(const vtkRenderState* state)
{
  auto* own = vtkTranslucencyPass::SafeDownCast(this->Technique);
  auto* peeling = vtkDepthPeelingPass::SafeDownCast(this->Technique);
  auto* dual = vtkDualDepthPeelingPass::SafeDownCast(this->Technique);
  if (own)
  {
    own->SetTranslucentPass(this->TranslucentPass);
    own->SetVolumetricPass(this->VolumetricPass);
  }
  if (peeling)
  {
    peeling->SetTranslucentPass(this->TranslucentPass);
  }
  if (dual)
  {
    dual->SetVolumetricPass(this->VolumetricPass);
  }
  this->Technique->Render(state);
  this->NumberOfRenderedProps = this->Technique->GetNumberOfRenderedProps();
  if (this->VolumetricPass && !own && !dual) // techniques that know no volumes; the renderer leaves them to this pass
  {
    this->VolumetricPass->Render(state);
    this->NumberOfRenderedProps += this->VolumetricPass->GetNumberOfRenderedProps();
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyDropInPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Technique->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
// What Preload.cxx looks up. TRANSLUCENCY_TECHNIQUE is {"technique": NAME, "options": {KEYWORD: TEXT, ...}}, which
// `translucency run` has checked.
extern "C" __attribute__((visibility("default"))) void* vtkTranslucencyDropInNew()
{
  const char* text = std::getenv("TRANSLUCENCY_TECHNIQUE");
  const auto wanted = nlohmann::json::parse(text ? text : R"({"technique": "adaptive", "options": {}})");
  const auto technique = vtkSmartPointer<vtkRenderPass>::Take(
    vtkTranslucencyFactory::CreateTechnique(wanted["technique"].get<std::string>()));
  if (auto* own = vtkTranslucencyPass::SafeDownCast(technique))
  {
    for (const auto& option : wanted["options"].items())
    {
      own->SetOption(option.key(), option.value().get<std::string>());
    }
  }
  auto* pass = vtkTranslucencyDropInPass::New();
  pass->SetTechnique(technique);
  return pass;
}

//------------------------------------------------------------------------------
// The file of the library that the techniques are in.
extern "C" __attribute__((visibility("default"))) const char* vtkTranslucencyDropInModule()
{
  static Dl_info info;
  dladdr(reinterpret_cast<const void*>(&vtkTranslucencyFactory::New), &info);
  return info.dli_fname;
}
