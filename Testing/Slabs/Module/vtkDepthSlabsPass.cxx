// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthSlabsPass.h"

#include "vtkTranslucencyVTKVersion.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointGaussianMapper.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"
#include "vtkVolume.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDepthSlabsPass);

namespace
{
// A prop and between which distances along the view it lies: anywhere, if it does not say where.
struct Placed
{
  vtkProp* Prop;
  double Front = -VTK_DOUBLE_MAX;
  double Back = VTK_DOUBLE_MAX;
};

std::vector<Placed> Place(const vtkRenderState* s, vtkCamera* camera)
{
  double eye[3];
  double view[3];
  double range[2];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(view);
  camera->GetClippingRange(range);
  const double around =
    0.05 * (range[1] - range[0]); // some props draw more than their bounds: points have a size in pixels
  std::vector<Placed> all;
  for (int i = 0; i < vtkTranslucencyPropCount(s); ++i)
  {
    Placed one{ vtkTranslucencyProp(s, i) };
    const double* bounds = one.Prop->GetBounds();
    if (bounds && vtkMath::AreBoundsInitialized(bounds))
    {
      double center = 0;
      double reach = around;
      for (int axis = 0; axis < 3; ++axis)
      {
        center += (0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]) - eye[axis]) * view[axis];
        reach += 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]) * std::abs(view[axis]);
      }
      one.Front = center - reach;
      one.Back = center + reach;
    }
    all.push_back(one);
  }
  return all;
}

// What covers the viewport, by a fragment shader's text that reads textures at texCoord.
std::unique_ptr<vtkOpenGLQuadHelper> NewQuad(vtkOpenGLRenderWindow* window, const std::string& text)
{
  const std::string fragment = "//VTK::System::Dec\n//VTK::Output::Dec\nin vec2 texCoord;\n" + text;
  return std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment.c_str(), "");
}

// The window depth of a distance along the view.
float WindowDepth(vtkCamera* camera, double distance)
{
  double range[2];
  camera->GetClippingRange(range);
  const double part = (distance - range[0]) / (range[1] - range[0]);
  return static_cast<float>(camera->GetParallelProjection() ? part : part * range[1] / distance);
}
}

//------------------------------------------------------------------------------
vtkDepthSlabsPass::vtkDepthSlabsPass() = default;

//------------------------------------------------------------------------------
vtkDepthSlabsPass::~vtkDepthSlabsPass() = default;

//------------------------------------------------------------------------------
void vtkDepthSlabsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSlabs: " << this->NumberOfSlabs << "\n";
  os << indent << "FrontToBack: " << this->FrontToBack << "\n";
  os << indent << "Undivided: " << this->Undivided[0] << " " << this->Undivided[1] << "\n";
}

//------------------------------------------------------------------------------
void vtkDepthSlabsPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Surfaces->ReleaseGraphicsResources(window);
  this->Volumes->ReleaseGraphicsResources(window);
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  this->OpaqueDepth->ReleaseGraphicsResources(window);
  this->Hiding.reset();
  this->Quad.reset();
}

//------------------------------------------------------------------------------
void vtkDepthSlabsPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = s->GetRenderer();
  auto window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->State = window->GetState();
  int area[4];
  renderer->GetTiledSizeAndOrigin(&area[2], &area[3], &area[0], &area[1]);
  if (s->GetFrameBuffer())
  {
    s->GetWindowSize(area + 2);
    area[0] = area[1] = 0;
  }
  const vtkOpenGLState::ScopedglViewport viewport(this->State);
  const vtkOpenGLState::ScopedglScissor scissor(this->State);
  const vtkOpenGLState::ScopedglBlendFuncSeparate blending(this->State);
  this->Begin(window, area);
  this->PreRender(s);
  vtkCamera* camera = renderer->GetActiveCamera();
  const std::vector<double> borders = this->GetBorders(camera);
  const std::vector<Placed> all = Place(s, camera);
  const std::size_t slabs = borders.size() - 1;
  for (std::size_t i = 0; i < slabs; ++i)
  {
    const std::size_t slab = this->FrontToBack ? i : slabs - 1 - i;
    this->Slab[0] = slab == 0 ? -1.0f : WindowDepth(camera, borders[slab]);
    this->Slab[1] = slab == slabs - 1 ? 2.0f : WindowDepth(camera, borders[slab + 1]);
    std::vector<vtkProp*> props;
    for (const Placed& one : all)
    {
      if (one.Front <= borders[slab + 1] && one.Back >= borders[slab])
      {
        props.push_back(one.Prop);
      }
    }
    if (props.empty())
    {
      continue;
    }
    vtkRenderState some(renderer);
    vtkTranslucencySetProps(some, props, s);
    this->HideBehind(window, this->Slab[1]);
    this->Surfaces->Render(&some);
    if (std::any_of(props.begin(), props.end(), [](vtkProp* prop) { return vtkVolume::SafeDownCast(prop) != nullptr; }))
    {
      this->HideBehind(window, 1); // a ray ends where something hides it
    }
    this->Volumes->Render(&some);
  }
  this->NumberOfRenderedProps = this->Surfaces->GetNumberOfRenderedProps() + this->Volumes->GetNumberOfRenderedProps();
  this->PostRender(s);
  this->End(window, area);
}

