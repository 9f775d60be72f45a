// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTranslucencyNotice.h"

#include "vtkCallbackCommand.h"
#include "vtkCollection.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMProperty.h"
#include "vtkSMProxyManager.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <string>

namespace
{
const std::string Views = "views";

vtkSMProperty* GetTechnique(vtkSMProxy* view)
{
  return view->GetProperty("TranslucencyTechnique");
}

bool Lacks(vtkSMProxy* proxy)
{
  return vtkSMRenderViewProxy::SafeDownCast(proxy) && !GetTechnique(proxy);
}

vtkNew<vtkCallbackCommand> NewCommand(void (*callback)(vtkObject*, unsigned long, void*, void*))
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(callback);
  return command;
}

// The sub-proxy's, which has nothing else to read. Interactive frames don't wait for it: a server has to be asked.
void OnDrawn(vtkObject* view, unsigned long, void*, void* interactive)
{
  if (!*static_cast<int*>(interactive))
  {
    GetTechnique(vtkSMProxy::SafeDownCast(view))->GetParent()->UpdatePropertyInformation();
  }
}

void OnRegistered(vtkObject*, unsigned long, void*, void* data)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  if (registered->Type != vtkSMProxyManager::RegisteredProxyInformation::PROXY || registered->GroupName != Views)
  {
    return;
  }
  vtkSMProxy* view = registered->Proxy;
  if (Lacks(view))
  {
    vtkGenericWarningMacro(
      "the view " << registered->ProxyName
                  << " draws as ParaView does without the plugin Translucency, which its server "
                     "has not loaded: load it there, too (pvpython: LoadPlugin(path, remote=True); "
                     "paraview: Tools, Manage Plugins, Remote Plugins), and make a new view");
  }
  else if (GetTechnique(view))
  {
    view->AddObserver(vtkCommand::EndEvent, NewCommand(OnDrawn));
  }
}
}

//------------------------------------------------------------------------------
void vtkPVTranslucencyWatchViews()
{
  const auto type = vtkProcessModule::GetProcessType();
  if (type != vtkProcessModule::PROCESS_CLIENT && type != vtkProcessModule::PROCESS_BATCH)
  {
    return; // a server, which has no views of its own
  }
  vtkSMProxyManager* manager = vtkSMProxyManager::GetProxyManager();
  manager->AddObserver(vtkCommand::RegisterEvent, NewCommand(OnRegistered));

  vtkSMSessionProxyManager* proxies = manager->GetActiveSessionProxyManager();
  if (!proxies)
  {
    return;
  }
  vtkNew<vtkCollection> views;
  proxies->GetProxies(Views.c_str(), views);
  for (int i = 0; i < views->GetNumberOfItems(); ++i)
  {
    if (Lacks(vtkSMProxy::SafeDownCast(views->GetItemAsObject(i))))
    {
      vtkGenericWarningMacro(
        "views that were there before the plugin Translucency was loaded go on to draw as they did: "
        "make a new view, or have the plugin loaded when ParaView starts (paraview: Auto Load in "
        "Manage Plugins; everywhere: PV_PLUGIN_PATH)");
      return;
    }
  }
}
