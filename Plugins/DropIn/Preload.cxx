// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What `translucency run` preloads into a program: where the program, or VTK in it, asks for a depth peeling pass, it
 * gets one that draws by the technique that was chosen. With --always (TRANSLUCENCY_ALWAYS in the environment), what
 * would be drawn without peeling is, too.
 *
 * The loader resolves calls from one library into another, and the tables of virtual functions, to the functions at the
 * end of this file:
 * - vtkDualDepthPeelingPass::New() and vtkDepthPeelingPass::New(): asking for peeling.
 * - vtkOpenGLRenderer::UpdateGeometry(): whatever draws a renderer's props without a pass, or as a part of one
 *   (ParaView). With --always the renderer peels while it is in there, which leads to the former: VTK's effects, and
 *   volumes, come out as where peeling was asked for. All renderers go through there: those made by the object factory,
 *   subclasses of a program in C++ (F3D) and in Python (PyVista), and those that switch peeling off before each frame.
 * - vtkDefaultPass::RenderTranslucentPolygonalGeometry(), and the other one of it that heeds the keys of props: the
 * step of a chain of passes that draws translucent props without peeling. vtkTranslucentPass, a subclass, is such a
 * step in F3D, in vtkRenderStepsPass, and in scripts. Programs see their renderers and passes as they have made them. A
 * factory override would not do: the first factory registered wins, and subclasses of vtkRenderer are not made by a
 * factory. Nor would the renderer's constructor: the program sets what it likes afterwards.
 *
 * Nothing here links with VTK: programs that do without it are preloaded too. Once VTK has called, its version tells
 * which drop-in is loaded: <VTK's version>/libvtkTranslucencyDropIn.so beside this library. If there is none, VTK's own
 * is called, and it is said why.
 */
#include "DropInFunctions.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

#include <dlfcn.h>
#include <link.h>

// As VTK declares them, as far as the loader can tell.
class vtkFrameBufferObjectBase;
class vtkRenderState;
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
class vtkOpenGLRenderer
{
public:
  int UpdateGeometry(vtkFrameBufferObjectBase* framebuffer);
};
class vtkDefaultPass
{
public:
  void RenderTranslucentPolygonalGeometry(const vtkRenderState* state);
  void RenderFilteredTranslucentPolygonalGeometry(const vtkRenderState* state);
};

namespace
{
namespace fs = std::filesystem;

const char* const NewDual = "_ZN23vtkDualDepthPeelingPass3NewEv";
const char* const NewSingle = "_ZN19vtkDepthPeelingPass3NewEv";
const char* const UpdateGeometry = "_ZN17vtkOpenGLRenderer14UpdateGeometryEP24vtkFrameBufferObjectBase";
const char* const RenderAll = "_ZN14vtkDefaultPass34RenderTranslucentPolygonalGeometryEPK14vtkRenderState";
const char* const RenderFiltered = "_ZN14vtkDefaultPass42RenderFilteredTranslucentPolygonalGeometryEPK14vtkRenderState";

void Say(const std::string& text)
{
  std::fprintf(stderr, "translucency run: %s: %s\n", program_invocation_short_name, text.c_str());
}

std::string FileOf(const void* address)
{
  Dl_info info;
  return dladdr(address, &info) && info.dli_fname ? info.dli_fname : "";
}

// Of the libraries of the program, the first whose file has one of the names; empty if there is none.
std::string FindLoaded(const std::vector<const char*>& names)
{
  struct Search
  {
    const std::vector<const char*>& Names;
    std::string File;
  } search{ names, "" };
  const auto look = [](dl_phdr_info* info, size_t, void* data)
  {
    auto* to = static_cast<Search*>(data);
    const std::string file = info->dlpi_name ? info->dlpi_name : "";
    const bool found = std::any_of(to->Names.begin(), to->Names.end(),
      [&](const char* name) { return file.find(name, file.rfind('/') + 1) != std::string::npos; });
    to->File = found ? file : "";
    return found ? 1 : 0;
  };
  dl_iterate_phdr(look, &search);
  return search.File;
}

std::string FindVTK()
{
  return FindLoaded({ "vtkRenderingOpenGL2" });
}

void* FindIn(const std::string& file, const char* symbol)
{
  void* library = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (!library)
  {
    return nullptr;
  }
  void* found = dlsym(library, symbol);
  dlclose(library); // it stays as long as the program has it
  return found;
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
  return found ? found : FindIn(FindVTK(), symbol);
}

template <typename Function>
Function* FindOwn(const char* symbol, const void* caller)
{
  auto* own = reinterpret_cast<Function*>(Find(symbol, caller));
  if (!own)
  {
    Say(std::string("there is no ") + symbol + " behind " + FileOf(caller) + ", expected VTK's");
    std::abort();
  }
  return own;
}

// The library that draws, loaded when VTK first calls for it.
class DropIn
{
public:
  static DropIn& Get()
  {
    static DropIn dropIn;
    return dropIn;
  }

