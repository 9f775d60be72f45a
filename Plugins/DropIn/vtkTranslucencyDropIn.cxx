// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the preloaded library asks for: DropInFunctions.h. TRANSLUCENCY_TECHNIQUE is {"technique": NAME, "options":
 * {KEYWORD: TEXT, ...}}, which `translucency run` has checked.
 */
#include "DropInFunctions.h"
#include "vtkTranslucencyDrawing.h"
#include "vtkTranslucencyDropInPass.h"

#include "vtkTranslucencyFactory.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSSAOPass.h"
#include "vtkSmartPointer.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include <dlfcn.h>

namespace
{
vtkSmartPointer<vtkRenderPass> NewTechnique()
{
  const char* text = std::getenv("TRANSLUCENCY_TECHNIQUE");
  const auto wanted = nlohmann::json::parse(text ? text : R"({"technique": "adaptive", "options": {}})");
  auto technique = vtkSmartPointer<vtkRenderPass>::Take(
    vtkTranslucencyFactory::CreateTechnique(wanted["technique"].get<std::string>()));
  if (auto* own = vtkTranslucencyPass::SafeDownCast(technique))
  {
    for (const auto& option : wanted["options"].items())
    {
      own->SetOption(option.key(), option.value().get<std::string>());
    }
  }
  return technique;
}

void* NewPeeling()
{
  auto* pass = vtkTranslucencyDropInPass::New();
  pass->SetTechnique(NewTechnique());
  return pass;
}

// What a renderer peels by. Its setters would not do: what is modified in every frame is drawn again by those that look
// at its time.
struct Peeling : vtkRenderer
{
  static vtkTypeBool& Surfaces(vtkRenderer* renderer) { return renderer->*(&Peeling::UseDepthPeeling); }
  static bool& Volumes(vtkRenderer* renderer) { return renderer->*(&Peeling::UseDepthPeelingForVolumes); }

  // From the table of virtual functions, as all compilers on Linux lay it out (Itanium C++ ABI, 2.3): an object begins
  // with the table's address, and a pointer to a member with a place in it, whose lowest bit may be set.
  static const void* FindUpdateGeometry(vtkRenderer* renderer)
  {
    const auto member = &Peeling::UpdateGeometry;
    std::uintptr_t place;
    std::memcpy(&place, &member, sizeof(place));
    const char* table;
    std::memcpy(&table, static_cast<const void*>(renderer), sizeof(table));
    const void* function;
    std::memcpy(&function, table + (place & ~std::uintptr_t(1)), sizeof(function));
    return function;
  }
};

int UpdateGeometry(void* self, void* framebuffer, int (*own)(void*, void*))
{
  auto* renderer = static_cast<vtkRenderer*>(self);
  if (renderer->GetUseDepthPeeling())
  {
    return own(renderer, framebuffer);
  }
  Peeling::Surfaces(renderer) = 1;
  const bool volumes = std::exchange(Peeling::Volumes(renderer), true);
  const int drawn = own(renderer, framebuffer);
  Peeling::Surfaces(renderer) = 0;
  Peeling::Volumes(renderer) = volumes;
  return drawn;
}

// Whether a pass of the program has a say in the props' shaders, as VTK's weighted average has, and F3D's stochastic
// transparency: then the props are drawn for it, and what comes out is its translucency. vtkSSAOPass is there for
// opaque surfaces.
bool IsDrawnForAnother(const vtkRenderState* state)
{
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkInformation* keys = vtkTranslucencyProp(state, i)->GetPropertyKeys();
    for (int k = 0; keys && k < keys->Length(vtkOpenGLRenderPass::RenderPasses()); ++k)
    {
      if (!vtkSSAOPass::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), k)))
      {
        return true;
      }
    }
  }
  return false;
}

// The technique that draws in the renderer's passes; it goes with the renderer.
vtkRenderPass* GetTechnique(vtkRenderer* renderer)
{
  static auto* const key = vtkInformationObjectBaseKey::MakeKey("TECHNIQUE", "vtkTranslucencyDropIn");
  vtkInformation* information = renderer->GetInformation();
  if (!information->Has(key))
  {
    information->Set(key, NewTechnique());
  }
  return vtkRenderPass::SafeDownCast(information->Get(key));
}

bool RenderTranslucent(const void* data)
{
  const auto* state = static_cast<const vtkRenderState*>(data);
  if (vtkTranslucencyDrawing::IsOn() || IsDrawnForAnother(state))
  {
    return false;
  }
  const vtkTranslucencyDrawing drawing;
  GetTechnique(state->GetRenderer())->Render(state);
  return true;
}

const void* GetUpdateGeometry()
{
  const vtkNew<vtkRenderer> renderer;
  return Peeling::FindUpdateGeometry(renderer);
}

// The file of the library that the techniques are in.
const char* GetModuleFile()
{
  static Dl_info info;
  dladdr(reinterpret_cast<const void*>(&vtkTranslucencyFactory::New), &info);
  return info.dli_fname;
}
}

//------------------------------------------------------------------------------
extern "C" __attribute__((visibility("default"))) const DropInFunctions* vtkTranslucencyDropInFunctions()
{
  static const DropInFunctions functions{ TRANSLUCENCY_RELEASE, GetModuleFile(), NewPeeling, UpdateGeometry,
    RenderTranslucent, GetUpdateGeometry };
  return &functions;
}
