// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTranslucencyNotice.h"

#include "vtkCallbackCommand.h"
#include "vtkCollection.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMProxyManager.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <string>

namespace
{
const std::string Views = "views";

bool Lacks(vtkSMProxy* proxy)
{
  return vtkSMRenderViewProxy::SafeDownCast(proxy) && !proxy->GetProperty("TranslucencyTechnique");
}

void OnRegistered(vtkObject*, unsigned long, void*, void* data)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  if (registered->Type == vtkSMProxyManager::RegisteredProxyInformation::PROXY && registered->GroupName == Views &&
    Lacks(registered->Proxy))
  {
    vtkGenericWarningMacro("the view " << registered->ProxyName
                                       << " draws as ParaView does without the plugin Translucency, which its server "
                                          "has not loaded: load it there, too (pvpython: LoadPlugin(path, remote=True); "
                                          "paraview: Tools, Manage Plugins, Remote Plugins), and make a new view");
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
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnRegistered);
  manager->AddObserver(vtkCommand::RegisterEvent, command);

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
      vtkGenericWarningMacro("views that were there before the plugin Translucency was loaded go on to draw as they did: "
                             "make a new view, or have the plugin loaded when ParaView starts (paraview: Auto Load in "
                             "Manage Plugins; everywhere: PV_PLUGIN_PATH)");
      return;
    }
  }
}
