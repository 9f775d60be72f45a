// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyShader.h"

#include "vtkTranslucencyShaderTable.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkNew.h"
#include "vtkShaderProgram.h"
#include "vtksys/RegularExpression.hxx"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Source numbers start here, so that they can't be mistaken for the surrounding text's own, 0.
constexpr int FirstSource = 101;

bool IsOfWord(char character)
{
  return std::isalnum(static_cast<unsigned char>(character)) || character == '_';
}

// Not by a regular expression: for each define of each shader, these take hundreds of milliseconds of a first frame.
bool Mentions(const std::string& text, const std::string& word)
{
  std::size_t at = text.find(word);
  while (at != std::string::npos &&
    ((at > 0 && IsOfWord(text[at - 1])) || IsOfWord(text[at + word.size()]))) // behind the last is 0
  {
    at = text.find(word, at + 1);
  }
  return at != std::string::npos;
}
}

//------------------------------------------------------------------------------
const char* vtkTranslucencyShader::GetExtensions()
{
  // A driver that lacks one would warn of the line. What a shader needs and the compiler does not know it refuses.
#define EXTENSION(name) "#ifdef " name "\n#extension " name " : enable\n#endif\n"
  return EXTENSION("GL_ARB_explicit_attrib_location") // of outputs
    EXTENSION("GL_ARB_shader_bit_encoding")           // floats as words
    EXTENSION("GL_ARB_blend_func_extended")           // two source colours
    EXTENSION("GL_ARB_sample_shading")                // gl_SampleID
    EXTENSION("GL_ARB_gpu_shader5")                   // gl_SampleMaskIn
    EXTENSION("GL_ARB_shader_image_load_store")       // early tests
    EXTENSION("GL_ARB_shading_language_420pack")      // bindings of blocks
    EXTENSION("GL_ARB_shading_language_packing")      // colours as words
    EXTENSION("GL_ARB_shader_storage_buffer_object")  // fragment storage
    EXTENSION("GL_ARB_gpu_shader_int64")              // stores of two words
    EXTENSION("GL_ARB_post_depth_coverage")           // masks of the samples that pass the depth test
    EXTENSION("GL_EXT_shader_framebuffer_fetch")      // records of pixels in colours
    EXTENSION("GL_ARB_ES3_1_compatibility")           // gl_HelperInvocation
    EXTENSION("GL_ARB_fragment_shader_interlock") EXTENSION("GL_NV_fragment_shader_interlock")
      EXTENSION("GL_INTEL_fragment_shader_ordering");
#undef EXTENSION
}

