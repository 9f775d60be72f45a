// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL's state as OpenGL itself tells it, to compare before and after something was drawn.
 */
#ifndef GLState_h
#define GLState_h

#include <map>
#include <string>
#include <vector>

class vtkRenderWindow;

using GLState = std::map<std::string, std::vector<double>>;

/// The state of the context that is current.
GLState QueryGLState();

/// The errors that the context that is current has kept, and forgets now.
std::vector<std::string> TakeGLErrors();

/// Whether zink draws: for what it can't do (Documentation/Drivers.md).
bool IsZink();

/// Whether the driver crashes in VTK's effect of this name in that window (Documentation/Drivers.md). May draw in it,
/// to have a context.
bool CrashesIn(const std::string& effect, vtkRenderWindow* window);

#endif
