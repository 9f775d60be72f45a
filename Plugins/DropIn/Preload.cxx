// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What `translucency run` preloads into a program: where the program, or VTK in it, asks for a depth peeling pass, it
 * gets one that draws by the technique that was chosen.
 *
 * Asking is a call of vtkDualDepthPeelingPass::New() or vtkDepthPeelingPass::New() from one library into another, which
 * the loader resolves to the functions below. Nothing here links with VTK: programs that do without it are preloaded
 * too. Once VTK has called, its version is compared with the one that vtkTranslucencyDropIn was built with; if that is
 * another one, VTK's own pass is made, and it is said why.
 *
 * A factory override would not do: the first factory registered wins, and subclasses of vtkRenderer make their passes
 * themselves.
 */
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

#include <dlfcn.h>
#include <link.h>

// As VTK declares them, as far as the loader can tell.
class vtkDualDepthPeelingPass
{
public:
  static vtkDualDepthPeelingPass* New();
};
class vtkDepthPeelingPass
{
public:
  static vtkDepthPeelingPass* New();
};

namespace
{
const char* const NewDual = "_ZN23vtkDualDepthPeelingPass3NewEv";
const char* const NewSingle = "_ZN19vtkDepthPeelingPass3NewEv";

void Say(const std::string& text)
{
  std::fprintf(stderr, "translucency run: %s: %s\n", program_invocation_short_name, text.c_str());
}

std::string FileOf(const void* address)
{
  Dl_info info;
  return dladdr(address, &info) && info.dli_fname ? info.dli_fname : "";
}

bool HoldsVTK(const char* file)
{
  return file && std::strstr(file, "vtkRenderingOpenGL2");
}

void* FindIn(const std::string& file, const char* symbol)
{
  void* library = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  return library ? dlsym(library, symbol) : nullptr;
}

// What a symbol would mean to a caller without this library: where VTK was opened for itself alone, as Python does,
// among what the caller's library depends on, or, where it calls through a pointer that another one gave it, among what
// VTK's depends on.
void* Find(const char* symbol, const void* caller)
{
  void* found = dlsym(RTLD_NEXT, symbol);
  if (!found)
  {
    found = FindIn(FileOf(caller), symbol);
  }
  if (!found)
  {
    std::string file;
    const auto look = [](dl_phdr_info* info, size_t, void* to)
    {
      *static_cast<std::string*>(to) = HoldsVTK(info->dlpi_name) ? info->dlpi_name : "";
      return HoldsVTK(info->dlpi_name) ? 1 : 0;
    };
    dl_iterate_phdr(look, &file);
    found = FindIn(file, symbol);
  }
  return found;
}

// The library that makes the passes, loaded with the first of them.
class DropIn
{
public:
  static DropIn& Get()
  {
    static DropIn dropIn;
    return dropIn;
  }

  // A pass of the chosen technique, or VTK's own.
  void* New(const char* symbol, const void* caller)
  {
    auto* own = reinterpret_cast<void* (*)()>(Find(symbol, caller));
    if (!own)
    {
      Say(std::string("there is no ") + symbol + " behind " + FileOf(caller) + ", expected VTK's");
      std::abort();
    }
    std::call_once(this->Loaded, [&] { this->Load(caller); });
    if (!this->Make || FileOf(caller) == this->ModuleFile) // techniques may use VTK's peeling
    {
      return own();
    }
    this->Asked = true;
    return this->Make();
  }

  DropIn(const DropIn&) = delete;
  DropIn& operator=(const DropIn&) = delete;

private:
  DropIn() = default;

  void Load(const void* caller)
  {
    using GetText = const char* (*)();
    auto* getVersion = reinterpret_cast<GetText>(Find("GetVTKVersion", caller));
    const std::string version = getVersion ? getVersion() : "of an unknown version";
    if (version != TRANSLUCENCY_VTK_VERSION)
    {
      this->Refuse("it uses VTK " + version + ", expected " TRANSLUCENCY_VTK_VERSION);
      return;
    }
    std::string file = FileOf(reinterpret_cast<const void*>(&HoldsVTK));
    file.replace(file.rfind('/') + 1, std::string::npos, TRANSLUCENCY_DROP_IN);
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library)
    {
      this->Refuse(std::string("the drop-in can't be loaded: ") + dlerror());
      return;
    }
    // A second copy of VTK would come with it where the program has one of its own.
    const std::string theirs = FileOf(Find(NewDual, caller));
    const std::string ours = FileOf(dlsym(library, NewDual));
    if (theirs != ours)
    {
      this->Refuse("its VTK is " + theirs + ", expected " + ours);
      return;
    }
    this->ModuleFile = reinterpret_cast<GetText>(dlsym(library, "vtkTranslucencyDropInModule"))();
    this->Make = reinterpret_cast<void* (*)()>(dlsym(library, "vtkTranslucencyDropInNew"));
  }

  void Refuse(const std::string& reason)
  {
    this->Asked = true;
    Say(reason + "; it draws by its own depth peeling");
  }

public:
  bool Asked = false;

private:
  std::once_flag Loaded;
  void* (*Make)() = nullptr;
  std::string ModuleFile;
};

// Says so where a program with VTK in it has never asked.
__attribute__((destructor)) void SayIfNeverAsked()
{
  const auto look = [](dl_phdr_info* info, size_t, void*) { return HoldsVTK(info->dlpi_name) ? 1 : 0; };
  if (!DropIn::Get().Asked && dl_iterate_phdr(look, nullptr))
  {
    Say("it never asked for depth peeling (vtkRenderer::UseDepthPeelingOn, or a depth peeling "
        "pass); it drew as it does without");
  }
}
}

//------------------------------------------------------------------------------
__attribute__((visibility("default"))) vtkDualDepthPeelingPass* vtkDualDepthPeelingPass::New()
{
  return static_cast<vtkDualDepthPeelingPass*>(DropIn::Get().New(NewDual, __builtin_return_address(0)));
}

//------------------------------------------------------------------------------
__attribute__((visibility("default"))) vtkDepthPeelingPass* vtkDepthPeelingPass::New()
{
  return static_cast<vtkDepthPeelingPass*>(DropIn::Get().New(NewSingle, __builtin_return_address(0)));
}
