// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFiles.h"

#include "Failure.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <unistd.h>

namespace fs = std::filesystem;

//------------------------------------------------------------------------------
OutputFiles::~OutputFiles()
{
  std::error_code ignored;
  for (const Entry& entry : this->Entries)
  {
    fs::remove(entry.Written, ignored);
  }
  for (auto folder = this->Folders.rbegin(); folder != this->Folders.rend(); ++folder)
  {
    fs::remove(*folder, ignored); // fails, as it should, where something lies in it
  }
}

//------------------------------------------------------------------------------
void OutputFiles::AddFolder(const fs::path& folder)
{
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error))
  {
    return;
  }
  const fs::path parent = folder.parent_path();
  if (parent != folder)
  {
    this->AddFolder(parent);
  }
  if (!fs::create_directory(folder, error))
  {
    throw Failure(
      "folder '" + folder.string() + "' can't be made: " + (error ? error.message() : "a file of that name exists"));
  }
  this->Folders.push_back(folder);
}

//------------------------------------------------------------------------------
fs::path OutputFiles::Add(const fs::path& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw Failure("'" + file.string() + "' can't be written: it exists and is not a regular file");
  }
  const fs::path written =
    file.parent_path() / ("." + file.stem().string() + "." + std::to_string(getpid()) + file.extension().string());
  OutputFiles::Write(written, "", file);
  this->Entries.push_back({ written, file });
  return written;
}

//------------------------------------------------------------------------------
void OutputFiles::Write(const fs::path& file, const std::string& text, const fs::path& name)
{
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out)
  {
    throw Failure("'" + name.string() + "' can't be written: " + std::strerror(errno));
  }
}

//------------------------------------------------------------------------------
void OutputFiles::AddText(const fs::path& file, const std::string& text)
{
  OutputFiles::Write(this->Add(file), text, file);
}

//------------------------------------------------------------------------------
void OutputFiles::Commit()
{
  for (const Entry& entry : this->Entries)
  {
    std::error_code error;
    fs::rename(entry.Written, entry.Final, error);
    if (error)
    {
      throw Failure("'" + entry.Final.string() + "' can't be written: " + error.message());
    }
  }
  this->Entries.clear();
  this->Folders.clear();
}
