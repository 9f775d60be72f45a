// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyCapabilities.h"

#include "Common/Bindings.glsl"
#include "vtkTranslucencyShader.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSetGet.h" // for vtkGenericWarningMacro

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkTypeInt64 BlockBytesOfLlvmpipe = vtkTypeInt64(1) << 31;
constexpr GLint MostTargets = 8; // that shaders unroll (Common/EachVector.glsl)

std::set<std::string> Extensions()
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  std::set<std::string> names;
  for (GLint i = 0; i < count; ++i)
  {
    names.insert(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))));
  }
  return names;
}

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

// What the compiler says against a trial of Common/Trial.glsl, empty if nothing.
std::string Refusal(const std::string& trial, const std::string& criticalSection = "None")
{
  vtkTranslucencyShader shader;
  return shader.Assemble("Common/Trial.glsl", { { "TRIAL", trial } }, {}, { { "CriticalSection", criticalSection } }) &&
      shader.Validate("")
    ? ""
    : shader.GetError().substr(0, shader.GetError().find_last_not_of('\n') + 1);
}

// Adds what the compiler refuses to what the driver lacks, where it lacks nothing else.
void Try(const std::string& trial, const std::string& what, std::string& missing)
{
  if (missing.empty())
  {
    const std::string refusal = Refusal(trial);
    missing = refusal.empty() ? "" : "a compiler for " + what + " (" + refusal + ")";
  }
}

bool AnyDrawOrder()
{
  const char* order = std::getenv("TRANSLUCENCY_DRAW_ORDER");
  const bool any = order && std::string(order) == "any";
  if (order && !any)
  {
    vtkGenericWarningMacro("TRANSLUCENCY_DRAW_ORDER is '"
      << order << "', expected 'any', or that it is not set; the driver's own is taken.");
  }
  return any;
}
}

//------------------------------------------------------------------------------
bool vtkTranslucencyCapabilities::IsRasterizer(const std::string& renderer)
{
  return StartsWith(renderer, "llvmpipe") || StartsWith(renderer, "softpipe");
}

//------------------------------------------------------------------------------
void vtkTranslucencyCapabilities::FindMissing(const std::set<std::string>& extensions)
{
  const auto missing = [&extensions](const std::vector<std::string>& needed)
  {
    std::string names;
    for (const std::string& name : needed)
    {
      if (extensions.count(name) == 0)
      {
        names += (names.empty() ? "" : ", ") + name;
      }
    }
    return names;
  };
  this->MissingForTargets = missing({ "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding" });
  this->MissingForStorage = missing(
    { "GL_ARB_shader_storage_buffer_object", "GL_ARB_shader_image_load_store", "GL_ARB_shading_language_420pack",
      "GL_ARB_shading_language_packing", "GL_ARB_shader_bit_encoding", "GL_ARB_gpu_shader5", "GL_ARB_sample_shading",
      "GL_ARB_clear_buffer_object", "GL_ARB_texture_buffer_object_rgb32" });
  this->MissingForSamples = missing({ "GL_ARB_post_depth_coverage" });
  this->BlendsBuffersApart = missing({ "GL_ARB_draw_buffers_blend" }).empty();
  this->ShadesSamples = missing({ "GL_ARB_sample_shading" }).empty();
  this->MissingForTransmission = missing({ "GL_ARB_blend_func_extended", "GL_ARB_explicit_attrib_location" });
  this->MissingForFetch = missing({ "GL_EXT_shader_framebuffer_fetch", "GL_ARB_explicit_attrib_location" });
  this->MissingForRetries = missing({ "GL_ARB_ES3_1_compatibility" }); // gl_HelperInvocation
}

//------------------------------------------------------------------------------
vtkTranslucencyCapabilities vtkTranslucencyCapabilities::OfVersion(int major, int minor)
{
  // The version of OpenGL of which each has become a part, as its specification says.
  const std::map<std::string, std::pair<int, int>> parts{ { "GL_ARB_blend_func_extended", { 3, 3 } },
    { "GL_ARB_explicit_attrib_location", { 3, 3 } }, { "GL_ARB_shader_bit_encoding", { 3, 3 } },
    { "GL_ARB_draw_buffers_blend", { 4, 0 } }, { "GL_ARB_gpu_shader5", { 4, 0 } },
    { "GL_ARB_sample_shading", { 4, 0 } }, { "GL_ARB_texture_buffer_object_rgb32", { 4, 0 } },
    { "GL_ARB_shader_image_load_store", { 4, 2 } }, { "GL_ARB_shading_language_420pack", { 4, 2 } },
    { "GL_ARB_shading_language_packing", { 4, 2 } }, { "GL_ARB_clear_buffer_object", { 4, 3 } },
    { "GL_ARB_shader_storage_buffer_object", { 4, 3 } }, { "GL_ARB_ES3_1_compatibility", { 4, 5 } } };
  std::set<std::string> extensions;
  for (const auto& [extension, version] : parts)
  {
    if (version <= std::make_pair(major, minor))
    {
      extensions.insert(extension);
    }
  }
  vtkTranslucencyCapabilities result;
  result.FindMissing(extensions);
  result.Renderer = "OpenGL " + std::to_string(major) + "." + std::to_string(minor);
  result.MaximumTargets = MostTargets; // OpenGL 3.0 promises 8
  result.TextureUnits = 16;            // OpenGL 3.0 does, too
  return result;
}

