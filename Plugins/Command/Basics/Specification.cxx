// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Specification.h"

#include "Failure.h"

#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <sstream>

//------------------------------------------------------------------------------
std::string Listed(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

//------------------------------------------------------------------------------
Specification::Specification(const std::string& text)
  : Text(text)
{
  std::istringstream words(text);
  std::getline(words, this->Name, ':');
  std::string setting;
  while (std::getline(words, setting, ':'))
  {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size())
    {
      throw Failure("'" + setting + "' in '" + text + "' is not a setting, expected KEY=VALUE");
    }
    const std::string key = setting.substr(0, equals);
    for (const auto& other : this->Settings)
    {
      if (other.first == key)
      {
        throw Failure("'" + key + "' is set twice in '" + text + "', expected once");
      }
    }
    this->Settings.emplace_back(key, setting.substr(equals + 1));
  }
}

//------------------------------------------------------------------------------
void Specification::CheckKeys(const std::vector<std::string>& known) const
{
  for (const auto& setting : this->Settings)
  {
    if (std::find(known.begin(), known.end(), setting.first) == known.end())
    {
      throw Failure("'" + this->Name + "' has no option '" + setting.first + "', expected " +
        (known.empty() ? "none: it has no options" : "one of: " + Listed(known)));
    }
  }
}

//------------------------------------------------------------------------------
int Specification::GetInteger(const std::string& key, int byDefault, int least, int most) const
{
  for (const auto& setting : this->Settings)
  {
    if (setting.first != key)
    {
      continue;
    }
    bool valid = false;
    const double value = vtkVariant(setting.second).ToDouble(&valid);
    if (!valid || value < least || value > most || value != std::floor(value))
    {
      throw Failure(key + " is '" + setting.second + "' in '" + this->Text + "', expected an integer in " +
        std::to_string(least) + ".." + std::to_string(most));
    }
    return static_cast<int>(value);
  }
  return byDefault;
}

//------------------------------------------------------------------------------
std::string Specification::GetChoice(const std::string& key, const std::vector<std::string>& words) const
{
  for (const auto& setting : this->Settings)
  {
    if (setting.first != key)
    {
      continue;
    }
    if (std::find(words.begin(), words.end(), setting.second) == words.end())
    {
      throw Failure(key + " is '" + setting.second + "' in '" + this->Text + "', expected one of: " + Listed(words));
    }
    return setting.second;
  }
  return words.front();
}
