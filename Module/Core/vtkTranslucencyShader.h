// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyShader
 *
 * Puts shader text together from the .glsl files of Module/Shaders, which the library carries inside.
 *
 * `#include "Folder/File.glsl"` takes in a file of the table; files guard themselves against a second time, as C++
 * headers do. Every file starts by refusing to compile without the defines it needs; a define that no file mentions is
 * refused here, so that neither side can be misspelt in silence.
 * `#line` directives keep file and line, so that a compiler's message can be told in those terms.
 */
#ifndef vtkTranslucencyShader_h
#define vtkTranslucencyShader_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include "vtkShader.h" // for its type

#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyShader
{
public:
  using Defines = std::map<std::string, std::string>;
  using Vector = std::array<float, 4>;
  using Uniforms = std::map<std::string, std::variant<int, float, Vector>>;
  using Selection = std::map<std::string, std::string>; // of a folder, the file that Selected stands for

  /// Assembles a file and all that it includes, behind the defines. `Storage/Selected` in an include stands for
  /// "Storage/" + selection["Storage"]. False, with the reason in GetError(), if a file is not in the table or one of
  /// the required defines is mentioned by none of the files; of the offered ones, those that are mentioned are taken.
  bool Assemble(
    const std::string& file, const Defines& required, const Defines& offered = {}, const Selection& selection = {});

  /// The text, to stand behind \#version and \#extension lines.
  const std::string& GetText() const { return this->Text; }
  const std::string& GetError() const { return this->Error; }

  /// The extensions that shaders of this module may use, as \#extension lines for those that the compiler knows.
  static const char* GetExtensions();

  /// Compiles the text, with main behind it; false, with messages that name file and line in GetError(), if that fails.
  /// A context must be current.
  bool Validate(const std::string& main, vtkShader::Type type = vtkShader::Fragment);

  /// Gives a program those of the uniforms that it uses.
  static void SetUniforms(vtkShaderProgram* program, const Uniforms& uniforms);

  /// Replaces anchor in text; false, with the reason in error, if the anchor is not there. who is named in the error.
  static bool Substitute(std::string& text, const std::string& anchor, const std::string& replacement,
    const std::string& who, std::string& error);

  /// Makes the colours that a mapper's shader writes, gl_FragData, plain variables: gatheredColors, where a technique
  /// has all outputs to itself (Shaders/Common/PixelTargets.glsl).
  static std::string FreeOutputs(const std::string& text);

  /// Makes every discard in the main function of a mapper's shader a return, too, or what AFTER_DISCARD stands for.
  /// discard ends a shader there and then (GLSL 4.50, section 6.4), but a driver may let the invocation go on as a
  /// helper, while gl_HelperInvocation is still false: what tries an atomic operation again never ends then
  /// (Documentation/Drivers.md).
  static std::string LeaveAtDiscards(const std::string& text);

private:
  bool Append(const std::string& file, const std::string& includer, int line, bool conditional);
  bool Define(const Defines& defines, bool required, std::string& head);
  std::string NameSources(const std::string& log) const;

  std::string Text;
  std::string Error;
  Selection Selected;
  std::vector<std::string> Open;  // files whose text has begun and not ended
  std::vector<std::string> Whole; // that stand in the text under no condition
  std::vector<std::string> Files; // index + FirstSource = the #line directive's source number
};
VTK_ABI_NAMESPACE_END

#endif
