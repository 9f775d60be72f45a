// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyOption.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

#include "vtkObject.h"
#include "vtkVariant.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkTranslucencyOption::IsOpen() const
{
  return !std::isfinite(this->Maximum) || (this->Type == Kind::Integer && this->Maximum == VTK_INT_MAX);
}

//------------------------------------------------------------------------------
vtkTranslucencyOption vtkTranslucencyOption::NewMemoryLimit(
  const std::string& subject, std::function<double()> get, std::function<void(double)> set)
{
  return { "MemoryLimit", "memory_limit", Kind::Real, 0, 0, std::numeric_limits<double>::infinity(), {},
    "graphics memory for " + subject +
      ", in MiB; what does not fit is drawn in tiles; 0 means a quarter of the driver's memory, or 2048",
    std::move(get), std::move(set) };
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyOption::Range() const
{
  std::ostringstream out;
  if (this->Type == Kind::Choice)
  {
    for (std::size_t i = 0; i < this->Choices.size(); ++i)
    {
      out << (i == 0 ? "" : i + 1 == this->Choices.size() ? " or " : ", ") << this->Choices[i];
    }
    return out.str();
  }
  out << this->Minimum << "..";
  if (!this->IsOpen())
  {
    out << this->Maximum;
  }
  return out.str();
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyOption::Expected() const
{
  std::ostringstream out;
  if (this->Type == Kind::Choice)
  {
    for (std::size_t i = 0; i < this->Choices.size(); ++i)
    {
      out << (i == 0 ? "" : i + 1 == this->Choices.size() ? " or " : ", ") << this->Choices[i] << " (" << i << ")";
    }
    return out.str();
  }
  out << this->Minimum;
  if (this->IsOpen())
  {
    out << " or more";
  }
  else
  {
    out << " to " << this->Maximum;
  }
  return out.str();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyOption::Takes(double value) const
{
  return value >= this->Minimum && value <= this->Maximum && (this->Type == Kind::Real || value == std::floor(value));
}

//------------------------------------------------------------------------------
bool vtkTranslucencyOption::Check(
  vtkObject* object, const std::vector<vtkTranslucencyOption>& options, const char* name, double value)
{
  for (const vtkTranslucencyOption& option : options)
  {
    if (option.Name == name && option.Takes(value))
    {
      return true;
    }
    if (option.Name == name)
    {
      std::ostringstream text; // of the whole number, however large
      text << std::setprecision(std::numeric_limits<double>::digits10) << value;
      vtkErrorWithObjectMacro(object, << name << " is " << text.str() << ", expected " << option.Expected());
      return false;
    }
  }
  vtkErrorWithObjectMacro(object, << name << " is no option");
  return false;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyOption::Format(double value) const
{
  if (this->Type == Kind::Choice)
  {
    return value >= 0 && value < static_cast<double>(this->Choices.size())
      ? this->Choices[static_cast<std::size_t>(value)]
      : "other";
  }
  std::ostringstream out;
  out << value;
  return out.str();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyOption::Parse(const std::string& text, double& value, std::string& error) const
{
  bool valid = false;
  if (this->Type == Kind::Choice)
  {
    const auto found = std::find(this->Choices.begin(), this->Choices.end(), text);
    valid = found != this->Choices.end();
    value = static_cast<double>(found - this->Choices.begin());
  }
  else
  {
    value = vtkVariant(text).ToDouble(&valid);
    valid = valid && this->Takes(value);
  }
  if (!valid)
  {
    error = this->Keyword + " is '" + text + "', expected " +
      (this->Type == Kind::Integer   ? "an integer in "
          : this->Type == Kind::Real ? "a number in "
                                     : "") +
      this->Range();
  }
  return valid;
}
VTK_ABI_NAMESPACE_END