  // What it can do; null where VTK draws for itself.
  const DropInFunctions* Use(const void* caller)
  {
    std::call_once(this->Loaded, [&] { this->Load(caller); });
    this->Reached = true;
    return this->Functions;
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
    const std::string here = FileOf(reinterpret_cast<const void*>(&FindVTK));
    const fs::path folder = fs::path(here).parent_path();
    const std::vector<std::string> versions = ListVersions(folder);
    if (std::find(versions.begin(), versions.end(), version) == versions.end())
    {
      std::string known;
      for (const std::string& one : versions)
      {
        known += (known.empty() ? "" : ", ") + one;
      }
      Refuse("it uses VTK " + version + ", and the drop-ins in " + folder.string() + " are for " +
        (known.empty() ? "none" : known) + "; one for it can be built (Documentation/Programs.md)");
      return;
    }
    void* library = dlopen((folder / version / TRANSLUCENCY_DROP_IN).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library)
    {
      Refuse(std::string("the drop-in can't be loaded: ") + dlerror());
      return;
    }
    // A second copy of VTK would come with it where the program has one of its own.
    const std::string theirs = FileOf(Find(NewDual, caller));
    const std::string ours = FileOf(dlsym(library, NewDual));
    if (theirs != ours)
    {
      Refuse("its VTK is " + theirs + ", expected " + ours);
      return;
    }
    using GetFunctions = const DropInFunctions* (*)();
    auto* getFunctions = reinterpret_cast<GetFunctions>(dlsym(library, DropInFunctionsSymbol));
    const std::string release = getFunctions ? getFunctions()->Release : "unknown";
    if (release != TRANSLUCENCY_RELEASE)
    {
      Refuse("the drop-in for VTK " + version + " is of release " + release + ", expected " TRANSLUCENCY_RELEASE);
      return;
    }
    this->Functions = getFunctions();
    if (this->Always && FileOf(this->Functions->GetUpdateGeometry()) != here)
    {
      Say("its VTK, " + theirs +
        ", is linked so that its renderers can't be reached: --always finds its passes, and what asks for depth "
        "peeling (vtkRenderer::UseDepthPeelingOn); the rest draws as it would have");
    }
  }

  static std::vector<std::string> ListVersions(const fs::path& folder)
  {
    std::vector<std::string> versions;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
    {
      if (fs::exists(entry.path() / TRANSLUCENCY_DROP_IN, error))
      {
        versions.push_back(entry.path().filename().string());
      }
    }
    std::sort(versions.begin(), versions.end());
    return versions;
  }

  static void Refuse(const std::string& reason) { Say(reason + "; it draws as it would have"); }

public:
  const bool Always = std::getenv("TRANSLUCENCY_ALWAYS") != nullptr;
  bool Reached = false;

private:
  std::once_flag Loaded;
  const DropInFunctions* Functions = nullptr;
};

// A pass of the chosen technique, or VTK's own.
void* NewPeeling(const char* symbol, const void* caller)
{
  auto* own = FindOwn<void*()>(symbol, caller);
  const DropInFunctions* functions = DropIn::Get().Use(caller);
  return functions && FileOf(caller) != functions->ModuleFile ? functions->NewPeeling() : own();
}

// By the chosen technique, or by VTK's own.
void RenderTranslucent(const char* symbol, void* pass, const vtkRenderState* state, const void* caller)
{
  auto* own = FindOwn<void(void*, const void*)>(symbol, caller);
  const DropInFunctions* functions = DropIn::Get().Always ? DropIn::Get().Use(caller) : nullptr;
  if (!functions || !functions->RenderTranslucent(state))
  {
    own(pass, state);
  }
}

// Says so where a program that draws by OpenGL was never reached.
__attribute__((destructor)) void SayIfNeverReached()
{
  if (DropIn::Get().Reached)
  {
    return;
  }
  if (!FindVTK().empty())
  {
    Say(DropIn::Get().Always
        ? "no renderer or pass of VTK drew in it; it drew as it would have"
        : "it never asked for depth peeling (vtkRenderer::UseDepthPeelingOn, or a depth peeling pass); it drew as it "
          "does without. With --always it gets the technique all the same");
  }
  else if (!FindLoaded({ "libGL.so", "libGLX.so", "libEGL.so", "libOSMesa.so" }).empty())
  {
    Say("it draws by OpenGL, but has no library of VTK (vtkRenderingOpenGL2): it does without, or holds VTK in itself, "
        "where it can't be reached; it drew as it would have");
  }
}
}

//------------------------------------------------------------------------------
__attribute__((visibility("default"))) vtkDualDepthPeelingPass* vtkDualDepthPeelingPass::New()
{
  return static_cast<vtkDualDepthPeelingPass*>(NewPeeling(NewDual, __builtin_return_address(0)));
}

//------------------------------------------------------------------------------
__attribute__((visibility("default"))) vtkDepthPeelingPass* vtkDepthPeelingPass::New()
{
  return static_cast<vtkDepthPeelingPass*>(NewPeeling(NewSingle, __builtin_return_address(0)));
}

//------------------------------------------------------------------------------
__attribute__((visibility("default"))) int vtkOpenGLRenderer::UpdateGeometry(vtkFrameBufferObjectBase* framebuffer)
{
  const void* caller = __builtin_return_address(0);
  auto* own = FindOwn<int(void*, void*)>(::UpdateGeometry, caller);
  const DropInFunctions* functions = DropIn::Get().Always ? DropIn::Get().Use(caller) : nullptr;
  return functions ? functions->UpdateGeometry(this, framebuffer, own) : own(this, framebuffer);
}

//------------------------------------------------------------------------------
__attribute__((visibility("default"))) void vtkDefaultPass::RenderTranslucentPolygonalGeometry(
  const vtkRenderState* state)
{
  RenderTranslucent(RenderAll, this, state, __builtin_return_address(0));
}

//------------------------------------------------------------------------------
__attribute__((visibility("default"))) void vtkDefaultPass::RenderFilteredTranslucentPolygonalGeometry(
  const vtkRenderState* state)
{
  RenderTranslucent(RenderFiltered, this, state, __builtin_return_address(0));
}
