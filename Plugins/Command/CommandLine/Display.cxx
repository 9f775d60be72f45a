// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Basics/Failure.h"

#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucencyDisplay.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <unistd.h>

namespace
{
// Set in the process that xvfb-run starts, so that a display that fails there too does not start a third: to what is
// missing without.
const char* const Mark = "TRANSLUCENCY_UNDER_XVFB";

// By which VTK is told, from 9.4 on, which window to make.
const char* const Choice = "VTK_DEFAULT_OPENGL_WINDOW";

// Without a choice VTK tries X, EGL and OSMesa, each time that it makes a window, and prints what it does not find. So
// the first one is made in silence, and those that follow like it.
vtkSmartPointer<vtkRenderWindow> ChooseWindow()
{
  if (std::getenv(Choice))
  {
    return vtkSmartPointer<vtkRenderWindow>::New();
  }
  vtkObject::GlobalWarningDisplayOff();
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkObject::GlobalWarningDisplayOn();
  setenv(Choice, window->GetClassName(), 1);
  return window;
}

// Comes back only if there is no such program.
void StartUnderXvfb(const std::string& missing, char** arguments)
{
  setenv(Mark, missing.c_str(), 1);
  unsetenv(Choice);
  const std::string wrapper = "xvfb-run";
  const std::string automatic = "-a"; // take a free display number
  std::vector<char> self(4096, '\0');
  if (readlink("/proc/self/exe", self.data(), self.size() - 1) <= 0)
  {
    return;
  }
  std::vector<char*> command{ const_cast<char*>(wrapper.c_str()), const_cast<char*>(automatic.c_str()), self.data() };
  for (char** argument = arguments + 1; *argument; ++argument)
  {
    command.push_back(*argument);
  }
  command.push_back(nullptr);
  execvp(command[0], command.data());
}
}

//------------------------------------------------------------------------------
void EnsureDisplay(char** arguments)
{
  const std::string missing = vtkTranslucencyDisplay::GetMissing(ChooseWindow());
  if (missing.empty())
  {
    return;
  }
  if (const char* without = std::getenv(Mark))
  {
    throw Failure(without);
  }
  StartUnderXvfb(missing, arguments);
  throw Failure(missing);
}
