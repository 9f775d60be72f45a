// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"

#include <algorithm>
#include <cctype>
#include <regex>

//------------------------------------------------------------------------------
std::string OneLine(const std::string& text)
{
  std::string line;
  for (const char character : text)
  {
    const bool blank =
      std::isspace(static_cast<unsigned char>(character)) || std::iscntrl(static_cast<unsigned char>(character));
    if (!blank)
    {
      line += character;
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  while (!line.empty() && line.back() == ' ')
  {
    line.pop_back();
  }
  return line;
}

//------------------------------------------------------------------------------
std::string Quotable(const std::string& text)
{
  static const std::regex address(" ?\\(0x[0-9a-fA-F]+\\)");
  const std::size_t longest = 200;
  std::string line = OneLine(std::regex_replace(text.substr(0, 10 * longest), address, ""));
  std::replace_if(
    line.begin(), line.end(), [](unsigned char character) { return character > 126; }, '?');
  return line.size() <= longest ? line : line.substr(0, longest) + "...";
}
