// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A name with settings, as one word of the command line: "adaptive:nodes=8:removal=mixed", "scene:spheres:count=10".
 */
#ifndef Specification_h
#define Specification_h

#include <string>
#include <utility>
#include <vector>

struct Specification
{
  std::string Text;
  std::string Name;
  std::vector<std::pair<std::string, std::string>> Settings; ///< key and value, as written

  /// Throws Failure if a setting has no key or no value, or is there twice.
  explicit Specification(const std::string& text);

  /// Throws Failure if there is a key that is not one of these.
  void CheckKeys(const std::vector<std::string>& known) const;

  /// The setting as an integer, or the default; throws Failure if it is none in the range.
  int GetInteger(const std::string& key, int byDefault, int least, int most) const;

  /// The setting as one of these words, or the first of them; throws Failure if it is another.
  std::string GetChoice(const std::string& key, const std::vector<std::string>& words) const;
};

/// "a, b, c", as messages list what they expect.
std::string Listed(const std::vector<std::string>& words);

#endif
