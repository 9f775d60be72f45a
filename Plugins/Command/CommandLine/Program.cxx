// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "Basics/Failure.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

// Beside the library, whichever place the installation was moved to.
std::string FindPreload()
{
  const fs::path file = (fs::read_symlink("/proc/self/exe").parent_path() / TRANSLUCENCY_PRELOAD).lexically_normal();
  if (!fs::exists(file))
  {
    throw Failure("'" + file.string() + "' is not there, expected the library that programs are run with");
  }
  if (file.string().find_first_of(" :") != std::string::npos)
  {
    throw Failure("'" + file.string() + "' can't be preloaded, expected a path without spaces and colons");
  }
  return file.string();
}
}

//------------------------------------------------------------------------------
void RunProgram(const TechniqueChoice& technique, const std::vector<std::string>& program)
{
  nlohmann::json wanted = { { "technique", technique.Name }, { "options", nlohmann::json::object() } };
  for (const auto& setting : technique.Settings)
  {
    wanted["options"][setting.first] = setting.second;
  }
  setenv("TRANSLUCENCY_TECHNIQUE", wanted.dump().c_str(), 1);
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