//------------------------------------------------------------------------------
// Distances along the view, from the nearest to the farthest.
std::vector<double> vtkDepthSlabsPass::GetBorders(vtkCamera* camera) const
{
  double range[2];
  camera->GetClippingRange(range);
  std::vector<double> borders{ -VTK_DOUBLE_MAX };
  for (int border = 1; border < this->NumberOfSlabs; ++border)
  {
    const double golden = (std::sqrt(5.0) - 1) / 2; // no face that lies at a round depth lies between two slabs
    const double distance = range[0] + (range[1] - range[0]) * (border - 1 + golden) / (this->NumberOfSlabs - 1);
    if (distance <= this->Undivided[0] || distance >= this->Undivided[1])
    {
      borders.push_back(distance);
    }
  }
  borders.push_back(VTK_DOUBLE_MAX);
  return borders;
}

//------------------------------------------------------------------------------
// Binds the empty sums, with the depth of what is opaque.
void vtkDepthSlabsPass::Begin(vtkOpenGLRenderWindow* window, const int area[4])
{
  if (!this->Framebuffer)
  {
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
    this->State->PushFramebufferBindings();
    const int depthBits = 32; // the ray caster copies the depth into the like
    this->Framebuffer->PopulateFramebuffer(area[2], area[3], true, 1, VTK_FLOAT, true, depthBits, 0);
    this->State->PopFramebufferBindings();
  }
  this->Framebuffer->Resize(area[2], area[3]);
  if (this->OpaqueDepth->GetWidth() != static_cast<unsigned int>(area[2]) ||
    this->OpaqueDepth->GetHeight() != static_cast<unsigned int>(area[3]))
  {
    this->OpaqueDepth->SetContext(window);
    this->OpaqueDepth->AllocateDepth(area[2], area[3], vtkTextureObject::Float32);
  }
  this->OpaqueDepth->CopyFromFrameBuffer(area[0], area[1], 0, 0, area[2], area[3]);
  this->State->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->State->vtkglViewport(0, 0, area[2], area[3]);
  this->State->vtkglScissor(0, 0, area[2], area[3]);
  this->State->vtkglClearColor(0, 0, 0, 0);
  this->State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->State->vtkglClear(GL_COLOR_BUFFER_BIT);
  this->State->vtkglEnable(GL_BLEND);
}

