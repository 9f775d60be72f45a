// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The suffix of a file's name, which says what is in the file.
 */
#ifndef Suffix_h
#define Suffix_h

#include <filesystem>
#include <string>

/// With its dot and in lower case: ".png" of a.PNG.
std::string SuffixOf(const std::filesystem::path& file);

#endif
