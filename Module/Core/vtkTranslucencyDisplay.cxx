// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyDisplay.h"

#include "vtkTranslucencyVTKVersion.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

#include "vtksys/DynamicLoader.hxx"

#include <chrono>
#include <cstdlib>
#include <set>
#include <thread>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTranslucencyDisplay);

namespace
{
using vtksys::DynamicLoader;

/// A function of Xlib, which is loaded like this wherever VTK opens windows of X: this module does not depend on it.
/// Null if there is none.
template <typename Function>
Function* FindInXlib(const char* name)
{
  static const DynamicLoader::LibraryHandle library = DynamicLoader::OpenLibrary("libX11.so.6");
  return library ? reinterpret_cast<Function*>(DynamicLoader::GetSymbolAddress(library, name)) : nullptr;
}

/// What DISPLAY names, empty if nothing.
std::string DisplayName()
{
  const char* name = std::getenv("DISPLAY");
  return name && *name ? "display '" + std::string(name) + "'" : "";
}

/// The display that DISPLAY names, null if it can't be opened. The connection is kept: Xvfb starts afresh when its last
/// client leaves, and refuses VTK's windows while it does so. For the same reason one refusal means little where a
/// display is named.
void* OpenDisplay()
{
  static void* display = nullptr;
  auto* open = FindInXlib<void*(const char*)>("XOpenDisplay");
  const int attempts = DisplayName().empty() ? 1 : 10;
  const auto pause = std::chrono::milliseconds(100);
  for (int attempt = 0; open && !display && attempt < attempts; ++attempt)
  {
    if (attempt > 0)
    {
      std::this_thread::sleep_for(pause);
    }
    display = open(nullptr);
  }
  return display;
}

std::string NoDisplay()
{
  return DisplayName().empty() ? "there is no X display (DISPLAY is not set)" : DisplayName() + " can't be opened";
}

/// What windows of X lack.
std::string MissingOfX()
{
  void* display = OpenDisplay();
  if (!display)
  {
    return NoDisplay() + ", expected one, or the program xvfb-run (Debian: apt-get install xvfb xauth) to draw without";
  }
  auto* query = FindInXlib<int(void*, const char*, int*, int*, int*)>("XQueryExtension");
  int numbers[3];
  return query && query(display, "GLX", numbers, numbers + 1, numbers + 2)
    ? ""
    : DisplayName() + " has no OpenGL (GLX), expected one that has; the program xvfb-run starts one";
}

bool HasOSMesa()
{
  for (const char* name : { "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" }) // those that VTK looks for
  {
    if (DynamicLoader::OpenLibrary(name))
    {
      return true;
    }
  }
  return false;
}

/// What it is that has no OpenGL 3.2.
std::string DriverOf(vtkRenderWindow* window)
{
  return window->IsA("vtkXOpenGLRenderWindow") ? DisplayName() : window->IsA("vtkEGLRenderWindow") ? "EGL" : "OSMesa";
}

/// Asks VTK, which opens such a window and compiles a shader in it. What it prints of what it does not find is said
/// here.
bool SupportsOpenGL(vtkRenderWindow* window)
{
  const int displayed = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  const bool supported = window->SupportsOpenGL() != 0;
  vtkObject::SetGlobalWarningDisplay(displayed);
  return supported;
}
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyDisplay::GetMissing(vtkRenderWindow* window)
{
  if (!window)
  {
    return "the window is null, expected a vtkRenderWindow";
  }
  const bool x = window->IsA("vtkXOpenGLRenderWindow");
  const bool osmesa = window->IsA("vtkOSOpenGLRenderWindow");
  if (!(x || osmesa || window->IsA("vtkEGLRenderWindow")) || !window->GetNeverRendered())
  {
    return "";
  }
  const std::string missing = x ? MissingOfX() : "";
  if (!missing.empty())
  {
    return missing;
  }
  if (osmesa && !HasOSMesa()) // the last that VTK tries
  {
    return NoDisplay() +
      ", and VTK found neither EGL nor OSMesa with OpenGL 3.2 to draw without: expected one of the three " +
      "(Debian: apt-get install libegl1 libgl1-mesa-dri)";
  }
  static std::set<std::string> supported;
  if (supported.count(window->GetClassName()) || SupportsOpenGL(window))
  {
    supported.insert(window->GetClassName());
    return "";
  }
  return DriverOf(window) +
    " has no OpenGL 3.2, which VTK draws with: expected a driver that has; Mesa's draws without a " +
    "graphics card, too (Debian: apt-get install libgl1-mesa-dri)";
}
VTK_ABI_NAMESPACE_END
