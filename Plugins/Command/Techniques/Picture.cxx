// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Basics/Failure.h"
#include "Basics/Libraries.h"
#include "Basics/Suffix.h"

#include <algorithm>

#include <dlfcn.h>

namespace
{
const char* const Suffixes[] = { ".png", ".exr", ".tif", ".tiff", ".jpg", ".jpeg" };
}

//------------------------------------------------------------------------------
std::unique_ptr<Picture> NewPicture(int width, int height, int channels, const unsigned char* pixels)
{
  const auto load = []
  {
    void* library =
      dlopen(FindLibrary(TRANSLUCENCY_PICTURES, "pictures are written with").c_str(), RTLD_NOW | RTLD_LOCAL);
    void* made = library ? dlsym(library, "NewOpenImageIOPicture") : nullptr;
    if (!made)
    {
      throw Failure(std::string("pictures can't be written: ") + dlerror());
    }
    return reinterpret_cast<Picture* (*)(int, int, int, const unsigned char*)>(made);
  };
  static const auto create = load();
  return std::unique_ptr<Picture>(create(width, height, channels, pixels));
}

//------------------------------------------------------------------------------
void CheckPictureSuffix(const std::filesystem::path& file)
{
  const std::string suffix = SuffixOf(file);
  if (std::find(std::begin(Suffixes), std::end(Suffixes), suffix) == std::end(Suffixes))
  {
    throw Failure("'" + file.string() + "' has the suffix '" + suffix + "', expected one of " + PictureSuffixes());
  }
}

//------------------------------------------------------------------------------
void CheckHoldsTransparency(const std::filesystem::path& file)
{
  const std::string suffix = SuffixOf(file);
  if (suffix == ".jpg" || suffix == ".jpeg")
  {
    throw Failure("'" + file.string() + "' is to have a transparent background, which " + suffix +
      " can't hold, expected .png .exr .tif or .tiff");
  }
}

//------------------------------------------------------------------------------
void Picture::Write(const std::filesystem::path& file, const std::string& name) const
{
  this->Write(file, name, SuffixOf(file) == ".exr");
}

//------------------------------------------------------------------------------
std::string PictureSuffixes()
{
  std::string suffixes;
  for (const char* suffix : Suffixes)
  {
    suffixes += (suffixes.empty() ? "" : " ") + std::string(suffix);
  }
  return suffixes;
}
