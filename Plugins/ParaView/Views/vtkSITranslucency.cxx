// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSITranslucency.h"

#include "vtkPVTranslucency.h"

#include "vtkObjectFactory.h"
#include "vtkProcessModule.h"
#include "vtkSMMessage.h"
#include "vtkSMSessionClient.h"

vtkStandardNewMacro(vtkSITranslucency);

//------------------------------------------------------------------------------
void vtkSITranslucency::Pull(vtkSMMessage* message)
{
  auto* session = vtkSMSessionClient::SafeDownCast(vtkProcessModule::GetProcessModule()->GetActiveSession());
  auto* translucency = vtkPVTranslucency::SafeDownCast(this->GetVTKObject());
  if (session && translucency && translucency->IsDrawnByServer())
  {
    message->set_location(vtkPVSession::RENDER_SERVER_ROOT);
    session->PullState(message);
    return;
  }
  this->Superclass::Pull(message);
}
