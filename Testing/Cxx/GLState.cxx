// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLState.h"

#include "vtkTranslucencyVTKVersion.h"

#include <vtkNew.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStringOutputWindow.h>

#include <sstream>

namespace
{
struct Query
{
  const char* Name;
  unsigned int Value;
  int Count;
};

#define QUERY(name, count)                                                                                             \
  {                                                                                                                    \
#name, name, count                                                                                                 \
  }

const Query Queries[] = { QUERY(GL_VIEWPORT, 4), QUERY(GL_SCISSOR_BOX, 4), QUERY(GL_SCISSOR_TEST, 1),
  QUERY(GL_BLEND, 1), QUERY(GL_BLEND_SRC_RGB, 1), QUERY(GL_BLEND_SRC_ALPHA, 1), QUERY(GL_BLEND_DST_RGB, 1),
  QUERY(GL_BLEND_DST_ALPHA, 1), QUERY(GL_BLEND_EQUATION_RGB, 1), QUERY(GL_BLEND_EQUATION_ALPHA, 1),
  QUERY(GL_BLEND_COLOR, 4), QUERY(GL_COLOR_WRITEMASK, 4), QUERY(GL_COLOR_CLEAR_VALUE, 4), QUERY(GL_COLOR_LOGIC_OP, 1),
  QUERY(GL_DITHER, 1), QUERY(GL_DEPTH_TEST, 1), QUERY(GL_DEPTH_WRITEMASK, 1), QUERY(GL_DEPTH_FUNC, 1),
  QUERY(GL_DEPTH_RANGE, 2), QUERY(GL_DEPTH_CLEAR_VALUE, 1), QUERY(GL_DEPTH_CLAMP, 1), QUERY(GL_STENCIL_TEST, 1),
  QUERY(GL_STENCIL_FUNC, 1), QUERY(GL_STENCIL_REF, 1), QUERY(GL_STENCIL_VALUE_MASK, 1), QUERY(GL_STENCIL_WRITEMASK, 1),
  QUERY(GL_STENCIL_FAIL, 1), QUERY(GL_STENCIL_PASS_DEPTH_FAIL, 1), QUERY(GL_STENCIL_PASS_DEPTH_PASS, 1),
  QUERY(GL_STENCIL_BACK_FUNC, 1), QUERY(GL_STENCIL_BACK_REF, 1), QUERY(GL_STENCIL_BACK_WRITEMASK, 1),
  QUERY(GL_STENCIL_BACK_FAIL, 1), QUERY(GL_STENCIL_BACK_PASS_DEPTH_PASS, 1), QUERY(GL_CULL_FACE, 1),
  QUERY(GL_CULL_FACE_MODE, 1), QUERY(GL_FRONT_FACE, 1), QUERY(GL_POLYGON_MODE, 2), QUERY(GL_POLYGON_OFFSET_FILL, 1),
  QUERY(GL_POLYGON_OFFSET_FACTOR, 1), QUERY(GL_POLYGON_OFFSET_UNITS, 1), QUERY(GL_LINE_WIDTH, 1),
  QUERY(GL_POINT_SIZE, 1), QUERY(GL_PROGRAM_POINT_SIZE, 1), QUERY(GL_PRIMITIVE_RESTART, 1),
  QUERY(GL_RASTERIZER_DISCARD, 1), QUERY(GL_MULTISAMPLE, 1), QUERY(GL_SAMPLE_MASK, 1),
  QUERY(GL_SAMPLE_ALPHA_TO_COVERAGE, 1), QUERY(GL_SAMPLE_COVERAGE, 1), QUERY(GL_FRAMEBUFFER_SRGB, 1),
  QUERY(GL_CLIP_DISTANCE0, 1), QUERY(GL_CURRENT_PROGRAM, 1), QUERY(GL_VERTEX_ARRAY_BINDING, 1),
  QUERY(GL_ARRAY_BUFFER_BINDING, 1), QUERY(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1), QUERY(GL_UNIFORM_BUFFER_BINDING, 1),
  QUERY(GL_SHADER_STORAGE_BUFFER_BINDING, 1), QUERY(GL_ATOMIC_COUNTER_BUFFER_BINDING, 1),
  QUERY(GL_COPY_READ_BUFFER_BINDING, 1), QUERY(GL_COPY_WRITE_BUFFER_BINDING, 1),
  QUERY(GL_DRAW_INDIRECT_BUFFER_BINDING, 1), QUERY(GL_PIXEL_PACK_BUFFER_BINDING, 1),
  QUERY(GL_PIXEL_UNPACK_BUFFER_BINDING, 1), QUERY(GL_PACK_ALIGNMENT, 1), QUERY(GL_UNPACK_ALIGNMENT, 1),
  QUERY(GL_DRAW_FRAMEBUFFER_BINDING, 1), QUERY(GL_READ_FRAMEBUFFER_BINDING, 1), QUERY(GL_RENDERBUFFER_BINDING, 1),
  QUERY(GL_DRAW_BUFFER0, 1), QUERY(GL_DRAW_BUFFER1, 1), QUERY(GL_READ_BUFFER, 1), QUERY(GL_ACTIVE_TEXTURE, 1) };

constexpr unsigned int Indices = 8; // of indexed bindings that are looked at
constexpr unsigned int TextureUnits = 16;

std::string Indexed(const std::string& name, unsigned int index)
{
  return name + "[" + std::to_string(index) + "]";
}

void QueryIndexedBuffers(GLState& state)
{
  const std::pair<const char*, unsigned int> bindings[] = {
    { "GL_SHADER_STORAGE_BUFFER_BINDING", GL_SHADER_STORAGE_BUFFER_BINDING },
    { "GL_SHADER_STORAGE_BUFFER_START", GL_SHADER_STORAGE_BUFFER_START },
    { "GL_SHADER_STORAGE_BUFFER_SIZE", GL_SHADER_STORAGE_BUFFER_SIZE },
    { "GL_UNIFORM_BUFFER_BINDING", GL_UNIFORM_BUFFER_BINDING },
    { "GL_UNIFORM_BUFFER_START", GL_UNIFORM_BUFFER_START },
    { "GL_UNIFORM_BUFFER_SIZE", GL_UNIFORM_BUFFER_SIZE },
    { "GL_IMAGE_BINDING_NAME", GL_IMAGE_BINDING_NAME },
  };
  for (const auto& binding : bindings)
  {
    for (unsigned int index = 0; index < Indices; ++index)
    {
      GLint64 value = 0;
      glGetInteger64i_v(binding.second, index, &value);
      state[Indexed(binding.first, index)] = { static_cast<double>(value) };
    }
  }
}

void QueryTextures(GLState& state)
{
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (unsigned int unit = 0; unit < TextureUnits; ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const Query& query : { Query QUERY(GL_TEXTURE_BINDING_1D, 1), Query QUERY(GL_TEXTURE_BINDING_2D, 1),
           Query QUERY(GL_TEXTURE_BINDING_2D_MULTISAMPLE, 1), Query QUERY(GL_TEXTURE_BINDING_BUFFER, 1),
           Query QUERY(GL_SAMPLER_BINDING, 1) })
    {
      GLint value = 0;
      glGetIntegerv(query.Value, &value);
      state[Indexed(query.Name, unit)] = { static_cast<double>(value) };
    }
  }
  glActiveTexture(static_cast<GLenum>(active));
}
}

