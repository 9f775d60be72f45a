// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyVolumes.h"

#include "vtkTranslucencyBuffer.h"
#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyShader.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// The mappers whose shader is that of vtkGPUVolumeRayCastMapper, by name: they are in modules that need not be there.
bool CastsRaysByShader(vtkProp* prop)
{
  auto* volume = vtkVolume::SafeDownCast(prop);
  vtkAbstractVolumeMapper* mapper = volume ? volume->GetMapper() : nullptr;
  return mapper &&
    (mapper->IsA("vtkGPUVolumeRayCastMapper") || mapper->IsA("vtkSmartVolumeMapper") ||
      mapper->IsA("vtkMultiBlockVolumeMapper"));
}
}

//------------------------------------------------------------------------------
void vtkTranslucencyVolumes::Find(const vtkRenderState* state, vtkRenderPass* pass, bool divided)
{
  this->Pass = pass;
  this->Props.clear();
  this->Others.clear();
  for (int i = 0; pass && i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    (divided && CastsRaysByShader(prop) ? this->Props : this->Others).push_back(prop);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyVolumes::Gather(const vtkRenderState* one, int rounds)
{
  this->Framebuffer = vtkTranslucencyGLState::GetDrawFramebuffer();
  this->Gathered = false;
  for (this->Round = 0; this->Round < rounds && (this->Round == 0 || this->Gathered); ++this->Round)
  {
    this->Pass->Render(one);
  }
  vtkProp* prop = vtkTranslucencyProp(one, 0);
  const bool known = std::find(this->Others.begin(), this->Others.end(), prop) != this->Others.end();
  if (!this->Gathered && this->Pass->GetNumberOfRenderedProps() > 0 && !known)
  {
    this->Others.push_back(prop);
  }
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyVolumes::DrawUndivided(const vtkRenderState* state)
{
  if (this->Others.empty())
  {
    return "";
  }
  vtkRenderState others(state->GetRenderer());
  vtkTranslucencySetProps(others, this->Others, state);
  this->Pass->Render(&others);
  if (this->Pass->GetNumberOfRenderedProps() == 0)
  {
    return "";
  }
  std::string drawn;
  for (vtkProp* prop : this->Others)
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (volume && volume->GetMapper())
    {
      drawn += (drawn.empty() ? "" : ", ") + std::string(volume->GetMapper()->GetClassName());
    }
  }
  return drawn.empty() ? "assemblies" : drawn;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyVolumes::IsRayCaster(vtkAbstractMapper* mapper)
{
  return vtkAbstractVolumeMapper::SafeDownCast(mapper) != nullptr;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyVolumes::PreReplaceShaderValues(
  std::string& fragmentShader, const std::string& who, std::string& error) const
{
  // Segments are started first: where no list is read before VTK's loop over clipping planes,
  // lavapipe's code crashes (Documentation/Drivers.md). The second line of the loop is what the ray
  // caster does to a whole ray's colour in the end.
  const std::string worker = "startSegments();\n"
                             "initializeRayCast();\n"
                             "SET_RAY_END();\n"
                             "float front;\n"
                             "float back;\n"
                             "while (nextSegment(front, back))\n"
                             "{\n"
                             "  vec4 color = castRay(front, back);\n"
                             "  color.rgb = color.rgb * in_scale + in_bias * color.a;\n"
                             "  storeSegment(color);\n"
                             "}\n"
                             "gl_FragData[0] = vec4(0.0);\n";
  return vtkTranslucencyShader::Substitute(fragmentShader, "//VTK::CallWorker::Impl", worker, who, error);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyVolumes::PostReplaceShaderValues(
  std::string& fragmentShader, const std::string& who, std::string& error) const
{
  const auto declares = [&fragmentShader](const char* name)
  { return std::string(fragmentShader.find(name) != std::string::npos ? "1\n" : "0\n"); };
  const std::string declarations = "#define RAY_FINDS_VALUES " + declares("uniform float in_isosurfacesValues") +
    "#define RAY_MEETS_PLANE " + declares("uniform vec3 in_slicePlaneOrigin") + this->GatherText;
  const std::string system = "//VTK::System::Dec\n" + std::string(vtkTranslucencyShader::GetExtensions());
  const std::string start = "if (!START_RAY(zStart, zEnd)) { return vec4(0.0); }\n";
  using Shader = vtkTranslucencyShader;
  return Shader::Substitute(fragmentShader, "//VTK::System::Dec", system, who, error) &&
    Shader::Substitute(fragmentShader, "//VTK::DepthPeeling::Dec", declarations, who, error) &&
    Shader::Substitute(fragmentShader, "//VTK::DepthPeeling::Ray::Init", start, who, error);
}

//------------------------------------------------------------------------------
void vtkTranslucencyVolumes::SetShaderParameters(vtkShaderProgram* program)
{
  this->Gathered = vtkTranslucencyGLState::GetDrawFramebuffer() == this->Framebuffer;
  program->SetUniformi("gathersVolume", this->Gathered ? 1 : 0);
  vtkTranslucencyShader::SetUniforms(program, { { "gatherRound", this->Round } });
  vtkTranslucencyBuffer::FinishStores(); // a block, volume or round before has changed the same lists
}
VTK_ABI_NAMESPACE_END
