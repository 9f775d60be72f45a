// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Scene files: JSON, as scene.schema.json says.
 */
#ifndef SceneFile_h
#define SceneFile_h

#include "Inputs.h"
#include "Scene.h"

#include <string>
#include <vector>

struct SceneFile
{
  std::string Title; ///< empty if the file does not say
  Scene Setting;     ///< without parts
  std::vector<Input> Inputs;
};

/// Reads a scene file; throws Failure that names the place in it, what stands there and what was expected.
SceneFile ReadSceneFile(const std::string& file);

#endif
