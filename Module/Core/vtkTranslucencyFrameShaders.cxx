// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyFrameShaders.h"

#include "vtkFragmentStorage.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyResources.h"
#include "vtkTranslucencyStage.h"
#include "vtkTranslucencySurfaces.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int MostSamples = 8; // that a node has room for

const std::string Version = "//VTK::System::Dec\n";

// What goes into a mapper's shader where it has shaded a fragment; GATHERED_DEPTH stands for its depth, GATHERED_NORMAL
// for its normal.
std::string GatherCall(const vtkTranslucencyGathering& gathering, const vtkTranslucencyFrameShaders::Context& context)
{
  const int outputs = gathering.Outputs;
  const std::string normal = gathering.Normals ? ", GATHERED_NORMAL" : "";
  std::string call = "gatherFragment(gl_FragData[0], GATHERED_DEPTH" + normal + ");\n";
  if (outputs > 0)
  {
    call = "vec4 gatherOutputs[" + std::to_string(outputs) + "];\ngatherFragment(gl_FragData[0], GATHERED_DEPTH" +
      normal + ", gatherOutputs);\n";
  }
  if (context.TakesMean)
  {
    call = "gl_FragData[0] = meanTransmission(gl_FragData[0]);\n" + call;
  }
  if (context.ShadesSurfaces)
  {
    call = "gl_FragData[0] = shadeSurface(gl_FragData[0], GATHERED_NORMAL);\n" + call;
  }
  if (gathering.Critical)
  {
    call = "BEGIN_CRITICAL_SECTION\n" + call + "END_CRITICAL_SECTION\n";
  }
  for (int i = 0; i < outputs; ++i)
  {
    const std::string index = "[" + std::to_string(i) + "]";
    call += "gl_FragData" + index + " = gatherOutputs" + index + ";\n";
  }
  return call;
}

// A main function with a call, and what it writes: alone, the text has no declarations of what VTK's shaders write.
std::string Main(const std::string& call, int outputs, bool fetches)
{
  std::string main = "gl_FragData[0] = vec4(1.0); " + call;
  vtkShaderProgram::Substitute(main, "GATHERED_DEPTH", "0.5");
  vtkShaderProgram::Substitute(main, "GATHERED_NORMAL", "vec3(0.0)");
  std::string declarations;
  if (fetches)
  {
    main = vtkTranslucencyShader::FreeOutputs(main);
  }
  for (int i = 0; i < std::max(outputs, 1) && !fetches; ++i)
  {
    const std::string output = "fragOutput" + std::to_string(i);
    vtkShaderProgram::Substitute(main, "gl_FragData[" + std::to_string(i) + "]", output);
    declarations += "out vec4 " + output + ";\n";
  }
  return declarations + "void main() { " + main + " }\n";
}
}

