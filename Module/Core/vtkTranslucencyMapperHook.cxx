// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyMapperHook.h"

#include "vtkTranslucencyBackground.h"
#include "vtkTranslucencyPass.h" // for transmission colours
#include "vtkTranslucencySurfaces.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtksys/RegularExpression.hxx"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTranslucencyMapperHook);

namespace
{
// Draws these faces only, of them those that the actor's own culling leaves: set when the actor is about to be drawn,
// after its property.
void CullFaces(vtkOpenGLState* state, vtkTranslucencyStage::Faces drawn, vtkProp* prop)
{
  if (drawn == vtkTranslucencyStage::Faces::All)
  {
    return;
  }
  const bool back = drawn == vtkTranslucencyStage::Faces::Back;
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool hidden =
    actor && (back ? actor->GetProperty()->GetBackfaceCulling() : actor->GetProperty()->GetFrontfaceCulling());
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(hidden ? GL_FRONT_AND_BACK : back ? GL_FRONT : GL_BACK);
}

// True if a fragment shader gives its fragments a depth of its own.
bool SetsDepth(const std::string& fragmentShader)
{
  return vtksys::RegularExpression("gl_FragDepth[ \t\r\n]*=[^=]").find(fragmentShader);
}
}

//------------------------------------------------------------------------------
void vtkTranslucencyMapperHook::SetText(const std::string& key, const GatherText& text)
{
  this->Key = key;
  this->Text = text;
  this->TextTime.Modified();
}

//------------------------------------------------------------------------------
void vtkTranslucencyMapperHook::BeginFrame(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport)
{
  this->Window = window;
  this->OpaqueDepth.BeginFrame(window, viewport);
}

//------------------------------------------------------------------------------
void vtkTranslucencyMapperHook::Draw(const vtkRenderState* state, vtkRenderPass* pass)
{
  this->Draw(state, [state, pass] { pass->Render(state); });
}

//------------------------------------------------------------------------------
void vtkTranslucencyMapperHook::Draw(const vtkRenderState* state, const std::function<void()>& draw)
{
  this->PreRender(state);
  this->Draws = true;
  draw();
  this->Draws = false;
  this->PostRender(state);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMapperHook::Insert(std::string& fragmentShader, vtkProp* prop, const std::string& who) const
{
  const bool setsDepth = SetsDepth(fragmentShader);
  std::string system = "//VTK::System::Dec\n" + std::string(vtkTranslucencyShader::GetExtensions());
  std::string declarations = this->Text.Declarations;
  const bool tests = setsDepth && this->Text.Stores;
  if (tests)
  {
    vtkTranslucencyShader test;
    test.Assemble("Common/OpaqueDepth.glsl", {});
    declarations += test.GetText();
  }
  else if (this->Text.Stores)
  {
    system += "layout(early_fragment_tests) in;\n#ifdef GL_ARB_post_depth_coverage\n"
              "layout(post_depth_coverage) in;\n#endif\n"; // the samples that pass the test
  }
  const std::string depth = setsDepth ? "gl_FragDepth" : "gl_FragCoord.z";
  std::string call = this->Text.Call;
  vtkShaderProgram::Substitute(call, "GATHERED_DEPTH", depth);
  if (call.find("GATHERED_NORMAL") != std::string::npos)
  {
    vtkShaderProgram::Substitute(call, "GATHERED_NORMAL", vtkTranslucencySurfaces::FindNormal(fragmentShader, prop));
  }
  const std::string reject = std::string(tests ? "if (behindOpaque(gl_FragDepth)) { discard; }\n" : "") +
    (this->Text.Rejects ? "if (rejectsFragment(" + depth + ")) { discard; }\n" : "");

  std::string text = fragmentShader;
  std::string error;
  using Shader = vtkTranslucencyShader;
  if (!Shader::Substitute(text, "//VTK::System::Dec", system, who, error) ||
    !Shader::Substitute(text, "//VTK::DepthPeeling::Dec", declarations, who, error) ||
    !Shader::Substitute(text, "//VTK::DepthPeeling::Impl", call, who, error) ||
    !(reject.empty() || Shader::Substitute(text, "//VTK::DepthPeeling::PreColor", reject, who, error)))
  {
    return false;
  }
  fragmentShader = Shader::LeaveAtDiscards(this->Text.Fetches ? Shader::FreeOutputs(text) : text);
  return true;
}

//------------------------------------------------------------------------------
int vtkTranslucencyMapperHook::TakeShaderBuilds()
{
  const int builds = this->ShaderBuilds;
  this->ShaderBuilds = 0;
  return builds;
}

//------------------------------------------------------------------------------
void vtkTranslucencyMapperHook::Release()
{
  this->Key.clear();
  this->Text = {};
  this->OpaqueDepth.Release();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMapperHook::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (!this->Draws || !vtkTranslucencyVolumes::IsRayCaster(mapper))
  {
    return true;
  }
  ++this->ShaderBuilds;
  return this->Volumes.PreReplaceShaderValues(fragmentShader, mapper->GetClassName(), this->Error);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMapperHook::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (!this->Draws)
  {
    return true;
  }
  if (vtkTranslucencyVolumes::IsRayCaster(mapper))
  {
    return this->Volumes.PostReplaceShaderValues(fragmentShader, mapper->GetClassName(), this->Error);
  }
  ++this->ShaderBuilds;
  this->Insert(fragmentShader, prop, mapper->GetClassName()); // what it can't be put into is met when it is drawn by
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMapperHook::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (!this->Draws)
  {
    return true;
  }
  if (vtkTranslucencyVolumes::IsRayCaster(mapper))
  {
    this->Volumes.SetShaderParameters(program);
    vtkTranslucencyShader::SetUniforms(program, this->FrameValues);
    return true;
  }
  return this->SetParameters(program, prop);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyMapperHook::SetParameters(vtkShaderProgram* program, vtkProp* prop)
{
  vtkOpenGLState* state = this->Window->GetState();
  // vtkOpenGLImageSliceMapper turns it on and, like the mappers of points and edges, leaves it on.
  state->vtkglDepthMask(this->Current.WritesDepth ? GL_TRUE : GL_FALSE);
  this->Current.KeepBlending(); // vtkPointGaussianMapper has set its own, if it is emissive
  CullFaces(state, this->Current.Faces, prop);
  vtkTranslucencyShader::SetUniforms(program, this->FrameValues);
  vtkTranslucencyShader::SetUniforms(program, this->Current.Values);
  if (program->IsUniformUsed("gatherTransmission"))
  {
    double color[3];
    vtkTranslucencyPass::GetTransmissionColor(prop, color);
    vtkTranslucencySurfaces::Disperse(prop, color);
    program->SetUniform3f("gatherTransmission", color);
  }
  vtkTranslucencyShader::SetUniforms(program, vtkTranslucencyBackground::GetUniforms(prop));
  vtkTranslucencyShader::SetUniforms(program, vtkTranslucencySurfaces::GetUniforms(prop));
  vtkTranslucencyShader::SetUniforms(program, { { "gatherMedium", this->Media.GetNumber(prop) } });
  const char* sampler = "translucencyOpaqueDepth";
  if (!program->IsUniformUsed(sampler))
  {
    return true;
  }
  if (!this->OpaqueDepth.IsCaptured() && !this->OpaqueDepth.Capture())
  {
    this->Error = "the depth buffer can't be copied";
    return false;
  }
  program->SetUniformi(sampler, this->OpaqueDepth.GetUnit());
  return true;
}
VTK_ABI_NAMESPACE_END
