#include "vtkTranslucencyFrame.h"

#include "Common/Bindings.glsl"
#include "vtkFragmentStorage.h"
#include "vtkTranslucencyFingerprint.h"
#include "vtkTranslucencyGLState.h"
#include "vtkTranslucencyInternals.h"
#include "vtkTranslucencyPixels.h"
#include "vtkTranslucencyQuery.h"
#include "vtkTranslucencyShader.h"
#include "vtkTranslucencyTargets.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <chrono>
#include <regex>

// Adds a scope's time to a sum, if asked to. Waits for the GPU at both ends: timer queries are not kept in order with the
// drawing by every driver.
class vtkTranslucencyFrame::ScopedTimer
{
public:
  ScopedTimer(bool wanted, double& milliseconds)
    : Milliseconds(wanted ? &milliseconds : nullptr)
  {
    if (this->Milliseconds)
    {
      glFinish();
      this->Start = Clock::now();
    }
  }
  ~ScopedTimer()
  {
    if (this->Milliseconds)
    {
      glFinish();
      const std::chrono::duration<double, std::milli> passed = Clock::now() - this->Start;
      *this->Milliseconds = std::max(0.0, *this->Milliseconds) + passed.count();
    }
  }
  ScopedTimer(const ScopedTimer&) = delete;
  ScopedTimer& operator=(const ScopedTimer&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double* Milliseconds;
  Clock::time_point Start;
};

// Binds what a shader reads to texture units of its own, and puts back what was bound there.
class vtkTranslucencyFrame::ScopedTextures
{
public:
  explicit ScopedTextures(vtkOpenGLRenderWindow* window, const std::vector<Input>& inputs = {})
    : Window(window)
  {
    for (const Input& input : inputs)
    {
      this->Bind(input.Sampler, input.From->GetTarget(), input.From->GetTexture(input.Index));
    }
  }
  ~ScopedTextures()
  {
    for (const Bound& bound : this->Textures)
    {
      this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + bound.Unit));
      glBindTexture(bound.Target, static_cast<GLuint>(bound.Before));
      this->Window->GetTextureUnitManager()->Free(bound.Unit);
    }
  }
  ScopedTextures(const ScopedTextures&) = delete;
  ScopedTextures& operator=(const ScopedTextures&) = delete;

  /// Binds a texture of one of the two kinds of GetTarget().
  void Bind(const std::string& sampler, unsigned int target, unsigned int texture)
  {
    const bool several = target == GL_TEXTURE_2D_MULTISAMPLE;
    this->UseUnit(sampler, target, several ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D);
    glBindTexture(target, texture);
  }

  /// Binds what a storage offers and a program fetches.
  void BindTexels(vtkFragmentStorage* storage, vtkShaderProgram* program)
  {
    for (const vtkFragmentStorage::Texels& texels : storage->GetTexels())
    {
      this->BindTexels(texels, program);
    }
  }

  void BindTexels(const vtkFragmentStorage::Texels& texels, vtkShaderProgram* program)
  {
    if (program->IsUniformUsed(texels.Sampler))
    {
      this->UseUnit(texels.Sampler, GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER);
      texels.Buffer->BindTexels(texels.Words);
    }
  }

  /// By the names of the samplers.
  const Uniforms& GetUnits() const { return this->Units; }

private:
  struct Bound
  {
    int Unit;
    unsigned int Target;
    int Before;
  };

  // Makes a unit active that nobody else uses.
  void UseUnit(const std::string& sampler, unsigned int target, unsigned int binding)
  {
    Bound bound{ this->Window->GetTextureUnitManager()->Allocate(), target, 0 };
    this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + bound.Unit));
    glGetIntegerv(binding, &bound.Before);
    this->Textures.push_back(bound);
    this->Units[sampler] = bound.Unit;
  }

  vtkOpenGLRenderWindow* Window;
  std::vector<Bound> Textures;
  Uniforms Units;
};

// Makes a stage's targets what is drawn to, and clears them.
class vtkTranslucencyFrame::ScopedTargets
{
public:
  ScopedTargets(vtkOpenGLRenderWindow* window, const Stage& stage);
  ~ScopedTargets();
  ScopedTargets(const ScopedTargets&) = delete;
  ScopedTargets& operator=(const ScopedTargets&) = delete;

  /// What is wrong, empty if nothing is.
  const std::string& GetObstacle() const { return this->Obstacle; }

private:
  vtkOpenGLRenderWindow* Window;
  const Stage& Drawn;
  std::string Obstacle;
};

