// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * JSON files that follow a schema.
 */
#ifndef JsonFile_h
#define JsonFile_h

#include <nlohmann/json.hpp>

#include <string>

/// Reads a file and holds it against a schema, given as text; what is "a scene file" or the like. Throws Failure that
/// names the place in the file, what stands there, and what was expected: the schema's description of it.
nlohmann::json ReadJson(const std::string& file, const char* schema, const std::string& what);

#endif
