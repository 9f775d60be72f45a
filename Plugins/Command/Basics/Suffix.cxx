// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Suffix.h"

#include <algorithm>
#include <cctype>

//------------------------------------------------------------------------------
std::string SuffixOf(const std::filesystem::path& file)
{
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
    [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
  return suffix;
}
