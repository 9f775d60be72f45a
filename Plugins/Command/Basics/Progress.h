// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One line on a terminal that says what is being done and how far it is; silent where stderr is not a terminal.
 * Each step also notices that the user has asked to stop, so that what was half written is removed.
 */
#ifndef Progress_h
#define Progress_h

#include <string>

class Progress
{
public:
  /// steps: how often Step will be called; 0 if that is not known.
  explicit Progress(const std::string& what, int steps = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The next step begins. Throws Failure after SIGINT or SIGTERM.
  void Step(const std::string& detail = "");

  /// Makes room for another line on the terminal.
  static void Clear();

  /// From now on SIGINT and SIGTERM end the command at the next step.
  static void CatchSignals();

private:
  std::string What;
  int Steps;
  int Done = 0;
};

#endif