//------------------------------------------------------------------------------
GLState QueryGLState()
{
  GLState state;
  for (const Query& query : Queries)
  {
    double values[4] = { 0, 0, 0, 0 };
    glGetDoublev(query.Value, values);
    state[query.Name].assign(values, values + query.Count);
  }
  QueryIndexedBuffers(state);
  QueryTextures(state);
  return state;
}

//------------------------------------------------------------------------------
std::vector<std::string> TakeGLErrors()
{
  std::vector<std::string> errors;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
  {
    std::ostringstream text;
    text << "GL error 0x" << std::hex << error;
    errors.push_back(text.str());
  }
  return errors;
}

//------------------------------------------------------------------------------
bool IsZink()
{
  const std::string driver = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return driver.rfind("zink", 0) == 0;
}

namespace
{
// Whether VTK says something of a window of several samples that it draws by its own passes with FXAA.
bool FXAAHasErrors(int samples)
{
  const vtkSmartPointer<vtkOutputWindow> shown = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> said;
  vtkOutputWindow::SetInstance(said);
  {
    vtkNew<vtkRenderWindow> window;
    window->OffScreenRenderingOn();
    window->SetMultiSamples(samples);
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkOpenGLFXAAPass> pass;
    pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    renderer->SetPass(pass);
    window->AddRenderer(renderer);
    window->Render();
  }
  vtkOutputWindow::SetInstance(shown);
  return !said->GetOutput().empty();
}
}

//------------------------------------------------------------------------------
bool VTKFailsIn(const std::string& effect, vtkRenderWindow* window)
{
  if (window->GetMultiSamples() == 0 || effect.find("FXAA") == std::string::npos)
  {
    return false;
  }
  window->Render();
  if (IsZink())
  {
    return true;
  }
  static const bool fails = FXAAHasErrors(window->GetMultiSamples());
  window->MakeCurrent();
  return fails;
}
