// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Scenes made by the command itself, for measuring and comparing: the same on every machine.
 */
#ifndef BuiltInScenes_h
#define BuiltInScenes_h

#include <string>
#include <vector>

struct Input;
struct Scene;

/// If the input names a built-in scene, appends its parts (and sets the view that it is meant for) and returns true.
/// Throws Failure if a name that begins with "scene:" is none, or one of its parameters is none.
bool AddBuiltInScene(const Input& input, Scene& scene);

std::vector<std::string> BuiltInSceneNames();

/// One line of help for each.
std::string BuiltInSceneHelp();

#endif
