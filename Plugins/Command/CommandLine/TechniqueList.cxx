// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TechniqueList.h"

#include "Techniques/Stage.h"
#include "Techniques/Techniques.h"

#include <vtkTranslucencyFactory.h>

#include <nlohmann/json.hpp>

#include <array>
#include <iomanip>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace
{
using OrderedJson = nlohmann::ordered_json;
using Kind = vtkTranslucencyOption::Kind;

// Of drivers that end there: old ones, and that of macOS at 4.1.
struct Version
{
  int Major;
  int Minor;
};
const std::array<Version, 2> Versions{ { { 4, 1 }, { 3, 3 } } };

std::string NameOf(const Version& version)
{
  return std::to_string(version.Major) + "." + std::to_string(version.Minor);
}

bool RunsOn(const Version& version, const std::string& technique)
{
  return vtkTranslucencyFactory::GetMissing(technique, version.Major, version.Minor).empty();
}

// Which drivers run which technique, a line for each.
std::string ToTable(const std::vector<TechniqueInfo>& techniques, Stage& stage)
{
  constexpr int width = 13;
  std::ostringstream table;
  const auto cell = [&table](const std::string& text) -> std::ostream&
  { return table << std::left << std::setw(width) << text; };
  cell("technique");
  cell("this driver");
  for (const Version& version : Versions)
  {
    cell("OpenGL " + NameOf(version));
  }
  table << "\n";
  for (const TechniqueInfo& technique : techniques)
  {
    cell(technique.Name);
    cell(stage.GetMissing(technique.Name).empty() ? "yes" : "no");
    for (const Version& version : Versions)
    {
      cell(RunsOn(version, technique.Name) ? "yes" : "no");
    }
    table << "\n";
  }
  return std::regex_replace(table.str(), std::regex(" +\n"), "\n");
}

const std::map<int, std::string> Transmissions{ { 3, "red, green and blue" }, { 1, "their mean" }, { 0, "ignored" } };

OrderedJson OptionToJson(const vtkTranslucencyOption& option)
{
  OrderedJson json;
  json["keyword"] = option.Keyword;
  json["flag"] = FlagOf(option);
  json["property"] = option.Name;
  json["type"] = option.Type == Kind::Integer ? "integer" : option.Type == Kind::Real ? "real" : "choice";
  json["default"] = option.Format(option.Default);
  json["range"] = option.Range();
  if (option.Type == Kind::Choice)
  {
    json["choices"] = option.Choices;
  }
  else
  {
    json["minimum"] = option.Minimum;
    json["maximum"] = option.Maximum; // null where there is none
  }
  json["help"] = option.Help;
  return json;
}

std::string ToJsonText(const std::vector<TechniqueInfo>& techniques, Stage& stage)
{
  OrderedJson json;
  json["driver"] = stage.GetDriver();
  json["vtk"] = TRANSLUCENCY_VTK_VERSION;
  json["techniques"] = OrderedJson::array();
  for (const TechniqueInfo& technique : techniques)
  {
    const std::string missing = stage.GetMissing(technique.Name);
    OrderedJson entry;
    entry["name"] = technique.Name;
    entry["help"] = technique.Help;
    entry["runs"] = missing.empty();
    entry["missing"] = missing.empty() ? OrderedJson() : OrderedJson(missing);
    for (const Version& version : Versions)
    {
      entry["runs_on_opengl"][NameOf(version)] = RunsOn(version, technique.Name);
    }
    entry["transmittances"] = technique.Transmittances;
    entry["options"] = OrderedJson::array();
    for (const vtkTranslucencyOption& option : technique.Options)
    {
      entry["options"].push_back(OptionToJson(option));
    }
    json["techniques"].push_back(entry);
  }
  return json.dump(2) + "\n";
}
}

//------------------------------------------------------------------------------
std::string TechniqueListText(bool json)
{
  Stage stage(std::array<int, 2>{ { 16, 16 } });
  const auto techniques = ListTechniques();
  if (json)
  {
    return ToJsonText(techniques, stage);
  }
  std::ostringstream out;
  out << "Techniques on " << stage.GetDriver() << ", and on drivers that end at an older OpenGL:\n\n";
  out << ToTable(techniques, stage);
  for (const TechniqueInfo& technique : techniques)
  {
    const std::string missing = stage.GetMissing(technique.Name);
    out << "\n" << technique.Name << "\n  " << technique.Help << "\n";
    out << "  transmission colours: " << Transmissions.at(technique.Transmittances) << "\n";
    if (!missing.empty())
    {
      out << "  does not run here: the driver lacks " << missing << "\n";
    }
    for (const vtkTranslucencyOption& option : technique.Options)
    {
      out << "    " << FlagOf(option) << " (" << option.Range() << "; default " << option.Format(option.Default)
          << ")\n        " << option.Help << "\n";
    }
  }
  return out.str();
}
