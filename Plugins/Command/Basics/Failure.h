// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What stops the command: one line for the user that names the thing, its value and what was expected.
 */
#ifndef Failure_h
#define Failure_h

#include <stdexcept>
#include <string>

/// What a library says, fit for one line of a message: bytes that are not ASCII (parts of a broken file) become '?',
/// addresses of objects go, and what is very long is cut.
std::string Quotable(const std::string& text);

/// Text on one line: line breaks and control characters become single spaces.
std::string OneLine(const std::string& text);

class Failure : public std::runtime_error
{
public:
  explicit Failure(const std::string& message)
    : std::runtime_error(OneLine(message))
  {
  }
};

#endif
