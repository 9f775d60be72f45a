// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Basics/Failure.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <X11/Xlib.h>
#include <unistd.h>

namespace
{
// Set in the process that xvfb-run starts, so that a display that fails there too does not start a third.
const char* const Mark = "TRANSLUCENCY_UNDER_XVFB";

// The connection is kept: Xvfb starts afresh when its last client leaves, and refuses VTK's windows while it does so.
// For the same reason one refusal means little where a display is named.
bool DisplayOpens()
{
  const int attempts = std::getenv("DISPLAY") ? 10 : 1;
  const auto pause = std::chrono::milliseconds(100);
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    if (attempt > 0)
    {
      std::this_thread::sleep_for(pause);
    }
    if (XOpenDisplay(nullptr))
    {
      return true;
    }
  }
  return false;
}

std::string DisplayName()
{
  const char* name = std::getenv("DISPLAY");
  return name ? "display '" + std::string(name) + "' can't be opened" : "there is no X display (DISPLAY is not set)";
}
}

//------------------------------------------------------------------------------
void EnsureDisplay(char** arguments)
{
  vtkNew<vtkRenderWindow> window;
  if (!window->IsA("vtkXOpenGLRenderWindow") || DisplayOpens())
  {
    return;
  }
  if (!std::getenv(Mark))
  {
    setenv(Mark, "1", 1);
    const std::string wrapper = "xvfb-run";
    const std::string automatic = "-a"; // take a free display number
    std::vector<char> self(4096, '\0');
    if (readlink("/proc/self/exe", self.data(), self.size() - 1) > 0)
    {
      std::vector<char*> command{ const_cast<char*>(wrapper.c_str()), const_cast<char*>(automatic.c_str()),
        self.data() };
      for (char** argument = arguments + 1; *argument; ++argument)
      {
        command.push_back(*argument);
      }
      command.push_back(nullptr);
      execvp(command[0], command.data()); // returns only if it failed
    }
  }
  throw Failure(
    DisplayName() + ", expected one, or the program xvfb-run (Debian: apt-get install xvfb xauth) to draw without");
}