//------------------------------------------------------------------------------
vtkTranslucencyFrameShaders::vtkTranslucencyFrameShaders(
  vtkTranslucencyResources& resources, vtkOpenGLRenderWindow* window, int criticalSection)
  : Resources(resources)
  , Window(window)
  , CriticalSection(criticalSection)
{
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrameShaders::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrameShaders::ChooseSamples(vtkObject* pass, bool storage)
{
  vtkTranslucencyResources& kept = this->Resources;
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  this->Current.TargetSamples = std::max(1, samples);
  std::string missing = kept.Capabilities.MissingForSamples;
  if (samples > MostSamples)
  {
    missing = "windows of at most " + std::to_string(MostSamples) + " samples";
  }
  if (samples <= 1 || !storage || missing.empty())
  {
    this->Current.Samples = this->Current.TargetSamples;
  }
  else if (kept.MissingForSamples != missing)
  {
    kept.MissingForSamples = missing;
    vtkWarningWithObjectMacro(
      pass, << "multi-sampled translucency needs " << missing << "; drawing it with one sample a pixel");
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrameShaders::ChooseTransmission(vtkTranslucencyPass* pass, const vtkRenderState* state)
{
  using Kind = vtkTranslucencyTransmission::Kind;
  vtkTranslucencyResources& kept = this->Resources;
  const std::string& lacking = kept.Capabilities.MissingForTransmission;
  const Kind kind = kept.Transmission.Choose(pass, state, lacking);
  this->Current.Absorbs = kept.Mappers->GetMedia().Choose(pass, state, lacking);
  this->Current.ShadesSurfaces = vtkTranslucencySurfaces::HasAny(state);
  this->Current.TakesMean = kind == Kind::Mean;
  this->Current.Channels = kind == Kind::Colored || this->Current.Absorbs ? 3 : 1;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyFrameShaders::GetCriticalSection() const
{
  const vtkTranslucencyCapabilities& capabilities = this->Resources.Capabilities;
  switch (this->CriticalSection)
  {
    case vtkTranslucencyPass::Interlock:
      return "Interlock";
    case vtkTranslucencyPass::Spinlock:
      return "Spinlock";
    case vtkTranslucencyPass::Unprotected:
      return "None";
    default:
      return capabilities.KeepsDrawOrder ? "None" : capabilities.Interlock.empty() ? "Spinlock" : "Interlock";
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyFrameShaders::Defines vtkTranslucencyFrameShaders::GetOfferedDefines() const
{
  const Context& context = this->Current;
  Defines offered;
  if (context.Storage)
  {
    offered = context.Storage->GetDefines();
  }
  offered["TRANSMITTANCE_CHANNELS"] = std::to_string(context.Channels);
  offered["SHADES_SURFACES"] = context.ShadesSurfaces ? "1" : "0";
  offered["MEDIA"] = context.Absorbs ? "1" : "0";
  offered["SAMPLES"] = std::to_string(context.Samples);
  offered["TARGET_SAMPLES"] = std::to_string(context.TargetSamples);
  offered["SHADES_SAMPLES"] = this->Resources.Capabilities.ShadesSamples ? "1" : "0";
  offered["RECORD_TARGETS"] = std::to_string(context.RecordTargets);
  offered["NODE_LINKS"] = std::to_string(static_cast<int>(vtkFragmentStorage::Links::None));
  offered["FRAGMENT_ORDER"] =
    this->Resources.Capabilities.KeepsDrawOrder ? "FRAGMENT_ORDER_DRAWN" : "FRAGMENT_ORDER_CONTENT";
  return offered;
}

//------------------------------------------------------------------------------
vtkTranslucencyShader::Selection vtkTranslucencyFrameShaders::GetSelection() const
{
  // Records in colours need no protection.
  vtkTranslucencyShader::Selection selection{ { "CriticalSection",
    this->Current.RecordTargets > 0 ? "None" : this->GetCriticalSection() } };
  if (this->Current.Storage)
  {
    selection["Storage"] = this->Current.Storage->GetShaderName();
  }
  return selection;
}

//------------------------------------------------------------------------------
// What a mapper's shader needs to change a fragment's colour before it is gathered; empty where it does not.
std::string vtkTranslucencyFrameShaders::GetColorText() const
{
  vtkTranslucencyShader shader;
  if (this->Current.TakesMean)
  {
    shader.Assemble("Common/MeanTransmission.glsl", {}, this->GetOfferedDefines());
  }
  else if (this->Current.ShadesSurfaces)
  {
    shader.Assemble("Surface/Shade.glsl", {});
  }
  return shader.GetText();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrameShaders::PrepareStoring()
{
  vtkTranslucencyMapperHook* mappers = this->Resources.Mappers;
  const std::string colors = this->GetColorText();
  Defines offered = this->GetOfferedDefines();
  offered.merge(this->Current.Storage->GetStoringDefines());
  const std::string key = vtkTranslucencyPrograms::GetKey(this->Current.Storage->GetShaderName(), {}, offered) + colors;
  if (key == mappers->GetKey())
  {
    return true;
  }
  vtkTranslucencyShader shader;
  if (!shader.Assemble("Common/Gather.glsl", {}, offered, this->GetSelection()) ||
    !shader.Validate("void main() { gatherFragment(vec4(1.0), 0.5); }\n"))
  {
    return this->Fail(shader.GetError());
  }
  vtkTranslucencyShader volumes; // compiled with the ray caster only: it declares what that one has
  offered["NODE_LINKS"] = std::to_string(static_cast<int>(vtkFragmentStorage::Links::Mixed));
  if (!volumes.Assemble("Common/GatherVolume.glsl", {}, offered, this->GetSelection()))
  {
    return this->Fail(volumes.GetError());
  }
  vtkTranslucencyMapperHook::GatherText text;
  text.Declarations = colors + shader.GetText();
  text.Call = GatherCall({}, this->Current);
  text.Stores = true;
  mappers->SetText(key, text);
  mappers->GetVolumes().SetGatherText(volumes.GetText());
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrameShaders::PrepareGathering(const vtkTranslucencyGathering& gathering)
{
  vtkTranslucencyMapperHook* mappers = this->Resources.Mappers;
  const std::string colors = this->GetColorText();
  const std::string key = vtkTranslucencyPrograms::GetKey(gathering.File, gathering.Values, this->GetOfferedDefines()) +
    vtkTranslucencyPrograms::GetKey("", this->GetSelection()) + colors;
  if (key == mappers->GetKey())
  {
    return true;
  }
  vtkTranslucencyMapperHook::GatherText text;
  text.Call = GatherCall(gathering, this->Current);
  text.Stores = gathering.Critical || gathering.Atomic;
  text.Fetches = gathering.Critical && this->Current.RecordTargets > 0;
  text.Rejects = gathering.Rejects;
  vtkTranslucencyShader shader;
  if (!shader.Assemble(gathering.File, gathering.Values, this->GetOfferedDefines(), this->GetSelection()) ||
    !shader.Validate(colors + Main(text.Call, gathering.Outputs, text.Fetches)))
  {
    return this->Fail(shader.GetError());
  }
  text.Declarations = colors + shader.GetText();
  mappers->SetText(key, text);
  return true;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyFrameShaders::PrepareProgram(
  const std::string& vertexFile, const std::string& file, const Defines& defines)
{
  const auto selection = this->GetSelection();
  Defines offered = this->GetOfferedDefines();
  if (this->Current.Storage)
  {
    offered["NODE_LINKS"] = std::to_string(static_cast<int>(this->Current.Storage->GetLinks()));
  }
  const std::string key =
    vtkTranslucencyPrograms::GetKey(file, defines, offered) + vtkTranslucencyPrograms::GetKey("", selection);
  this->Error = "shader " + file + " does not link";
  vtkTranslucencyShader fragment;
  vtkTranslucencyShader vertex;
  const auto check = [&](bool good) { return good || this->Fail(fragment.GetError() + vertex.GetError()); };
  return this->Resources.Programs.Ready(
    this->Window, key,
    [&](vtkTranslucencyPrograms::Source& source)
    {
      const std::string head = Version + std::string(vtkTranslucencyShader::GetExtensions());
      const bool ready = check(
        fragment.Assemble(file, defines, offered, selection) && vertex.Assemble(vertexFile, {}, offered, selection));
      source = { head + vertex.GetText(), head + fragment.GetText() };
      return ready;
    },
    [&] { return check(fragment.Validate("") && vertex.Validate("", vtkShader::Vertex)); });
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyFrameShaders::PrepareHandOver()
{
  vtkTranslucencyMapperHook* mappers = this->Resources.Mappers;
  const std::string file = "Common/HandOver.glsl";
  this->Error = "shader " + file + " does not link";
  return this->Resources.Programs.Ready(
    this->Window, file + mappers->GetKey(),
    [&](vtkTranslucencyPrograms::Source& source)
    {
      vtkTranslucencyShader fragment;
      vtkTranslucencyShader vertex;
      if (!fragment.Assemble(file, {}, this->GetOfferedDefines()) || !vertex.Assemble("Common/FullScreen.glsl", {}))
      {
        return this->Fail(fragment.GetError() + vertex.GetError());
      }
      source = { Version + vertex.GetText(), Version + fragment.GetText() };
      return mappers->Insert(source.Fragment, nullptr, file);
    },
    [] { return true; });
}
VTK_ABI_NAMESPACE_END
