// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Manual.h"

#include "Techniques/Techniques.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Apps = std::vector<const CLI::App*>;
using Options = std::vector<const CLI::Option*>;

// Text that roff takes for nothing but text.
std::string Plain(const std::string& text)
{
  static const std::map<char, std::string> special{ { '\\', "\\e" }, { '-', "\\-" }, { '\'', "\\(aq" },
    { '"', "\\(dq" }, { '`', "\\(ga" }, { '^', "\\(ha" }, { '~', "\\(ti" } };
  std::string plain = text.rfind('.', 0) == 0 ? "\\&" : "";
  for (const char c : text)
  {
    const auto found = special.find(c);
    plain += found == special.end() ? std::string(1, c) : found->second;
  }
  return plain;
}

std::string Upper(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

// What is indented in a footer are examples, which stay as they are; the rest is prose, without empty lines.
void WriteFooter(const std::string& footer, std::ostream& page)
{
  std::istringstream lines(footer);
  bool examples = false;
  page << ".PP\n";
  for (std::string line; std::getline(lines, line);)
  {
    const bool indented = line.rfind("  ", 0) == 0;
    if (indented != examples)
    {
      page << (indented ? ".PP\n.RS 4\n.nf\n" : ".fi\n.RE\n.PP\n");
    }
    else if (!indented && line.back() == ':')
    {
      page << ".PP\n"; // a heading of what follows
    }
    examples = indented;
    page << Plain(indented ? line.substr(2) : line) << "\n";
  }
  page << (examples ? ".fi\n.RE\n" : "");
}

void WriteOption(const CLI::Option* option, std::ostream& page)
{
  const CLI::Formatter formatter;
  const bool positional = option->get_positional();
  page << ".TP\n\\fB" << Plain(formatter.make_option_name(option, positional)) << "\\fR"
       << Plain(formatter.make_option_opts(option)) << "\n"
       << Plain(formatter.make_option_desc(option)) << "\n";
}

Options OptionsOf(const CLI::App* command, const std::string& group)
{
  return command->get_options([&group](const CLI::Option* option)
    { return option->get_group() == group && option->nonpositional() && option->get_name() != "--help"; });
}

// Groups that aren't that of a command's own options: several commands have them, and they are told once.
std::vector<std::string> SharedGroups(const CLI::App* command)
{
  std::vector<std::string> groups = command->get_groups();
  const std::string own = command->get_help_ptr()->get_group();
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                 [&own](const std::string& group) { return group.empty() || group == own; }),
    groups.end());
  return groups;
}

std::string Usage(const CLI::App* command)
{
  std::string usage = command->get_name() + " [OPTIONS]";
  for (const CLI::Option* option : command->get_options([](const CLI::Option* o) { return o->get_positional(); }))
  {
    usage += " " + CLI::Formatter().make_option_usage(option);
  }
  return usage;
}

void WriteCommand(const CLI::App* command, const std::string& inherited, std::ostream& page)
{
  page << ".SS \"" << Plain(Usage(command)) << "\"\n" << Plain(command->get_description()) << "\n";
  for (const CLI::Option* option : command->get_options([](const CLI::Option* o) { return o->get_positional(); }))
  {
    WriteOption(option, page);
  }
  for (const CLI::Option* option : OptionsOf(command, command->get_help_ptr()->get_group()))
  {
    WriteOption(option, page);
  }
  std::string groups;
  for (const std::string& group : SharedGroups(command))
  {
    groups += (groups.empty() ? "" : ", ") + Upper(group);
  }
  if (!groups.empty())
  {
    page << ".PP\nIt also takes the options below " << Plain(groups) << ".\n";
  }
  if (command->get_footer() != inherited)
  {
    WriteFooter(command->get_footer(), page);
  }
}

void WriteSharedGroups(const Apps& commands, std::ostream& page)
{
  std::set<std::string> written;
  for (const CLI::App* first : commands)
  {
    for (const std::string& group : SharedGroups(first))
    {
      if (!written.insert(group).second)
      {
        continue;
      }
      page << ".SH \"" << Plain(Upper(group)) << "\"\n";
      for (const CLI::App* command : commands)
      {
        for (const CLI::Option* option : OptionsOf(command, group))
        {
          if (written.insert(group + option->get_name()).second)
          {
            WriteOption(option, page);
          }
        }
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::string ManualText(const CLI::App& app)
{
  const Apps commands = app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
  const std::string name = app.get_name();
  const std::string description = app.get_description();
  std::ostringstream page;
  page << ".TH " << Upper(name) << " 1 \"\" \"" << name << " " << app.version() << "\" \"User Commands\"\n"
       << ".nh\n.ad l\n" // options stay whole
       << ".SH NAME\n"
       << name << " \\- translucent surfaces drawn right, in any order, with VTK\n"
       << ".SH SYNOPSIS\n.nf\n";
  for (const CLI::App* command : commands)
  {
    page << "\\fB" << name << "\\fR " << Plain(Usage(command)) << "\n";
  }
  page << ".fi\n.SH DESCRIPTION\n" << Plain(description) << "\n";
  WriteFooter(app.get_footer(), page);
  page << ".SH COMMANDS\n";
  for (const CLI::App* command : commands)
  {
    WriteCommand(command, app.get_footer(), page);
  }
  page << ".SH TECHNIQUES\n";
  for (const TechniqueInfo& technique : ListTechniques())
  {
    page << ".TP\n.B " << Plain(technique.Name) << "\n" << Plain(technique.Help) << "\n";
  }
  WriteSharedGroups(commands, page);
  page << ".SH \"EXIT STATUS\"\n"
          "0 if all was done. Else 1, after one line that says what was met and what was expected, and no file was\n"
          "written. That of \\fBrun\\fR is the program\\(aqs.\n"
          ".SH ENVIRONMENT\n.TP\n.B DISPLAY\n"
          "the X display. Where there is none, and VTK can\\(aqt draw without, the command starts a virtual one by\n"
          "\\fBxvfb\\-run\\fR(1). The program of \\fBrun\\fR has to have its own.\n"
          ".SH \"SEE ALSO\"\n\\fBxvfb\\-run\\fR(1)\n";
  return page.str();
}
