// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Programs that use VTK and can't be changed.
 */
#ifndef Program_h
#define Program_h

#include "Techniques/Techniques.h"

#include <string>
#include <vector>

/// Becomes the program, with the drop-in preloaded (Plugins/DropIn). Always: whether or not it asks for depth peeling.
/// Returns only by throwing Failure, if there is no such program.
[[noreturn]] void RunProgram(const TechniqueChoice& technique, bool always, const std::vector<std::string>& program);

#endif