//------------------------------------------------------------------------------
vtkTranslucencyCapabilities vtkTranslucencyCapabilities::Probe(vtkOpenGLRenderWindow* window)
{
  vtkTranslucencyCapabilities result;
  result.Renderer = window->GetState()->GetRenderer();

  const std::set<std::string> extensions = Extensions();
  result.FindMissing(extensions);
  // Before OpenGL 4.0 the extension's functions have other names.
  result.BlendsBuffersApart = result.BlendsBuffersApart && glBlendEquationi && glBlendFuncSeparatei;
  Try("TRIAL_STORAGE", "storage blocks", result.MissingForStorage);
  GLint drawn = 0;
  GLint attached = 0;
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &drawn);
  glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attached);
  result.MaximumTargets = std::min({ drawn, attached, MostTargets });
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &result.TextureUnits);
  for (const char* name :
    { "GL_INTEL_fragment_shader_ordering", "GL_NV_fragment_shader_interlock", "GL_ARB_fragment_shader_interlock" })
  {
    result.Interlock = extensions.count(name) > 0 ? name : result.Interlock; // the last one is the standard's
  }
  if (result.MissingForStorage.empty())
  {
    Try("TRIAL_MASKS", "coverage masks", result.MissingForSamples);
    Try("TRIAL_FETCH", "fetched colours", result.MissingForFetch);
    if (!result.Interlock.empty() && !Refusal("TRIAL_INTERLOCK", "Interlock").empty())
    {
      result.Interlock.clear();
    }

    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    result.MaximumBlockBytes =
      StartsWith(result.Renderer, "llvmpipe") ? std::max<vtkTypeInt64>(bytes, BlockBytesOfLlvmpipe) : bytes;

    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    result.MaximumTexels = texels;

    GLint blocks = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    if (blocks < STORAGE_BINDINGS)
    {
      result.MissingForStorage = "storage blocks in fragment shaders (" + std::to_string(STORAGE_BINDINGS) +
        " are needed, the driver has " + std::to_string(blocks) + ")";
    }
  }

  GLfloat points[2] = { 0, 0 };
  glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, points);
  if (result.MissingForStorage.empty() && points[1] < RESOLVE_SQUARE)
  {
    result.MissingForStorage =
      "points of " + std::to_string(RESOLVE_SQUARE) + " pixels (its largest have " + std::to_string(points[1]) + ")";
  }

  result.Software = result.Renderer.find("llvmpipe") != std::string::npos || StartsWith(result.Renderer, "softpipe");
  const bool any = AnyDrawOrder(); // asked in any case: what it is set to may be an error
  result.KeepsDrawOrder = IsRasterizer(result.Renderer) && !any;

  GLint kib[4] = { 0, 0, 0, 0 };
  if (extensions.count("GL_NVX_gpu_memory_info"))
  {
    glGetIntegerv(0x9048, kib); // GL_GPU_MEMORY_INFO_TOTAL_AVAILABLE_MEMORY_NVX
  }
  else if (extensions.count("GL_ATI_meminfo"))
  {
    glGetIntegerv(0x87FB, kib); // GL_VBO_FREE_MEMORY_ATI: free memory of the pool first
  }
  result.ReportedMemoryMiB = kib[0] / 1024.0;
  return result;
}

//------------------------------------------------------------------------------
double vtkTranslucencyCapabilities::GetLimitBytes(double mebibytes) const
{
  constexpr double MiB = 1024.0 * 1024.0;
  constexpr double Default = 2048;
  if (mebibytes > 0)
  {
    return mebibytes * MiB;
  }
  return (this->ReportedMemoryMiB > 0 ? this->ReportedMemoryMiB / 4 : Default) * MiB;
}
VTK_ABI_NAMESPACE_END
