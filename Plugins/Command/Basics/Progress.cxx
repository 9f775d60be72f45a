// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Failure.h"

#include <atomic>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace
{
std::atomic<bool> Interrupted{ false };

extern "C" void Interrupt(int)
{
  Interrupted = true;
}

bool OnTerminal()
{
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  return terminal;
}
}

//------------------------------------------------------------------------------
Progress::Progress(const std::string& what, int steps)
  : What(what)
  , Steps(steps)
{
}

//------------------------------------------------------------------------------
Progress::~Progress()
{
  Progress::Clear();
}

//------------------------------------------------------------------------------
void Progress::Step(const std::string& detail)
{
  if (Interrupted)
  {
    throw Failure("interrupted");
  }
  ++this->Done;
  if (!OnTerminal())
  {
    return;
  }
  std::ostringstream line;
  if (this->Steps > 0)
  {
    const int width = static_cast<int>(std::to_string(this->Steps).size());
    line << "[" << std::setw(width) << this->Done << "/" << this->Steps << "] ";
  }
  line << this->What << (detail.empty() ? "" : ": ") << detail;
  Progress::Clear();
  std::cerr << line.str().substr(0, 79) << std::flush;
}

//------------------------------------------------------------------------------
void Progress::Clear()
{
  if (OnTerminal())
  {
    std::cerr << "\r\033[K" << std::flush; // to the first column, and erase to the end of the line
  }
}

//------------------------------------------------------------------------------
void Progress::CatchSignals()
{
  std::signal(SIGINT, Interrupt);
  std::signal(SIGTERM, Interrupt);
}
