// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files that appear all together, when everything that makes them has succeeded, or not at all.
 */
#ifndef OutputFiles_h
#define OutputFiles_h

#include <filesystem>
#include <string>
#include <vector>

class OutputFiles
{
public:
  OutputFiles() = default;
  /// Removes what was not committed, and the folders made for it.
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Makes a folder, and those above it, unless they exist.
  void AddFolder(const std::filesystem::path& folder);

  /// Where to write what will become file: a name beside it with the same suffix. Throws Failure if nothing can be
  /// written there.
  std::filesystem::path Add(const std::filesystem::path& file);

  /// Add, and write the text.
  void AddText(const std::filesystem::path& file, const std::string& text);

  /// Writes text; throws Failure, with the file's name, if that fails.
  static void Write(const std::filesystem::path& file, const std::string& text, const std::filesystem::path& name);

  /// Gives all files their names.
  void Commit();

private:
  struct Entry
  {
    std::filesystem::path Written;
    std::filesystem::path Final;
  };
  std::vector<Entry> Entries;
  std::vector<std::filesystem::path> Folders;
};

#endif
