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

/// Whether VTK's effect of this name fails in that window, whatever draws in it (Documentation/Drivers.md): the driver
/// crashes, or OpenGL has errors in a window like it that VTK alone draws in. May draw in it, to have a context.
bool VTKFailsIn(const std::string& effect, vtkRenderWindow* window);

#endif
