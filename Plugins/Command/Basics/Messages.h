// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Takes the place of VTK's output window: errors are kept until the command asks for them, so that they end it with one
 * line; warnings are kept until the end, and each is printed once, on one line.
 */
#ifndef Messages_h
#define Messages_h

#include "vtkOutputWindow.h"

#include <string>
#include <vector>

class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  /// The one that VTK reports to, from the first call on.
  static Messages* Get();

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char* text) override;

  /// The first error since the last call, empty if there was none.
  std::string TakeError();

  /// The last warning, which is then forgotten; empty if there was none.
  std::string TakeWarning();

  /// Throws Failure if there was an error: "context: the error".
  void ThrowError(const std::string& context);

  /// While on, a warning counts as an error.
  void SetStrict(bool strict) { this->Strict = strict; }

  /// Prints the warnings, each once.
  void PrintWarnings();

  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

protected:
  Messages() = default;
  ~Messages() override = default;

private:
  bool Strict = false;
  std::string Error;
  std::vector<std::string> Warnings;
};

#endif
