// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
// Stands for a drop-in that was built for another release of VTK: VTK's passes draw, and it says that it was asked.
#include "DropInFunctions.h"

#include "vtkDualDepthPeelingPass.h"

#include <cstdio>

#include <dlfcn.h>

namespace
{
void* NewPeeling()
{
  void* pass = vtkDualDepthPeelingPass::New(); // VTK's, since ModuleFile calls for it
  std::fputs("the pretended drop-in draws\n", stderr);
  return pass;
}

int UpdateGeometry(void* renderer, void* framebuffer, int (*own)(void*, void*))
{
  return own(renderer, framebuffer);
}

bool RenderTranslucent(const void*)
{
  return false;
}

// As with a VTK whose renderers don't call by way of the loader.
const void* GetUpdateGeometry()
{
  return reinterpret_cast<const void*>(&UpdateGeometry);
}
}

//------------------------------------------------------------------------------
extern "C" __attribute__((visibility("default"))) const DropInFunctions* vtkTranslucencyDropInFunctions()
{
  static Dl_info here;
  dladdr(reinterpret_cast<const void*>(&NewPeeling), &here);
  static const DropInFunctions functions{ TRANSLUCENCY_RELEASE, here.dli_fname, NewPeeling, UpdateGeometry,
    RenderTranslucent, GetUpdateGeometry };
  return &functions;
}
