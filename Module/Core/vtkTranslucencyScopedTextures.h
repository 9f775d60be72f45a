// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyScopedTextures
 *
 * Binds what a shader reads to texture units of its own. When it goes, what was bound there comes back.
 */
#ifndef vtkTranslucencyScopedTextures_h
#define vtkTranslucencyScopedTextures_h

#include "vtkFragmentStorage.h"
#include "vtkTranslucencyStage.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkTranslucencyScopedTextures
{
public:
  explicit vtkTranslucencyScopedTextures(
    vtkOpenGLRenderWindow* window, const std::vector<vtkTranslucencyStage::Input>& inputs = {});
  ~vtkTranslucencyScopedTextures();
  vtkTranslucencyScopedTextures(const vtkTranslucencyScopedTextures&) = delete;
  vtkTranslucencyScopedTextures& operator=(const vtkTranslucencyScopedTextures&) = delete;

  /// Binds a texture of one of the two kinds of vtkTranslucencyTargets::GetTarget().
  void Bind(const std::string& sampler, unsigned int target, unsigned int texture);

  /// Binds those buffers that a program fetches as texels.
  void BindTexels(const std::vector<vtkFragmentStorage::Texels>& buffers, vtkShaderProgram* program);

  /// By the names of the samplers.
  const vtkTranslucencyShader::Uniforms& GetUnits() const { return this->Units; }

private:
  struct Bound
  {
    int Unit;
    unsigned int Target;
    int Before;
  };

  // Makes a unit active that nobody else uses.
  void UseUnit(const std::string& sampler, unsigned int target, unsigned int binding);

  vtkOpenGLRenderWindow* Window;
  std::vector<Bound> Textures;
  vtkTranslucencyShader::Uniforms Units;
};
VTK_ABI_NAMESPACE_END

#endif