namespace
{
struct BlendFunction
{
  GLenum Equation;
  std::array<GLenum, 4> Factors; // source and destination, colour and alpha
};

BlendFunction GetFunction(vtkTranslucencyFrame::Blending blending)
{
  using Blending = vtkTranslucencyFrame::Blending;
  switch (blending)
  {
    case Blending::AddAndAttenuate:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Attenuate:
      return { GL_FUNC_ADD, { { GL_ZERO, GL_ONE_MINUS_SRC_COLOR, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Minimum:
      return { GL_MIN, { { GL_ONE, GL_ONE, GL_ONE, GL_ONE } } };
    case Blending::Maximum:
      return { GL_MAX, { { GL_ONE, GL_ONE, GL_ONE, GL_ONE } } };
    case Blending::Over:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Filter:
      return { GL_FUNC_ADD, { { GL_ONE, GL_SRC1_COLOR, GL_ONE, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Under:
      return { GL_FUNC_ADD, { { GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA } } };
    case Blending::Replace:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ZERO, GL_ONE, GL_ZERO } } };
    default:
      return { GL_FUNC_ADD, { { GL_ONE, GL_ONE, GL_ONE, GL_ONE } } };
  }
}

// That of one of a stage's buffers.
BlendFunction GetFunction(const vtkTranslucencyFrame::Stage& stage, int buffer)
{
  const auto differing = stage.Differing.find(buffer);
  return GetFunction(differing == stage.Differing.end() ? stage.Blend : differing->second.Blend);
}

// The window's cache of OpenGL's state knows one function, that of the first buffer.
void BlendAllAsTheFirst()
{
  const auto get = [](GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return static_cast<GLenum>(value);
  };
  glBlendEquationSeparate(get(GL_BLEND_EQUATION_RGB), get(GL_BLEND_EQUATION_ALPHA));
  glBlendFuncSeparate(get(GL_BLEND_SRC_RGB), get(GL_BLEND_DST_RGB), get(GL_BLEND_SRC_ALPHA), get(GL_BLEND_DST_ALPHA));
}

using Rectangle = vtkTranslucencyFrame::Rectangle;

Rectangle Intersect(const Rectangle& a, const Rectangle& b)
{
  const int x = std::max(a[0], b[0]);
  const int y = std::max(a[1], b[1]);
  return { { x, y, std::max(0, std::min(a[0] + a[2], b[0] + b[2]) - x),
    std::max(0, std::min(a[1] + a[3], b[1] + b[3]) - y) } };
}

constexpr int MostSamples = 8; // that a node has room for

constexpr vtkTypeInt64 StatisticsBytes = sizeof(unsigned int) * STATISTICS_WORDS;

int SquaresAcross(int pixels)
{
  return (pixels + RESOLVE_SQUARE - 1) / RESOLVE_SQUARE;
}

// Of Statistics.glsl's block: what is of the whole frame, and a word a square of the tile.
vtkTypeInt64 GetStatisticsBytes(const Rectangle& tile)
{
  return StatisticsBytes +
    static_cast<vtkTypeInt64>(sizeof(unsigned int)) * SquaresAcross(tile[2]) * SquaresAcross(tile[3]);
}

// What goes into a mapper's shader where it has shaded a fragment; GATHERED_DEPTH stands for its depth.
std::string GatherCall(int outputs, bool critical, bool mean)
{
  std::string call = "gatherFragment(gl_FragData[0], GATHERED_DEPTH);\n";
  if (outputs > 0)
  {
    call = "vec4 gatherOutputs[" + std::to_string(outputs) +
      "];\ngatherFragment(gl_FragData[0], GATHERED_DEPTH, gatherOutputs);\n";
  }
  if (mean)
  {
    call = "gl_FragData[0] = meanTransmission(gl_FragData[0]);\n" + call;
  }
  if (critical)
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

// What a shader is made from, as one string.
std::string Key(const std::string& name, const std::map<std::string, std::string>& defines,
  const std::map<std::string, std::string>& offered)
{
  std::string key = name;
  for (const auto* list : { &defines, &offered })
  {
    for (const auto& define : *list)
    {
      key += " " + define.first + "=" + define.second;
    }
  }
  return key;
}
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::ScopedTargets::ScopedTargets(vtkOpenGLRenderWindow* window, const Stage& stage)
  : Window(window)
  , Drawn(stage)
{
  if (!stage.Targets)
  {
    return;
  }
  this->Obstacle = stage.Targets->Bind(window, stage.HidesBehind);
  if (this->Obstacle.empty() && stage.Cleared > 0)
  {
    window->GetState()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    stage.Targets->Clear(stage.Clear, stage.Cleared);
    for (const auto& differing : stage.Differing)
    {
      stage.Targets->Clear(differing.first, differing.second.Clear);
    }
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::ScopedTargets::~ScopedTargets()
{
  if (!this->Drawn.Targets || !this->Obstacle.empty())
  {
    return;
  }
  if (!this->Drawn.Differing.empty())
  {
    BlendAllAsTheFirst();
  }
  this->Drawn.Targets->Unbind();
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::vtkTranslucencyFrame(vtkTranslucencyPass* pass, const vtkRenderState* state,
  vtkOpenGLRenderWindow* window, const vtkTranslucencyGLState& found)
  : Pass(pass)
  , State(state)
  , Window(window)
  , Drawn(Intersect(found.GetViewport(), found.GetScissor()))
  , Tile(this->Drawn)
  , LastUnits(pass->Internal->PlanUnits)
{
  vtkTranslucencyPass::Internals& kept = *pass->Internal;
  if (kept.Viewport != this->Drawn)
  {
    kept.Viewport = this->Drawn;
    kept.Plan.clear();
  }
  this->Waiting = kept.Plan;
  if (this->Waiting.empty())
  {
    this->Waiting.push_back(this->Drawn);
  }
  kept.Plan.clear();
  kept.PlanFragments = 0;
  kept.PlanUnits = 0;
  kept.OpaqueDepthCaptured = false;
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  this->TargetSamples = std::max(1, samples);
  std::string missing = kept.Capabilities.MissingForSamples;
  if (samples > MostSamples)
  {
    missing = "windows of at most " + std::to_string(MostSamples) + " samples";
  }
  if (samples <= 1 || missing.empty())
  {
    this->Samples = std::max(1, samples);
  }
  else if (kept.MissingForSamples != missing)
  {
    kept.MissingForSamples = missing;
    vtkWarningWithObjectMacro(pass, << "multi-sampled translucency needs " << missing
                                    << "; drawing it with one sample a pixel");
  }
  this->ChooseTransmission();
  kept.GatherTime = -1;
  kept.ResolveTime = -1;
  kept.Resolved.emplace(); // nothing, until a shader counts: most techniques have none that does
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::ChooseTransmission()
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  const auto transmitting = vtkTranslucencyPass::Internals::CountTransmitting(this->State);
  if (transmitting.Props > 0)
  {
    const bool keeps = this->Pass->KeepsTransmissionColors();
    const std::string& lacking = kept.Capabilities.MissingForTransmission;
    this->Transmission = keeps && lacking.empty() ? Transmissions::Colored : Transmissions::Mean;
    const std::string why = keeps ? "the driver lacks " + lacking : "as it is set, it keeps one transmittance, not three";
    if (this->Transmission == Transmissions::Mean && kept.MeanTransmission != why)
    {
      kept.MeanTransmission = why;
      const std::string emissive =
        transmitting.Emissive > 0 ? " (white for " + std::to_string(transmitting.Emissive) + " with emissive splats)" : "";
      vtkWarningWithObjectMacro(this->Pass, << this->Pass->GetClassName() << " takes the transmission colours of " << transmitting.Props
                                            << " props" << emissive << " by their mean: " << why);
    }
  }
  if (!transmitting.Invalid.empty() && kept.InvalidTransmission != transmitting.Invalid)
  {
    vtkErrorWithObjectMacro(this->Pass,
      << "TRANSMISSION_COLOR of a " << transmitting.Invalid << " is not three numbers from 0 to 1; they are taken as the nearest ones that are");
  }
  kept.InvalidTransmission = transmitting.Invalid;
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::SetUniforms(vtkShaderProgram* program, const Uniforms& uniforms)
{
  for (const auto& uniform : uniforms)
  {
    const char* name = uniform.first.c_str();
    if (!program->IsUniformUsed(name))
    {
      continue;
    }
    if (const int* integer = std::get_if<int>(&uniform.second))
    {
      program->SetUniformi(name, *integer);
    }
    else
    {
      program->SetUniformf(name, std::get<float>(uniform.second));
    }
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Fail(const std::string& error)
{
  this->Error = error;
  return false;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::NextTile()
{
  if (this->Waiting.empty())
  {
    return false;
  }
  this->Tile = this->Waiting.back();
  this->Waiting.pop_back();
  return this->Tile[2] > 0 && this->Tile[3] > 0;
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::CutTile(int parts)
{
  // Strips of rows while there are enough rows: neighbours in memory stay together. Then pieces of a row.
  const int axis = this->Tile[3] > 1 ? 1 : 0;
  const int length = this->Tile[2 + axis];
  parts = std::min(parts, length);
  this->Cut = true;
  for (int part = parts - 1; part >= 0; --part)
  {
    const int from = static_cast<int>(static_cast<vtkTypeInt64>(length) * part / parts);
    const int to = static_cast<int>(static_cast<vtkTypeInt64>(length) * (part + 1) / parts);
    Rectangle piece = this->Tile;
    piece[axis] += from;
    piece[2 + axis] = to - from;
    this->Waiting.push_back(piece);
  }
  this->Tile = this->Waiting.back();
  this->Waiting.pop_back();
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::UseTile()
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  struct
  {
    Rectangle Tile;
    std::array<float, 4> Clipping;
  } block{ this->Tile, { { 1, 1, 0, 0 } } };
  vtkCamera* camera = this->State->GetRenderer()->GetActiveCamera();
  if (!camera->GetParallelProjection())
  {
    const double* range = camera->GetClippingRange();
    block.Clipping[0] = static_cast<float>(range[0]);
    block.Clipping[1] = static_cast<float>(range[1]);
  }
  kept.FrameBlock.Upload(&block, sizeof(block));
  kept.FrameBlock.BindUniform(UNIFORM_BINDING_FRAME);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(this->Tile[0], this->Tile[1], this->Tile[2], this->Tile[3]);
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> vtkTranslucencyFrame::GetOfferedDefines() const
{
  std::map<std::string, std::string> offered;
  if (this->Storage)
  {
    offered = this->Storage->GetDefines();
  }
  offered["TRANSMITTANCE_CHANNELS"] = std::to_string(this->GetChannels());
  offered["SAMPLES"] = std::to_string(this->Samples);
  offered["TARGET_SAMPLES"] = std::to_string(this->TargetSamples);
  offered["RECORD_TARGETS"] = std::to_string(this->FetchedRecords ? this->FetchedRecords->GetCount() : 0);
  offered["NODE_LINKS"] = std::to_string(static_cast<int>(vtkFragmentStorage::Links::None));
  offered["FRAGMENT_ORDER"] = this->Pass->Internal->Capabilities.KeepsDrawOrder
    ? "FRAGMENT_ORDER_DRAWN"
    : "FRAGMENT_ORDER_CONTENT";
  return offered;
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> vtkTranslucencyFrame::GetSelection() const
{
  std::map<std::string, std::string> selection{ { "CriticalSection",
    this->FetchedRecords ? "None" : this->Pass->GetSelectedCriticalSection(this->Pass->Internal->Capabilities) } };
  if (this->Storage)
  {
    selection["Storage"] = this->Storage->GetShaderName();
  }
  return selection;
}

//------------------------------------------------------------------------------
// What a mapper's shader needs to take transmission colours by their mean; empty where it does not.
std::string vtkTranslucencyFrame::GetMeanText() const
{
  vtkTranslucencyShader shader;
  if (this->Transmission == Transmissions::Mean)
  {
    shader.Assemble("Common/MeanTransmission.glsl", {});
  }
  return shader.GetText();
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::PrepareGather()
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  const std::string obstacle = this->Storage->GetObstacle(this->Drawn, kept.Capabilities);
  if (!obstacle.empty())
  {
    return this->Fail(obstacle);
  }
  const std::string mean = this->GetMeanText();
  const std::string key = Key(this->Storage->GetShaderName(), {}, this->GetOfferedDefines()) + mean;
  if (key == kept.GatherKey)
  {
    return true;
  }
  vtkTranslucencyShader shader;
  if (!shader.Assemble(
        "Common/Gather.glsl", {}, this->GetOfferedDefines(), this->GetSelection()) ||
    !shader.Validate("void main() { gatherFragment(vec4(1.0), 0.5); }\n"))
  {
    return this->Fail(shader.GetError());
  }
  vtkTranslucencyShader volumes; // compiled with the ray caster only: it declares what that one has
  Defines offered = this->GetOfferedDefines();
  offered["NODE_LINKS"] = std::to_string(static_cast<int>(vtkFragmentStorage::Links::Mixed));
  if (!volumes.Assemble("Common/GatherVolume.glsl", {}, offered, this->GetSelection()))
  {
    return this->Fail(volumes.GetError());
  }
  kept.GatherKey = key;
  kept.GatherText = shader.GetText() + mean;
  kept.GatherCall = GatherCall(0, false, !mean.empty());
  kept.GatherStores = true;
  kept.GatherFetches = false;
  kept.GatherRejects = false;
  kept.Volumes.SetGatherText(volumes.GetText());
  kept.GatherTextTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::PrepareGather(const Gathering& gathering)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  const std::string mean = this->GetMeanText();
  const std::string key =
    Key(gathering.File, gathering.Values, this->GetOfferedDefines()) + Key("", this->GetSelection(), {}) + mean;
  if (key == kept.GatherKey)
  {
    return true;
  }
  const bool fetches = gathering.Critical && this->FetchedRecords;
  const std::string call = GatherCall(gathering.Outputs, gathering.Critical, !mean.empty());
  // Alone, the text has no declarations of what VTK's shaders write.
  std::string main = "gl_FragData[0] = vec4(1.0); " + call;
  main = fetches ? vtkTranslucencyShader::FreeOutputs(main)
                 : std::regex_replace(main, std::regex("gl_FragData\\[(\\d+)\\]"), "fragOutput$1");
  main = std::regex_replace(main, std::regex("GATHERED_DEPTH"), "0.5");
  std::string outputs = fetches ? "" : "out vec4 fragOutput0;\n";
  for (int i = 1; i < gathering.Outputs; ++i)
  {
    outputs += "out vec4 fragOutput" + std::to_string(i) + ";\n";
  }
  vtkTranslucencyShader shader;
  if (!shader.Assemble(gathering.File, gathering.Values, this->GetOfferedDefines(), this->GetSelection()) ||
    !shader.Validate(mean + outputs + "void main() { " + main + " }\n"))
  {
    return this->Fail(shader.GetError());
  }
  kept.GatherKey = key;
  kept.GatherText = shader.GetText() + mean;
  kept.GatherCall = call;
  kept.GatherStores = gathering.Critical;
  kept.GatherFetches = fetches;
  kept.GatherRejects = gathering.Rejects;
  kept.GatherTextTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::UseWholeViewportIfItFits()
{
  if (this->Storage->Fits(this->LastUnits, this->Drawn, this->Pass->Internal->Capabilities))
  {
    this->UseWholeViewport();
  }
}

//------------------------------------------------------------------------------
// Forgets the tiles of the frame before, if nothing of this one has been drawn yet.
void vtkTranslucencyFrame::UseWholeViewport()
{
  if (this->Waiting.size() > 0 && this->Pass->Internal->Plan.empty() && !this->Cut)
  {
    this->Waiting.clear();
    this->Tile = this->Drawn;
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::DrawVertices(unsigned int primitive, int count)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  if (kept.VertexArray == 0)
  {
    glGenVertexArrays(1, &kept.VertexArray);
  }
  glBindVertexArray(kept.VertexArray);
  glDrawArrays(primitive, 0, count);
}

//------------------------------------------------------------------------------
// A software rasterizer spends a fifth of a multi-sampled gather on the depth test: worth asking whether the depth buffer holds
// anything, in this tile, that could hide a fragment.
bool vtkTranslucencyFrame::NeedsDepthTest()
{
  if (this->Samples == 1 || !this->Pass->Internal->Capabilities.Software)
  {
    return true;
  }
  vtkShaderProgram* program = this->PrepareProgram("Common/FullScreen.glsl", "Common/DepthOnly.glsl", {});
  if (!program)
  {
    return true;
  }
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_GREATER); // passes where something lies before the far plane
  return vtkTranslucencyAnySamplesPass([this] { this->DrawVertices(GL_TRIANGLES, 3); });
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::PrepareDrawing()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  // Without, there is one fragment a pixel and primitive, if the primitive covers the pixel's centre.
  state->SetEnumState(GL_MULTISAMPLE, this->Samples > 1);
  state->SetEnumState(GL_DEPTH_TEST, this->NeedsDepthTest());
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::PrepareColors(const Stage& stage)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->SetEnumState(GL_MULTISAMPLE, this->TargetSamples > 1);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->SetEnumState(GL_BLEND, stage.Blend != Blending::Replace);
  this->SetBlending(stage);
  if (stage.HidesBehind)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::SetBlending(const Stage& stage)
{
  vtkOpenGLState* state = this->Window->GetState();
  // The state has one function for all buffers, and VTK, if it is built so, compares it with that of the first one.
  const BlendFunction first = GetFunction(stage, 0);
  state->vtkglBlendEquation(first.Equation);
  state->vtkglBlendFuncSeparate(first.Factors[0], first.Factors[1], first.Factors[2], first.Factors[3]);
  for (int buffer = 1; !stage.Differing.empty() && buffer < stage.Targets->GetCount(); ++buffer)
  {
    const BlendFunction own = GetFunction(stage, buffer);
    glBlendEquationi(static_cast<GLuint>(buffer), own.Equation);
    glBlendFuncSeparatei(static_cast<GLuint>(buffer), own.Factors[0], own.Factors[1], own.Factors[2], own.Factors[3]);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::KeepBlending(const Stage& stage)
{
  const BlendFunction first = GetFunction(stage, 0);
  std::array<int, 4> found;
  this->Window->GetState()->GetBlendFuncState(found.data());
  if (!std::equal(found.begin(), found.end(), std::begin(first.Factors), [](int a, auto b) { return a == static_cast<int>(b); }))
  {
    this->SetBlending(stage);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::DrawGeometry(const Stage& stage, bool colors, bool* any)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  ScopedTimer timer(this->Pass->MeasureTimes, kept.GatherTime);
  this->PrepareDrawing();
  if (colors)
  {
    this->PrepareColors(stage);
  }
  kept.GatherWritesDepth = stage.HidesBehind;
  kept.KeepGatherBlending = [this, &stage, colors]
  {
    if (colors)
    {
      this->KeepBlending(stage);
    }
  };
  if (kept.OpaqueDepthCaptured) // by the first drawing of the frame
  {
    kept.ActivateOpaqueDepth();
  }
  kept.RenderedProps = 0;
  if (colors && !stage.Targets) // what goes over the opaque picture can't be drawn again
  {
    this->Pass->WarnOfUnreached(kept.Unreached.LookAhead(
      this->State, this->Window, [&kept](const vtkRenderState* some) { kept.DrawReached(some); }));
  }
  kept.GatherUniforms["gatherLayer"] = 0;
  if (any)
  {
    *any = false;
  }
  if (stage.Parts.empty())
  {
    this->DrawProps(this->State, stage, colors, any);
  }
  for (const Part& part : stage.Parts)
  {
    std::vector<vtkProp*> props{ part.Prop };
    vtkRenderState one(this->State->GetRenderer());
    vtkTranslucencySetProps(one, props, this->State);
    kept.GatherUniforms["gatherPart"] = part.Number;
    kept.GatherFaces = part.Drawn;
    this->DrawProps(&one, stage, colors, any);
    if (part.Drawn != Faces::All) // what follows need not care for culling
    {
      this->Window->GetState()->vtkglDisable(GL_CULL_FACE);
    }
    kept.GatherFaces = Faces::All;
  }
  if (kept.OpaqueDepthCaptured)
  {
    kept.DeactivateOpaqueDepth();
  }
  kept.KeepGatherBlending = [] {};
  kept.Statistics->SetGeometryPasses(kept.Statistics->GetGeometryPasses() + 1);
}

//------------------------------------------------------------------------------
// Draws the props that the text reaches together, the others one by one behind them.
void vtkTranslucencyFrame::DrawProps(const vtkRenderState* state, const Stage& stage, bool colors, bool* any)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  std::vector<vtkProp*> reached;
  std::vector<vtkProp*> unreached;
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(state, i);
    (kept.Unreached.Has(prop) ? unreached : reached).push_back(prop);
  }
  if (!reached.empty())
  {
    vtkRenderState together(state->GetRenderer());
    vtkTranslucencySetProps(together, reached, state);
    const auto draw = [&] { kept.Unreached.Watch(this->Window, [&] { kept.DrawReached(&together); }); };
    if (any)
    {
      *any = vtkTranslucencyAnySamplesPass(draw) || *any;
    }
    else
    {
      draw();
    }
    kept.RenderedProps += this->Pass->TranslucentPass->GetNumberOfRenderedProps();
  }
  for (vtkProp* prop : unreached)
  {
    // Which of its layers are back faces nobody knows: all are drawn with the front faces.
    if (kept.GatherFaces != Faces::Back)
    {
      this->DrawUnreached(prop, stage, colors, any);
      ++kept.RenderedProps;
    }
  }
}

//------------------------------------------------------------------------------
// Draws a prop by its own shaders, layer by layer, and gives each layer to the technique as if it had come from the prop.
void vtkTranslucencyFrame::DrawUnreached(vtkProp* prop, const Stage& stage, bool colors, bool* any)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  vtkTranslucencyLayers& layers = kept.Layers;
  if (!layers.Reserve(this->Drawn[0] + this->Drawn[2], this->Drawn[1] + this->Drawn[3], this->TargetSamples))
  {
    kept.GatherError = "the driver has no memory for the layers of " + std::string(prop->GetClassName());
    return;
  }
  std::vector<vtkProp*> props{ prop };
  vtkRenderState one(this->State->GetRenderer());
  vtkTranslucencySetProps(one, props, this->State);
  const auto drawProp = [&] { this->Pass->TranslucentPass->Render(&one); };
  const auto prepare = [&]
  {
    this->PrepareDrawing();
    if (colors)
    {
      this->PrepareColors(stage);
    }
  };
  int layer = 0;
  while (layers.Draw(this->Window, kept.Unreached.GetWatch(), layer, drawProp))
  {
    if (layer == vtkTranslucencyLayers::Most)
    {
      kept.GatherError = prop->GetClassName() + std::string(", which is drawn by itself, has more than ") + std::to_string(layer) +
        " layers in a pixel, expected no more";
      return;
    }
    kept.GatherUniforms["gatherLayer"] = layer;
    prepare();
    vtkShaderProgram* program = this->PrepareHandOver();
    if (!program)
    {
      return;
    }
    ScopedTextures textures(this->Window);
    textures.Bind("layerColors", layers.GetTarget(), layers.GetColors());
    textures.Bind("layerDepths", layers.GetTarget(), layers.GetDepths());
    kept.Gathering = true;
    const bool ready = this->Pass->SetShaderParameters(program, nullptr, prop);
    kept.Gathering = false;
    if (!ready)
    {
      return;
    }
    SetUniforms(program, textures.GetUnits());
    const auto handOver = [this] { this->DrawVertices(GL_TRIANGLES, 3); };
    if (any)
    {
      *any = vtkTranslucencyAnySamplesPass(handOver) || *any;
    }
    else
    {
      handOver();
    }
    ++layer;
  }
  kept.GatherUniforms["gatherLayer"] = 0;
  prepare(); // for what is drawn next
}

//------------------------------------------------------------------------------
// The program that draws a layer as a mapper draws its fragments.
vtkShaderProgram* vtkTranslucencyFrame::PrepareHandOver()
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  const std::string file = "Common/HandOver.glsl";
  vtkOpenGLShaderCache* cache = this->Window->GetShaderCache();
  const std::string key = file + kept.GatherKey;
  const auto found = kept.Programs.find(key);
  if (found != kept.Programs.end())
  {
    return cache->ReadyShaderProgram(found->second);
  }
  vtkTranslucencyShader fragment;
  vtkTranslucencyShader vertex;
  std::string text;
  vtkShaderProgram* program = nullptr;
  if (fragment.Assemble(file, { { "HAND_OVER_SAMPLES", std::to_string(this->TargetSamples) } }) &&
    vertex.Assemble("Common/FullScreen.glsl", {}))
  {
    text = "//VTK::System::Dec\n" + fragment.GetText();
    if (this->Pass->InsertGather(text, file))
    {
      program =
        cache->ReadyShaderProgram(("//VTK::System::Dec\n" + vertex.GetText()).c_str(), text.c_str(), "");
    }
  }
  if (!program)
  {
    kept.GatherError = "shader " + file + " does not link " + fragment.GetError() + vertex.GetError();
    return nullptr;
  }
  kept.Programs[key] = program;
  return program;
}

//------------------------------------------------------------------------------
// After a drawing of the geometry: whether all of it was drawn by the technique.
bool vtkTranslucencyFrame::IsDrawn()
{
  const std::string& error = this->Pass->Internal->GatherError;
  if (this->Pass->Internal->Unreached.IsMissed())
  {
    return this->Fail("props are drawn by shaders that the technique does not reach");
  }
  return error.empty() || this->Fail(error);
}

//------------------------------------------------------------------------------
// After a drawing whose shaders store to buffers: from now on other shaders see it, and the application, which may write there, too.
void vtkTranslucencyFrame::FinishStores()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::DrawVolumes()
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  if (!this->SortLists({}))
  {
    return false;
  }
  ScopedTimer timer(this->Pass->MeasureTimes, kept.GatherTime);
  this->PrepareDrawing();
  for (vtkProp* prop : kept.Volumes.GetProps())
  {
    std::vector<vtkProp*> props{ prop };
    vtkRenderState one(this->State->GetRenderer());
    vtkTranslucencySetProps(one, props, this->State);
    kept.Hook->PreRender(&one);
    kept.Gathering = true;
    kept.Volumes.Gather(&one);
    kept.Gathering = false;
    kept.Hook->PostRender(&one);
    FinishStores(); // the next one changes the same lists
  }
  return true;
}

//------------------------------------------------------------------------------
// Before a shader that counts. The first of a frame finds nothing counted.
bool vtkTranslucencyFrame::UseStatistics()
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  if (!this->CountsStatistics)
  {
    // No tile has more squares than all of them together: what was counted is not lost by growing in between.
    if (!kept.StatisticsBlock.Reserve(GetStatisticsBytes(this->Drawn)))
    {
      return this->Fail("the driver has no memory for the resolve");
    }
    kept.StatisticsBlock.Clear(StatisticsBytes);
    this->CountsStatistics = true;
  }
  kept.StatisticsBlock.BindStorage(STORAGE_BINDING_STATISTICS);
  return true;
}

//------------------------------------------------------------------------------
// Makes what the storage holds ready to be read.
bool vtkTranslucencyFrame::Retrieve()
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  const char* file = this->Storage->GetRetrieval();
  if (!file)
  {
    return true;
  }
  ScopedTimer timer(this->Pass->MeasureTimes, kept.ResolveTime);
  const std::array<int, 2> cells = this->Storage->BeginRetrieval();
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  if (!this->UseStatistics() || !this->PrepareProgram("Common/FullScreen.glsl", file, {}))
  {
    return false;
  }
  this->UseTile();
  state->vtkglViewport(this->Tile[0], this->Tile[1], cells[0], cells[1]);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_MULTISAMPLE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  bool any = true;
  for (vtkTypeInt64 left = this->Storage->GetFragments(); any && left >= 0; --left) // a pass takes one away at least
  {
    any = vtkTranslucencyAnySamplesPass([this] { this->DrawVertices(GL_TRIANGLES, 3); });
    FinishStores();
    kept.Statistics->SetScreenPasses(kept.Statistics->GetScreenPasses() + 1);
  }
  kept.Resolved.reset();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::CountAccesses()
{
  vtkTranslucencyBuffer& fragments = this->Pass->Internal->PixelFragments;
  std::vector<unsigned int> pixels(static_cast<std::size_t>(this->Tile[2]) * this->Tile[3]);
  const auto bytes = static_cast<vtkTypeInt64>(pixels.size() * sizeof(unsigned int));
  if (!fragments.Reserve(bytes))
  {
    return this->Fail("the driver has no memory for counting fragments");
  }
  fragments.Clear(bytes);
  fragments.BindStorage(STORAGE_BINDING_READ_BACK);
  if (!this->Resolve("Storage/CountAccesses.glsl", {}, {}))
  {
    return false;
  }
  fragments.Download(pixels.data(), bytes);
  for (unsigned int count : pixels)
  {
    if (count > 0)
    {
      ++this->Counted.Pixels[count];
    }
  }
  this->Accesses += this->Storage->GetAccesses();
  return true;
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::ReportAccesses()
{
  if (this->Storage && this->Pass->CountAccesses)
  {
    this->Counted.Width = this->Drawn[2];
    this->Counted.Height = this->Drawn[3];
    this->Pass->Internal->Statistics->SetStorageCounts(
      this->Storage->GetDesign(), this->Storage->GetSectionFragments(), this->Counted, this->Accesses);
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Gather(vtkFragmentStorage* storage)
{
  using Outcome = vtkFragmentStorage::Outcome;
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  if (this->Storage != storage)
  {
    storage->BeginFrame(kept.Capabilities);
  }
  this->Storage = storage;
  storage->SetChannelsAndSamples(this->GetChannels(), this->Samples);
  storage->SetCountAccesses(this->Pass->CountAccesses);
  this->SetSample(WholePixel);
  if (!this->PrepareGather())
  {
    return false;
  }
  this->UseWholeViewportIfItFits();
  for (;;)
  {
    Outcome outcome = storage->Begin(this->Tile, kept.Capabilities);
    if (outcome == Outcome::Complete)
    {
      this->UseTile();
      kept.GatherError.clear();
      this->DrawGeometry(Stage(), false);
      FinishStores();
      outcome = storage->End();
      if (outcome == Outcome::Complete && !this->Retrieve())
      {
        return false;
      }
      if (outcome == Outcome::Complete && !kept.Volumes.GetProps().empty()) // they go through whole lists only
      {
        if (!this->DrawVolumes())
        {
          return false;
        }
        outcome = storage->End();
      }
      if (!this->IsDrawn())
      {
        return false;
      }
    }
    switch (outcome)
    {
      case Outcome::Complete:
        if (this->Pass->CountAccesses && !this->CountAccesses())
        {
          return false;
        }
        kept.PlanFragments += storage->GetFragments();
        kept.PlanUnits += storage->GetUnits();
        kept.Plan.insert(kept.Plan.begin(), this->Tile); // the last drawn comes first: see Waiting
        return true;
      case Outcome::Grown:
        break;
      case Outcome::TooLarge:
      case Outcome::OutOfMemory:
        if (this->Tile[2] * this->Tile[3] == 1)
        {
          return this->Fail("the driver has no memory for the " +
            std::to_string(storage->GetFragments()) + " fragments of one pixel");
        }
        this->CutTile(outcome == Outcome::TooLarge ? storage->GetPartsNeeded() : 2);
        break;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::UsePixels(vtkTranslucencyPixels& pixels, int words, double memoryLimit, const Fetched& fetched)
{
  using Size = vtkTranslucencyPixels::Size;
  this->UseWholeViewport();
  const vtkTranslucencyCapabilities& capabilities = this->Pass->Internal->Capabilities;
  const auto limit = static_cast<vtkTypeInt64>(capabilities.GetLimitBytes(memoryLimit));
  this->FetchedEmpty = fetched.Empty;
  this->FetchedRecords = fetched.Words > 0 && this->FetchPixels(pixels, fetched.Words, limit) ? &pixels.GetTargets() : nullptr;
  this->HasRecords = !this->FetchedRecords;
  if (this->FetchedRecords)
  {
    this->UseTile();
    return true;
  }
  const bool locks = this->GetSelection().at("CriticalSection") == "Spinlock";
  for (;;)
  {
    const Size size = vtkTranslucencyPixels::GetSize(this->Tile, this->Samples, words, locks);
    const vtkTypeInt64 parts = std::max((size.Sum() + limit - 1) / limit,
      (size.Records + capabilities.MaximumBlockBytes - 1) / capabilities.MaximumBlockBytes);
    const bool smallest = this->Tile[2] * this->Tile[3] == 1;
    if (parts <= 1 || smallest)
    {
      if (size.Sum() > limit)
      {
        return this->Fail("a memory limit of " + std::to_string(limit) + " bytes is too small, expected at least " +
          std::to_string(size.Sum()) + " bytes for a pixel and its neighbours");
      }
      if (pixels.Begin(size))
      {
        this->UseTile();
        return true;
      }
      if (smallest)
      {
        return this->Fail("the driver has no memory for the records of one pixel");
      }
    }
    this->CutTile(static_cast<int>(std::clamp<vtkTypeInt64>(parts, 2, this->Tile[2] * this->Tile[3])));
  }
}

//------------------------------------------------------------------------------
// Whether records are kept in colours: makes room for them if so.
bool vtkTranslucencyFrame::FetchPixels(vtkTranslucencyPixels& pixels, int words, vtkTypeInt64 limit)
{
  const vtkTranslucencyCapabilities& capabilities = this->Pass->Internal->Capabilities;
  const int width = this->Drawn[0] + this->Drawn[2];
  const int height = this->Drawn[1] + this->Drawn[3];
  return this->Pass->GetCriticalSection() == vtkTranslucencyPass::Automatic && capabilities.MissingForFetch.empty() &&
    this->TargetSamples == 1 && vtkTranslucencyPixels::CountTargets(words) <= capabilities.MaximumTargets &&
    vtkTranslucencyPixels::GetTargetBytes(width, height, words) <= limit && pixels.BeginTargets(width, height, words);
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::UseTargets(vtkTranslucencyTargets& targets, const std::vector<int>& formats)
{
  this->UseWholeViewport();
  std::vector<vtkTranslucencyTargets::Format> floats;
  for (int format : formats)
  {
    floats.push_back(vtkTranslucencyTargets::Floats(format));
  }
  if (!targets.Reserve(this->Drawn[0] + this->Drawn[2], this->Drawn[1] + this->Drawn[3], this->TargetSamples, floats))
  {
    return this->Fail("the driver has no memory for floating-point colours");
  }
  this->UseTile();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::UseTable(vtkTranslucencyBuffer& table, const std::vector<unsigned int>& words)
{
  if (!table.Upload(words.data(), static_cast<vtkTypeInt64>(words.size() * sizeof(unsigned int))))
  {
    return this->Fail("the driver has no memory for a table of " + std::to_string(words.size()) + " words");
  }
  table.BindStorage(STORAGE_BINDING_TABLE);
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkTranslucencyFrame::GetProps() const
{
  std::vector<vtkProp*> props;
  for (int i = 0; i < vtkTranslucencyPropCount(this->State); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(this->State, i);
    if (prop->HasTranslucentPolygonalGeometry() || this->Pass->Internal->Unreached.Has(prop))
    {
      props.push_back(prop);
    }
  }
  return props;
}

//------------------------------------------------------------------------------
vtkRenderer* vtkTranslucencyFrame::GetRenderer() const
{
  return this->State->GetRenderer();
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkTranslucencyFrame::GetDepthRange() const
{
  const std::array<double, 2> all{ { 0, 1 } };
  vtkCamera* camera = this->State->GetRenderer()->GetActiveCamera();
  const double* clipping = camera->GetClippingRange();
  vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
  double nearest = VTK_DOUBLE_MAX;
  double farthest = -VTK_DOUBLE_MAX;
  for (int i = 0; i < vtkTranslucencyPropCount(this->State); ++i)
  {
    vtkProp* prop = vtkTranslucencyProp(this->State, i);
    if (!prop->GetVisibility() || !(prop->HasTranslucentPolygonalGeometry() || this->Pass->Internal->Unreached.Has(prop)))
    {
      continue;
    }
    const double* bounds = prop->GetBounds();
    if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
    {
      return all;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const double at[4] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)], 1 };
      const double distance = -view->MultiplyDoublePoint(at)[2];
      nearest = std::min(nearest, distance);
      farthest = std::max(farthest, distance);
    }
  }
  if (nearest > farthest)
  {
    return all;
  }
  const auto linear = [clipping](double distance) {
    return std::clamp((distance - clipping[0]) / (clipping[1] - clipping[0]), 0.0, 1.0);
  };
  return { { linear(nearest), linear(farthest) } };
}

//------------------------------------------------------------------------------
// After a stage that may have changed records of pixels. Where there are none nothing is to be waited for: what goes to targets is seen by whoever
// reads them.
void vtkTranslucencyFrame::FinishRecords()
{
  if (this->HasRecords)
  {
    FinishStores();
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Draw(const Gathering& gathering, const Stage& stage, bool* any)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  if (!this->PrepareGather(gathering))
  {
    return false;
  }
  const Stage drawn = kept.GatherFetches ? this->GetFetchedStage(stage) : stage;
  ScopedTargets targets(this->Window, drawn);
  if (!targets.GetObstacle().empty())
  {
    return this->Fail(targets.GetObstacle());
  }
  if (!drawn.Targets)
  {
    this->UseTile();
  }
  {
    const ScopedTextures inputs(this->Window, drawn.Inputs);
    kept.GatherUniforms = drawn.Values;
    kept.GatherUniforms["gatherStage"] = drawn.Number;
    kept.GatherUniforms.insert(inputs.GetUnits().begin(), inputs.GetUnits().end());
    kept.GatherError.clear();
    this->DrawGeometry(drawn, (gathering.Outputs > 0 && !drawn.StoresOnly) || kept.GatherFetches, any);
  }
  this->FinishRecords();
  return this->IsDrawn();
}

//------------------------------------------------------------------------------
// The stage that draws to the colours in which records are kept.
vtkTranslucencyFrame::Stage vtkTranslucencyFrame::GetFetchedStage(const Stage& stage) const
{
  Stage fetched = stage;
  fetched.Targets = this->FetchedRecords;
  fetched.Blend = Blending::Replace;
  fetched.Clear.fill(EMPTY_NUMBER);
  fetched.Cleared = stage.Number == 0 ? vtkTranslucencyPixels::CountTargets(this->FetchedEmpty) : 0;
  return fetched;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::DrawScreen(const std::string& file, const Defines& defines, const Stage& stage, bool* any)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  vtkShaderProgram* program = this->PrepareProgram("Common/FullScreen.glsl", file, defines);
  if (!program)
  {
    return false;
  }
  ScopedTimer timer(this->Pass->MeasureTimes, kept.ResolveTime);
  this->UseTile();
  ScopedTargets targets(this->Window, stage);
  if (!targets.GetObstacle().empty())
  {
    return this->Fail(targets.GetObstacle());
  }
  const ScopedTextures bound(this->Window, stage.Inputs);
  SetUniforms(program, stage.Values);
  SetUniforms(program, bound.GetUnits());
  this->Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  this->PrepareColors(stage);
  const auto draw = [this] { this->DrawVertices(GL_TRIANGLES, 3); };
  if (any)
  {
    *any = vtkTranslucencyAnySamplesPass(draw);
  }
  else
  {
    draw();
  }
  this->FinishRecords();
  kept.Statistics->SetScreenPasses(kept.Statistics->GetScreenPasses() + 1);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Clear(const Stage& stage)
{
  const ScopedTargets targets(this->Window, stage);
  return targets.GetObstacle().empty() || this->Fail(targets.GetObstacle());
}

//------------------------------------------------------------------------------
std::vector<float> vtkTranslucencyFrame::Read(const vtkTranslucencyTargets& targets, int index)
{
  const std::vector<float> values = targets.Read(index, this->Tile, this->Window);
  if (values.empty())
  {
    this->Fail("the driver can't read floating-point colours back");
  }
  return values;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Composite(const std::string& file, const Defines& defines,
  const std::vector<Input>& inputs, const Uniforms& uniforms)
{
  Stage over;
  over.Blend = this->GetOver();
  over.Inputs = inputs;
  over.Values = uniforms;
  for (int i = 0; this->FetchedRecords && i < this->FetchedRecords->GetCount(); ++i)
  {
    over.Inputs.push_back({ "recordTarget" + std::to_string(i), this->FetchedRecords, i });
  }
  if (!this->DrawScreen(file, defines, over))
  {
    return false;
  }
  std::vector<Rectangle>& plan = this->Pass->Internal->Plan;
  plan.insert(plan.begin(), this->Tile); // this tile is done: the next frame begins with the same ones
  return true;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTranslucencyFrame::PrepareProgram(
  const std::string& vertexFile, const std::string& file, const Defines& defines)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  vtkOpenGLShaderCache* cache = this->Window->GetShaderCache();
  const auto selection = this->GetSelection();
  Defines offered = this->GetOfferedDefines();
  if (this->Storage)
  {
    offered["NODE_LINKS"] = std::to_string(static_cast<int>(this->Storage->GetLinks()));
  }
  const std::string key = Key(file, defines, offered) + Key("", selection, {});
  const auto found = kept.Programs.find(key);
  if (found != kept.Programs.end())
  {
    return cache->ReadyShaderProgram(found->second);
  }
  vtkTranslucencyShader fragment;
  vtkTranslucencyShader vertex;
  for (bool ready : { fragment.Assemble(file, defines, offered, selection),
         vertex.Assemble(vertexFile, {}, offered, selection), fragment.Validate(""),
         vertex.Validate("", vtkShader::Vertex) })
  {
    if (!ready)
    {
      this->Fail(fragment.GetError() + vertex.GetError());
      return nullptr;
    }
  }
  const std::string head =
    "//VTK::System::Dec\n" + std::string(vtkTranslucencyShader::GetExtensions());
  vtkShaderProgram* program = cache->ReadyShaderProgram(
    (head + vertex.GetText()).c_str(), (head + fragment.GetText()).c_str(), "");
  if (!program)
  {
    this->Fail("shader " + file + " does not link");
    return nullptr;
  }
  kept.Programs[key] = program;
  return program;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::Resolve(
  const std::string& file, const Defines& defines, const Squares& squares, const Uniforms& uniforms)
{
  vtkTranslucencyPass::Internals& kept = *this->Pass->Internal;
  vtkShaderProgram* program = this->PrepareProgram("Common/ResolveSquares.glsl", file, defines);
  if (!program)
  {
    return false;
  }
  ScopedTimer timer(this->Pass->MeasureTimes, kept.ResolveTime);
  this->UseTile();
  const int across = SquaresAcross(this->Tile[2]);
  const int down = SquaresAcross(this->Tile[3]);
  if (!this->UseStatistics())
  {
    return false;
  }
  if (squares.Level == 0 && this->Sample == WholePixel)
  {
    constexpr vtkTypeInt64 leftLevels = sizeof(unsigned int) * 2;
    kept.StatisticsBlock.Clear(GetStatisticsBytes(this->Tile) - leftLevels, leftLevels);
  }
  program->SetUniformi("resolveLevel", squares.Level);
  program->SetUniformi("resolveFewer", squares.Fewer);
  program->SetUniformi("resolveMost", squares.Most);
  if (this->Samples > 1)
  {
    program->SetUniformi("resolveSample", this->Sample);
    program->SetUniformi("resolveAmong", this->Among);
  }
  SetUniforms(program, uniforms);
  ScopedTextures textures(this->Window);
  textures.BindTexels({ "statisticsTexels", &kept.StatisticsBlock, 1 }, program);
  if (this->Storage)
  {
    textures.BindTexels(this->Storage, program);
  }
  SetUniforms(program, textures.GetUnits());

  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  state->vtkglViewport(this->Tile[0], this->Tile[1], across * RESOLVE_SQUARE, down * RESOLVE_SQUARE);
  const bool sizedByPrograms = glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE;
  glEnable(GL_PROGRAM_POINT_SIZE);
  state->vtkglDisable(GL_DEPTH_TEST);
  Stage over;
  over.Blend = this->GetOver();
  this->PrepareColors(over);
  this->DrawVertices(GL_POINTS, across * down);
  if (!sizedByPrograms)
  {
    glDisable(GL_PROGRAM_POINT_SIZE); // the next tile may have points of the scene's, whose programs say no size
  }
  if (this->Storage)
  {
    this->Storage->FinishLinks();
  }
  kept.Resolved.reset();
  FinishStores();
  kept.Statistics->SetScreenPasses(kept.Statistics->GetScreenPasses() + 1);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::PrepareSorting()
{
  return this->Storage->ReserveLinks() || this->Fail("the driver has no memory for sorting fragments");
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::SortLists(const Squares& squares)
{
  bool drawn = this->PrepareSorting() && this->Resolve("Common/SortRuns.glsl", {}, squares);
  const vtkTypeInt64 deepest = drawn ? this->GetDeepestPixel() : 0;
  for (int length = 32; length < deepest && drawn; length *= 2)
  {
    drawn = this->Resolve("Common/MergeRuns.glsl", {}, squares, { { "runLength", length } });
  }
  return drawn;
}

//------------------------------------------------------------------------------
std::vector<vtkTypeUInt64> vtkTranslucencyFrame::GetFingerprint() const
{
  // Gives new props room for a pass's key, which modifies them once.
  this->Pass->Internal->Hook->PreRender(this->State);
  this->Pass->Internal->Hook->PostRender(this->State);
  vtkTranslucencyFingerprint fingerprint;
  for (int number : this->Drawn)
  {
    fingerprint.Add(number);
  }
  fingerprint.Add(this->TargetSamples);
  fingerprint.AddView(this->State);
  return fingerprint.GetNumbers();
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::SetSample(int sample, int among)
{
  this->Sample = sample;
  this->Among = among;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::ReserveSampleColors()
{
  if (this->Samples == 1)
  {
    return true;
  }
  vtkTranslucencyBuffer& colors = this->Pass->Internal->SampleColors;
  const vtkTypeInt64 colorBytes = this->GetChannels() == 3 ? 16 : 8;
  const vtkTypeInt64 before = colors.GetBytes();
  if (!colors.Reserve(colorBytes * this->Samples * this->Tile[2] * this->Tile[3]))
  {
    return this->Fail("the driver has no memory for the colours of the samples");
  }
  if (colors.GetBytes() != before)
  {
    colors.Clear(colors.GetBytes()); // from then on whoever reads them does
  }
  colors.BindStorage(STORAGE_BINDING_SAMPLES);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::CompositeSamples()
{
  this->SetSample(WholePixel);
  return this->Resolve("Common/CompositeSamples.glsl", {}, Squares::LeftTo(LEVEL_SAMPLES));
}

//------------------------------------------------------------------------------
bool vtkTranslucencyFrame::IsLeftTo(int level)
{
  return (this->Pass->Internal->GetResolveStatistics().LeftLevels >> level) & 1u;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyFrame::GetDeepestPixel()
{
  return this->Pass->Internal->GetResolveStatistics().DeepestPixel;
}

//------------------------------------------------------------------------------
void vtkTranslucencyFrame::Blend()
{
  this->UseTile();
  vtkTranslucencyGLState::UsePlainBlending(this->Window->GetState());
  this->Pass->TranslucentPass->Render(this->State);
}
