// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReadGuard.h"

#include "Basics/Failure.h"
#include "Basics/Messages.h"

#include <cstdio>
#include <cstdlib>
#include <iostream>

#include <csignal>
#include <unistd.h>

namespace
{
const int Signals[] = { SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL };

// What the handlers need; they may call nothing that allocates.
bool Guarding = false;
int TrueStderr = -1;
std::string LastWords;

void SayLastWords()
{
  if (Guarding && write(TrueStderr, LastWords.data(), LastWords.size()) < 0)
  {
    return; // nowhere left to say it
  }
}

extern "C" void OnCrash(int)
{
  SayLastWords();
  _exit(EXIT_FAILURE);
}

// A reader that calls exit() may ask for success.
void OnExit()
{
  if (Guarding)
  {
    SayLastWords();
    _exit(EXIT_FAILURE);
  }
}

// stderr goes to a file without a name from here on; null if there can be none.
FILE* Capture()
{
  FILE* file = std::tmpfile();
  if (file)
  {
    std::cerr.flush();
    dup2(fileno(file), STDERR_FILENO);
  }
  return file;
}

FILE* Captured = nullptr;
}

//------------------------------------------------------------------------------
ReadGuard::ReadGuard(const std::string& what, bool strict)
  : What(what)
{
  static const int registered = std::atexit(OnExit);
  static_cast<void>(registered);
  LastWords = "translucency: error: " + OneLine(what) + ": the reader gave up on it\n";
  TrueStderr = dup(STDERR_FILENO);
  Captured = Capture();
  for (const int number : Signals)
  {
    std::signal(number, OnCrash);
  }
  Messages::Get()->SetStrict(strict);
  Guarding = true;
}

//------------------------------------------------------------------------------
ReadGuard::~ReadGuard()
{
  Guarding = false;
  Messages::Get()->SetStrict(false);
  for (const int number : Signals)
  {
    std::signal(number, SIG_DFL);
  }
  std::cerr.flush();
  dup2(TrueStderr, STDERR_FILENO);
  close(TrueStderr);
  if (Captured)
  {
    std::fclose(Captured);
    Captured = nullptr;
  }
}

//------------------------------------------------------------------------------
void ReadGuard::Finish()
{
  Messages::Get()->ThrowError(this->What);
  std::cerr.flush();
  char text[512] = "";
  if (Captured)
  {
    std::rewind(Captured);
    const std::size_t length = std::fread(text, 1, sizeof(text) - 1, Captured);
    text[length] = '\0';
  }
  const std::string complaint = Quotable(text);
  if (!complaint.empty())
  {
    throw Failure(this->What + ": " + complaint);
  }
}
