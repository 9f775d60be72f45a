// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * translucency: draws, compares and times the techniques of this library from the command line.
 */
#include "Arguments.h"
#include "Basics/Failure.h"
#include "Basics/Messages.h"
#include "Basics/Progress.h"
#include "Commands.h"
#include "Display.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  Messages::Get();
  Progress::CatchSignals();
  try
  {
    const auto arguments = ParseArguments(argc, argv);
    if (!arguments)
    {
      return EXIT_SUCCESS;
    }
    if (arguments->NeedsDisplay)
    {
      EnsureDisplay(argv);
    }
    RunCommand(*arguments);
    Messages::Get()->PrintWarnings();
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "translucency: error: " << OneLine(error.what()) << "\n";
    return EXIT_FAILURE;
  }
}
