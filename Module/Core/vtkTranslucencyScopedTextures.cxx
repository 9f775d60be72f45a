// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyScopedTextures.h"

#include "vtkTranslucencyBuffer.h"
#include "vtkTranslucencyTargets.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTranslucencyScopedTextures::vtkTranslucencyScopedTextures(
  vtkOpenGLRenderWindow* window, const std::vector<vtkTranslucencyStage::Input>& inputs)
  : Window(window)
{
  for (const vtkTranslucencyStage::Input& input : inputs)
  {
    this->Bind(input.Sampler, input.From->GetTarget(), input.From->GetTexture(input.Index));
  }
}

//------------------------------------------------------------------------------
vtkTranslucencyScopedTextures::~vtkTranslucencyScopedTextures()
{
  for (const Bound& bound : this->Textures)
  {
    this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + bound.Unit));
    glBindTexture(bound.Target, static_cast<GLuint>(bound.Before));
    this->Window->GetTextureUnitManager()->Free(bound.Unit);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyScopedTextures::Bind(const std::string& sampler, unsigned int target, unsigned int texture)
{
  const bool several = target == GL_TEXTURE_2D_MULTISAMPLE;
  this->UseUnit(sampler, target, several ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D);
  glBindTexture(target, texture);
}

//------------------------------------------------------------------------------
void vtkTranslucencyScopedTextures::BindTexels(
  const std::vector<vtkFragmentStorage::Texels>& buffers, vtkShaderProgram* program)
{
  for (const vtkFragmentStorage::Texels& texels : buffers)
  {
    if (program->IsUniformUsed(texels.Sampler))
    {
      this->UseUnit(texels.Sampler, GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER);
      texels.Buffer->BindTexels(texels.Words);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyScopedTextures::UseUnit(const std::string& sampler, unsigned int target, unsigned int binding)
{
  Bound bound{ this->Window->GetTextureUnitManager()->Allocate(), target, 0 };
  this->Window->GetState()->vtkglActiveTexture(static_cast<unsigned int>(GL_TEXTURE0 + bound.Unit));
  glGetIntegerv(binding, &bound.Before);
  this->Textures.push_back(bound);
  this->Units[sampler] = bound.Unit;
}
VTK_ABI_NAMESPACE_END
