// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "Basics/Failure.h"
#include "Basics/Libraries.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

namespace
{
std::string FindPreload()
{
  const std::string file = FindLibrary(TRANSLUCENCY_PRELOAD, "programs are run with");
  if (file.find_first_of(" :") != std::string::npos)
  {
    throw Failure("'" + file + "' can't be preloaded, expected a path without spaces and colons");
  }
  return file;
}
}

//------------------------------------------------------------------------------
void RunProgram(const TechniqueChoice& technique, bool always, const std::vector<std::string>& program)
{
  nlohmann::json wanted = { { "technique", technique.Name }, { "options", nlohmann::json::object() } };
  for (const auto& setting : technique.Settings)
  {
    wanted["options"][setting.first] = setting.second;
  }
  setenv("TRANSLUCENCY_TECHNIQUE", wanted.dump().c_str(), 1);
  always ? setenv("TRANSLUCENCY_ALWAYS", "1", 1) : unsetenv("TRANSLUCENCY_ALWAYS");
  const char* others = std::getenv("LD_PRELOAD");
  setenv("LD_PRELOAD", (FindPreload() + (others ? ":" + std::string(others) : "")).c_str(), 1);

  std::vector<char*> words;
  for (const std::string& word : program)
  {
    words.push_back(const_cast<char*>(word.c_str()));
  }
  words.push_back(nullptr);
  execvp(words[0], words.data()); // returns only if it failed
  throw Failure("'" + program[0] + "' can't be run: " + std::strerror(errno) + "; expected a program, behind --");
}