//------------------------------------------------------------------------------
// Gives the depth of what is opaque, or this one where it is nearer: what lies behind a slab fails the depth test,
// which is half of all fragments, and would take the time of the shader that leaves it out.
void vtkDepthSlabsPass::HideBehind(vtkOpenGLRenderWindow* window, float depth)
{
  const vtkOpenGLState::ScopedglEnableDisable test(this->State, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglDepthMask mask(this->State);
  const vtkOpenGLState::ScopedglDepthFunc function(this->State);
  const vtkOpenGLState::ScopedglColorMask colors(this->State);
  this->State->vtkglEnable(GL_DEPTH_TEST);
  this->State->vtkglDepthMask(GL_TRUE);
  this->State->vtkglDepthFunc(GL_ALWAYS);
  this->State->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  if (!this->Hiding)
  {
    this->Hiding = NewQuad(window,
      "uniform sampler2D opaqueDepth;\n"
      "uniform float hiding;\n"
      "void main() { gl_FragDepth = min(texture2D(opaqueDepth, texCoord).r, hiding); }\n");
  }
  window->GetShaderCache()->ReadyShaderProgram(this->Hiding->Program);
  this->OpaqueDepth->Activate();
  this->Hiding->Program->SetUniformi("opaqueDepth", this->OpaqueDepth->GetTextureUnit());
  this->Hiding->Program->SetUniformf("hiding", depth);
  this->Hiding->Render();
  this->OpaqueDepth->Deactivate();
}

//------------------------------------------------------------------------------
// Blends the sums over what is opaque.
void vtkDepthSlabsPass::End(vtkOpenGLRenderWindow* window, const int area[4])
{
  this->State->PopFramebufferBindings();
  this->State->vtkglViewport(area[0], area[1], area[2], area[3]);
  this->State->vtkglScissor(area[0], area[1], area[2], area[3]);
  this->State->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const vtkOpenGLState::ScopedglEnableDisable test(this->State, GL_DEPTH_TEST);
  this->State->vtkglDisable(GL_DEPTH_TEST);
  if (!this->Quad)
  {
    this->Quad = NewQuad(window,
      "uniform sampler2D slabs;\n"
      "void main() { gl_FragData[0] = texture2D(slabs, texCoord); }\n");
  }
  window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  vtkTextureObject* sums = this->Framebuffer->GetColorAttachmentAsTextureObject(0);
  sums->Activate();
  this->Quad->Program->SetUniformi("slabs", sums->GetTextureUnit());
  this->Quad->Render();
  sums->Deactivate();
}

//------------------------------------------------------------------------------
// Before the ray caster's own text takes the place of its tags.
bool vtkDepthSlabsPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (vtkVolume::SafeDownCast(prop))
  {
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Dec",
      "vec4 WindowToNDC(const float xCoord, const float yCoord, const float zCoord);\n"
      "uniform vec2 slab;\n"
      "float slabEnd; // the number of the ray's first sample behind the slab\n"
      "float slabSample; // the number of the next one\n"
      "float slabSamplesTo(float depth, vec3 first, vec3 step)\n"
      "{\n"
      "  vec4 point = ip_inverseTextureDataAdjusted * in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix * "
      "in_inverseProjectionMatrix *\n"
      "    WindowToNDC(gl_FragCoord.x, gl_FragCoord.y, depth);\n"
      "  return dot(point.xyz / point.w - first, step) / dot(step, step);\n"
      "}\n");
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Ray::Init",
      "slabEnd = slab.y > 1.0 ? 1.0e9 : slabSamplesTo(slab.y, g_dataPos, g_dirStep);\n"
      "  slabSample = slab.x < 0.0 ? 0.0 : max(0.0, ceil(slabSamplesTo(slab.x, g_dataPos, g_dirStep)));\n"
      "  g_dataPos += slabSample * g_dirStep;\n"
      "  g_currentT += slabSample;\n"
      "  g_exit = slabSample > 0.0 && (slabSample > g_terminatePointMax + 1.0 ||\n"
      "    any(lessThan(g_dataPos, in_texMin[0])) || any(greaterThan(g_dataPos, in_texMax[0])));\n");
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::PreComputeGradients::Impl",
      "if (slabSample >= slabEnd) { break; }\n"
      "    slabSample += 1.0;\n"
      "    //VTK::PreComputeGradients::Impl");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkDepthSlabsPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (!vtkVolume::SafeDownCast(prop))
  {
    static const std::regex assignment("gl_FragDepth\\s*=[^=]");
    const bool setsDepth = std::regex_search(fragmentShader, assignment);
    const std::string depth = setsDepth ? "gl_FragDepth" : "gl_FragCoord.z";
    const std::string reject = "if (" + depth + " < slab.x || " + depth + " >= slab.y) { discard; }\n";
    vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::DepthPeeling::Dec", "uniform vec2 slab;\nuniform float slabHides;\n");
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::PreColor", setsDepth ? "" : reject);
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Impl",
      (setsDepth ? reject : "") + "gl_FragData[0] *= vec4(vec3(gl_FragData[0].a), slabHides);\n");
  }
  return true;
}

//------------------------------------------------------------------------------
// Mappers call this when they have set the state in which they want to draw.
bool vtkDepthSlabsPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* splats = actor ? vtkPointGaussianMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  program->SetUniformf("slabHides", splats && splats->GetEmissive() ? 0.0f : 1.0f); // VTK adds such splats
  program->SetUniform2f("slab", this->Slab);
  this->State->vtkglDepthMask(GL_FALSE); // image slices would hide what lies in slabs behind
  if (this->FrontToBack)
  {
    this->State->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
  else
  {
    this->State->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  return true;
}
