// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a program, makes its VTK say that it is of the release that PRETENDED_VTK_VERSION names.
#include <cstdlib>

extern "C" __attribute__((visibility("default"))) const char* GetVTKVersion()
{
  const char* version = std::getenv("PRETENDED_VTK_VERSION");
  return version ? version : "";
}
