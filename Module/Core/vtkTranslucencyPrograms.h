// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyPrograms
 *
 * The programs of a pass that are none of a mapper's, kept from frame to frame, and drawing with them: vertices that no
 * buffer holds.
 */
#ifndef vtkTranslucencyPrograms_h
#define vtkTranslucencyPrograms_h

#include "vtkTranslucencyShader.h"

#include <functional>
#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkTranslucencyPrograms
{
public:
  vtkTranslucencyPrograms() = default;
  vtkTranslucencyPrograms(const vtkTranslucencyPrograms&) = delete;
  vtkTranslucencyPrograms& operator=(const vtkTranslucencyPrograms&) = delete;

  /// The parts of a program. Both shaders begin with VTK's mark for its version.
  struct Source
  {
    std::string Vertex;
    std::string Fragment;
  };

  /// Makes the program of a key ready. The first time it is made from what assemble gives; null if that is false, or
  /// the driver refuses it. Then validate is called, which says what it has against a shader; where it is true, nothing
  /// against either of them, VTK says why they don't link.
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& key,
    const std::function<bool(Source& source)>& assemble, const std::function<bool()>& validate);

  /// What a shader is made from, as one string.
  static std::string GetKey(const std::string& name, const vtkTranslucencyShader::Defines& defines,
    const vtkTranslucencyShader::Defines& offered = {});

  void DrawVertices(unsigned int primitive, int count);

  /// Programs are the window's shader cache's and go with it.
  void Release(bool contextAlive);

private:
  std::map<std::string, vtkShaderProgram*> Programs;
  unsigned int VertexArray = 0;
};
VTK_ABI_NAMESPACE_END

#endif
