// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Some of the libraries behind VTK's readers answer a broken file by writing to stderr, by exit() or by crashing.
 * While a guard lives, each of these ends as every other error of the command does: one line, and no success.
 */
#ifndef ReadGuard_h
#define ReadGuard_h

#include <string>

class ReadGuard
{
public:
  /// what: how the line begins, the file and what was expected of it. strict: warnings are complaints too. One guard
  /// at a time.
  ReadGuard(const std::string& what, bool strict);
  ~ReadGuard();
  ReadGuard(const ReadGuard&) = delete;
  ReadGuard& operator=(const ReadGuard&) = delete;

  /// Throws Failure if anything was complained of since the guard was made.
  void Finish();

private:
  std::string What;
};

#endif
