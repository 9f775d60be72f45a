// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Completion in the shell, from what the command line declares.
 */
#ifndef Completion_h
#define Completion_h

#include <map>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}

/// What may stand for an option's value: of what has no such entry nothing is known, as of a number.
struct OptionValues
{
  std::vector<std::string> Words;
  bool Files = false;
};

using ValuesOfOptions = std::map<const CLI::Option*, OptionValues>;

/// A script for bash and its package bash-completion.
std::string CompletionText(const CLI::App& app, const ValuesOfOptions& values);

#endif