//------------------------------------------------------------------------------
bool vtkTranslucencyShader::Assemble(
  const std::string& file, const Defines& required, const Defines& offered, const Selection& selection)
{
  this->Text.clear();
  this->Error.clear();
  this->Files.clear();
  this->Selected = selection;
  this->Open.clear();
  this->Whole.clear();
  std::string head;
  if (!this->Append(file, "", 0, false) || !this->Define(required, true, head) || !this->Define(offered, false, head))
  {
    return false;
  }
  this->Text.insert(0, head);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyShader::Define(const Defines& defines, bool required, std::string& head)
{
  for (const auto& define : defines)
  {
    const bool mentioned = Mentions(this->Text, define.first);
    if (!mentioned && required)
    {
      this->Error =
        "shader " + this->Files.front() + ": the define " + define.first + " is mentioned by none of its files";
      return false;
    }
    if (mentioned)
    {
      head += "#define " + define.first + " " + define.second + "\n";
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyShader::Append(const std::string& file, const std::string& includer, int line, bool conditional)
{
  if (std::find(this->Open.begin(), this->Open.end(), file) != this->Open.end())
  {
    this->Error = "shader " + file + " includes itself, by way of " + includer;
    return false;
  }
  const char* source = vtkTranslucencyShaderTable(file);
  if (!source)
  {
    this->Error = "shader " + file + " is not in the shader table" +
      (includer.empty() ? "" : " (included by " + includer + ":" + std::to_string(line) + ")");
    return false;
  }
  // Once a text has a file under no condition, drivers need not read it again behind its include guard: that was most
  // of the text of a resolve.
  if (std::find(this->Whole.begin(), this->Whole.end(), file) != this->Whole.end())
  {
    return true;
  }
  if (!conditional)
  {
    this->Whole.push_back(file);
  }
  auto at = std::find(this->Files.begin(), this->Files.end(), file);
  if (at == this->Files.end())
  {
    at = this->Files.insert(at, file);
  }
  const int number = FirstSource + static_cast<int>(at - this->Files.begin());
  this->Open.push_back(file);

  const auto mark = [&](int next)
  {
    // Before GLSL 3.30, `#line n` makes the following line n + 1 (GLSL 1.50, section 3.4).
    this->Text += "#line " + std::to_string(next - 1) + " " + std::to_string(number) + "\n";
  };
  mark(1);
  vtksys::RegularExpression include("^[ \t]*#[ \t]*include[ \t]+\"([^\"]+)\"");
  vtksys::RegularExpression guard("^#ifndef [A-Za-z]+_glsl$");
  vtksys::RegularExpression condition("^[ \t]*#[ \t]*if");
  vtksys::RegularExpression conditionEnd("^[ \t]*#[ \t]*endif");
  int conditions = 0; // that hold for a line, besides the guard
  std::istringstream lines(source);
  std::string text;
  for (int here = 1; std::getline(lines, text); ++here)
  {
    const bool directive = text.find('#') != std::string::npos; // a quick answer for most lines
    if (directive && include.find(text))
    {
      std::string included = include.match(1);
      for (const auto& selected : this->Selected)
      {
        vtkShaderProgram::Substitute(included, selected.first + "/Selected", selected.first + "/" + selected.second);
      }
      if (!this->Append(included, file, here, conditional || conditions > 0))
      {
        return false;
      }
      mark(here + 1);
    }
    else
    {
      conditions += directive && condition.find(text) && !guard.find(text) ? 1 : 0;
      conditions -= directive && conditionEnd.find(text) && conditions > 0 ? 1 : 0;
      this->Text += text + "\n";
    }
  }
  this->Open.pop_back();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyShader::Validate(const std::string& main, vtkShader::Type type)
{
  vtkNew<vtkShader> shader;
  shader->SetType(type);
  shader->SetSource("#version 150\n" + std::string(GetExtensions()) + this->Text + main);
  const bool compiled = this->Error.empty() && shader->Compile();
  if (!compiled && this->Error.empty())
  {
    this->Error = "shader " + this->Files.front() + " does not compile:\n" + this->NameSources(shader->GetError());
  }
  shader->Cleanup();
  return compiled;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyShader::NameSources(const std::string& log) const
{
  // Mesa writes "101:12(3): error: ...", NVIDIA "101(12) : error ...", others "ERROR: 101:12: ...".
  std::string named = log;
  for (std::size_t i = 0; i < this->Files.size(); ++i)
  {
    const std::string number = std::to_string(FirstSource + static_cast<int>(i));
    named = std::regex_replace(named, std::regex("\\b" + number + "(:|\\()(\\d+)\\)?"), this->Files[i] + ":$2");
  }
  return named;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyShader::FreeOutputs(const std::string& text)
{
  std::string freed = text;
  vtkShaderProgram::Substitute(freed, "gl_FragData[", "gatheredColors[");
  return freed;
}

//------------------------------------------------------------------------------
std::string vtkTranslucencyShader::LeaveAtDiscards(const std::string& text)
{
  const std::size_t main = std::min(text.find("void main"), text.size()); // stands behind all other functions
  std::string body = text.substr(main);
  vtkShaderProgram::Substitute(body, "discard;", "{ discard; AFTER_DISCARD }");
  return text.substr(0, main) + "#ifndef AFTER_DISCARD\n#define AFTER_DISCARD return;\n#endif\n" + body;
}

//------------------------------------------------------------------------------
void vtkTranslucencyShader::SetUniforms(vtkShaderProgram* program, const Uniforms& uniforms)
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
    else if (const float* number = std::get_if<float>(&uniform.second))
    {
      program->SetUniformf(name, *number);
    }
    else
    {
      program->SetUniform4f(name, std::get<Vector>(uniform.second).data());
    }
  }
}

//------------------------------------------------------------------------------
bool vtkTranslucencyShader::Substitute(std::string& text, const std::string& anchor, const std::string& replacement,
  const std::string& who, std::string& error)
{
  if (vtkShaderProgram::Substitute(text, anchor, replacement))
  {
    return true;
  }
  error = "the shader of " + who + " has no " + anchor;
  return false;
}
VTK_ABI_NAMESPACE_END
