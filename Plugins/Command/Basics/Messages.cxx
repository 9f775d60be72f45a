// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "Failure.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <iostream>
#include <regex>

vtkStandardNewMacro(Messages);

namespace
{
// VTK's macros write "ERROR: In FILE, line N\nvtkClass (0x1234): what happened".
// A failed pipeline adds a dump of its request.
std::string WithoutDecoration(const std::string& text)
{
  static const std::regex decoration(
    "^(ERROR|Warning|Generic Warning): In [^\n]*, line [0-9]+\n?([A-Za-z_0-9]+ \\([^)]*\\): )?");
  const std::string said = text.substr(0, text.find(" for request: "));
  return Quotable(std::regex_replace(said.substr(0, 4000), decoration, ""));
}
}

//------------------------------------------------------------------------------
Messages* Messages::Get()
{
  static vtkNew<Messages> messages;
  if (vtkOutputWindow::GetInstance() != messages)
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // or it would say everything a second time
    vtkOutputWindow::SetInstance(messages);
  }
  return messages;
}

//------------------------------------------------------------------------------
void Messages::DisplayText(const char*)
{
  // Neither an error nor a warning: nothing that a user of the command has to know.
}

//------------------------------------------------------------------------------
void Messages::DisplayDebugText(const char*) {}

//------------------------------------------------------------------------------
void Messages::DisplayErrorText(const char* text)
{
  if (this->Error.empty())
  {
    this->Error = WithoutDecoration(text);
  }
}

//------------------------------------------------------------------------------
void Messages::DisplayWarningText(const char* text)
{
  if (this->Strict)
  {
    this->DisplayErrorText(text);
    return;
  }
  const std::string warning = WithoutDecoration(text);
  if (std::find(this->Warnings.begin(), this->Warnings.end(), warning) == this->Warnings.end())
  {
    this->Warnings.push_back(warning);
  }
}

//------------------------------------------------------------------------------
void Messages::DisplayGenericWarningText(const char* text)
{
  this->DisplayWarningText(text);
}

//------------------------------------------------------------------------------
std::string Messages::TakeError()
{
  std::string error;
  error.swap(this->Error);
  return error;
}

//------------------------------------------------------------------------------
std::string Messages::TakeWarning()
{
  std::string warning;
  if (!this->Warnings.empty())
  {
    warning = this->Warnings.back();
    this->Warnings.pop_back();
  }
  return warning;
}

//------------------------------------------------------------------------------
void Messages::ThrowError(const std::string& context)
{
  const std::string error = this->TakeError();
  if (!error.empty())
  {
    throw Failure(context + ": " + error);
  }
}

//------------------------------------------------------------------------------
void Messages::PrintWarnings()
{
  for (const std::string& warning : this->Warnings)
  {
    std::cerr << "translucency: warning: " << warning << "\n";
  }
  this->Warnings.clear();
}
