// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Completion.h"

#include <CLI/CLI.hpp>

#include <sstream>

namespace
{
// "command word" is looked up: first what the last word asks for, then what may stand anywhere. Of a list, A,B,..., the
// last is completed. Behind -- another command begins, with a completion of its own.
const char* const Begin = R"(# Completion of translucency for bash; written by 'translucency completion'.
_translucency()
{
  local cur prev words cword split i values= files=
  _init_completion -s -n : || return
  for ((i = 2; i < COMP_CWORD; i++)); do
    if [[ ${COMP_WORDS[i]} == -- ]]; then
      _command_offset $((i + 1))
      return
    fi
  done
  if [[ $cword -eq 1 ]]; then
    prev= words[1]=
  fi
  case "${words[1]} $prev" in
)";
const char* const Middle = R"(    *)
      case "${words[1]} $cur" in
)";
const char* const End = R"(      esac
      ;;
  esac
  if [[ -n $files ]]; then
    _filedir
  fi
  local list=
  if [[ $cur == *,* ]]; then
    list=${cur%,*},
  fi
  COMPREPLY+=($(compgen -P "$list" -W "$values" -- "${cur##*,}"))
  __ltrim_colon_completions "$cur"
} &&
  complete -F _translucency translucency
)";

// What a branch of the script does: all words are the command's own, without a blank or a quote.
std::string Assignments(const OptionValues& values)
{
  return "values='" + CLI::detail::join(values.Words, " ") + "'" + (values.Files ? " files=yes" : "");
}

// "--technique" of render: 'render --technique'
std::vector<std::string> Patterns(const CLI::App* command, const CLI::Option* option)
{
  std::vector<std::string> patterns;
  for (const std::string& name : option->get_lnames())
  {
    patterns.push_back("'" + command->get_name() + " --" + name + "'");
  }
  for (const std::string& name : option->get_snames())
  {
    patterns.push_back("'" + command->get_name() + " -" + name + "'");
  }
  return patterns;
}

std::vector<std::string> Flags(const CLI::App* command)
{
  std::vector<std::string> flags;
  for (const CLI::Option* option : command->get_options())
  {
    for (const std::string& name : option->get_lnames())
    {
      flags.push_back("--" + name);
    }
  }
  return flags;
}
}

//------------------------------------------------------------------------------
std::string CompletionText(const CLI::App& app, const ValuesOfOptions& values)
{
  const auto valuesOf = [&values](const CLI::Option* option)
  {
    const auto found = values.find(option);
    return found == values.end() ? OptionValues() : found->second;
  };
  const auto commands = app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
  std::vector<std::string> first = Flags(&app);
  std::map<std::string, std::vector<std::string>> asked; // patterns by what is done
  std::string anywhere;
  const auto addAnywhere = [&anywhere](const std::string& pattern, const OptionValues& offered)
  { anywhere += "        '" + pattern + "'*) " + Assignments(offered) + " ;;\n"; };
  for (const CLI::App* command : commands)
  {
    first.push_back(command->get_name());
    addAnywhere(command->get_name() + " -", { Flags(command) });
    for (const CLI::Option* option : command->get_options())
    {
      if (option->get_positional())
      {
        addAnywhere(command->get_name() + " ", valuesOf(option));
      }
      else if (option->get_type_size() > 0)
      {
        std::vector<std::string>& patterns = asked[Assignments(valuesOf(option))];
        const std::vector<std::string> more = Patterns(command, option);
        patterns.insert(patterns.end(), more.begin(), more.end());
      }
    }
  }
  addAnywhere(" ", { first });
  std::string behind;
  for (const auto& branch : asked)
  {
    behind += "    " + CLI::detail::join(branch.second, " | \\\n      ") + ")\n      " + branch.first + "\n      ;;\n";
  }
  return Begin + behind + Middle + anywhere + End;
}
