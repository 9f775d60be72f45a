// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries.h"

#include "Failure.h"

#include <filesystem>

//------------------------------------------------------------------------------
std::string FindLibrary(const std::string& name, const std::string& purpose)
{
  namespace fs = std::filesystem;
  const fs::path file =
    (fs::read_symlink("/proc/self/exe").parent_path() / TRANSLUCENCY_LIBRARIES / name).lexically_normal();
  if (!fs::exists(file))
  {
    throw Failure("'" + file.string() + "' is not there, expected the library that " + purpose);
  }
  return file.string();
}
