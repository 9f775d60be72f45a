// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyMapperHook
 *
 * The mappers' side of a technique: what stands for its pass in the shaders of the props, with all that VTK's hooks
 * need when they are called.
 *
 * vtkTranslucencyFrame gives it a text, and before each drawing what the text is to be drawn with. Mappers refer to it
 * until they draw without it, so it must not keep the pass alive, which may own mappers. Outside of Draw it changes no
 * shader.
 */
#ifndef vtkTranslucencyMapperHook_h
#define vtkTranslucencyMapperHook_h

#include "vtkTranslucencyMedia.h"
#include "vtkTranslucencyOpaqueDepth.h"
#include "vtkTranslucencyStage.h"
#include "vtkTranslucencyVolumes.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkTimeStamp.h"

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class vtkTranslucencyMapperHook : public vtkOpenGLRenderPass
{
public:
  static vtkTranslucencyMapperHook* New();
  vtkTypeMacro(vtkTranslucencyMapperHook, vtkOpenGLRenderPass);

  /// What goes into a mapper's fragment shader.
  struct GatherText
  {
    std::string Declarations;
    std::string Call;     ///< where a fragment has been shaded; GATHERED_DEPTH stands for its depth, GATHERED_NORMAL
                          ///< for its normal
    bool Stores = false;  ///< whether it has effects besides the colours that it draws
    bool Fetches = false; ///< whether it fetches records, and draws them in the place of VTK's colour
    bool Rejects = false; ///< whether it has rejectsFragment, to be asked before the fragment is shaded
  };

  /// The text, and what it was made from: mappers build their shaders anew when that changes.
  void SetText(const std::string& key, const GatherText& text);
  const std::string& GetKey() const { return this->Key; }
  bool FetchesRecords() const { return this->Text.Fetches; }

  /// How props are drawn until it changes.
  struct Drawing
  {
    vtkTranslucencyShader::Uniforms Values; ///< of the stage, its samplers' texture units among them
    bool WritesDepth = false;
    vtkTranslucencyStage::Faces Faces = vtkTranslucencyStage::Faces::All;
    std::function<void()> KeepBlending = [] {}; ///< as the stage wants it, whatever a mapper has set
  };
  Drawing& GetDrawing() { return this->Current; }

  /// What all programs of a tile are given: Shaders/Common/Frame.glsl.
  void SetFrameValues(const vtkTranslucencyShader::Uniforms& values) { this->FrameValues = values; }
  const vtkTranslucencyShader::Uniforms& GetFrameValues() const { return this->FrameValues; }

  void BeginFrame(vtkOpenGLRenderWindow* window, const std::array<int, 4>& viewport);

  /// Draws the props of a state with the text in their shaders, by a pass or a function.
  void Draw(const vtkRenderState* state, vtkRenderPass* pass);
  void Draw(const vtkRenderState* state, const std::function<void()>& draw);

  /// Puts the text into a fragment shader, of a prop or null, that has VTK's marks for it. False, and the shader as it
  /// was, if it lacks one.
  bool Insert(std::string& fragmentShader, vtkProp* prop, const std::string& who) const;

  /// Gives such a shader's program what the current drawing has for a prop. False, with an error noted, if that fails.
  bool SetParameters(vtkShaderProgram* program, vtkProp* prop);

  vtkTranslucencyMedia& GetMedia() { return this->Media; }
  vtkTranslucencyVolumes& GetVolumes() { return this->Volumes; }
  vtkTranslucencyOpaqueDepth& GetOpaqueDepth() { return this->OpaqueDepth; }

  /// What went wrong in the drawings since the error was last cleared, empty if nothing.
  const std::string& GetError() const { return this->Error; }
  void SetError(const std::string& error) { this->Error = error; }

  /// Shaders that were built since it was last asked.
  int TakeShaderBuilds();

  /// Forgets the text and what belongs to the context.
  void Release();

  // vtkOpenGLRenderPass
  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->TextTime; }

protected:
  vtkTranslucencyMapperHook() = default;
  ~vtkTranslucencyMapperHook() override = default;

private:
  vtkTranslucencyMapperHook(const vtkTranslucencyMapperHook&) = delete;
  void operator=(const vtkTranslucencyMapperHook&) = delete;

  std::string Key;
  GatherText Text;
  vtkTimeStamp TextTime;
  Drawing Current;
  vtkTranslucencyShader::Uniforms FrameValues;
  bool Draws = false;                      // while Draw lasts
  vtkOpenGLRenderWindow* Window = nullptr; // of the frame
  vtkTranslucencyOpaqueDepth OpaqueDepth;
  vtkTranslucencyMedia Media;
  vtkTranslucencyVolumes Volumes;
  std::string Error;
  int ShaderBuilds = 0;
};
VTK_ABI_NAMESPACE_END

#endif
