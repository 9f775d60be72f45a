// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyShaderWatch
 *
 * A window's shader cache that tells which programs are made ready, before anything is drawn by them.
 *
 * A render pass reaches the shaders of a prop by the prop's property keys. Many props draw by actors of their own and
 * don't hand their keys on to them (vtkAnnotatedCubeActor, vtkAxesActor, most representations of widgets), and shaders
 * of the user's own need not have a place for a pass's text. VTK tells neither. But whatever VTK draws by, it asks the
 * window's shader cache for: while a Scope lasts, this object stands there, hands all on to the window's own cache, and
 * reports each program that comes back.
 */
#ifndef vtkTranslucencyShaderWatch_h
#define vtkTranslucencyShaderWatch_h

#include "vtkOpenGLShaderCache.h"
#include "vtkTranslucencyABINamespace.h"
#include "vtkTranslucencyVTKVersion.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLState;

class vtkTranslucencyShaderWatch : public vtkOpenGLShaderCache
{
public:
  static vtkTranslucencyShaderWatch* New();
  vtkTypeMacro(vtkTranslucencyShaderWatch, vtkOpenGLShaderCache);

  using Report = std::function<void(vtkShaderProgram*)>;

  /// While it lasts, programs are reported when they have been bound, but not those that capture vertices instead of
  /// drawing.
  class Scope
  {
  public:
    Scope(vtkTranslucencyShaderWatch* watch, vtkOpenGLState* state, const Report& report);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    vtkTranslucencyShaderWatch* Watch;
    vtkOpenGLState* State;
  };

  // vtkOpenGLShaderCache
  vtkShaderProgram* ReadyShaderProgram(
    const char* vertex, const char* fragment, const char* geometry, vtkTransformFeedback* capture = nullptr) override;
#if VTK_TRANSLUCENCY_TESSELLATION
  vtkShaderProgram* ReadyShaderProgram(const char* vertex, const char* fragment, const char* geometry,
    const char* control, const char* evaluation, vtkTransformFeedback* capture = nullptr) override;
#endif
  vtkShaderProgram* ReadyShaderProgram(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkTransformFeedback* capture = nullptr) override;
  vtkShaderProgram* ReadyShaderProgram(vtkShaderProgram* program, vtkTransformFeedback* capture = nullptr) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ClearLastShaderBound() override;

protected:
  vtkTranslucencyShaderWatch() = default;
  ~vtkTranslucencyShaderWatch() override = default;

private:
  vtkTranslucencyShaderWatch(const vtkTranslucencyShaderWatch&) = delete;
  void operator=(const vtkTranslucencyShaderWatch&) = delete;

  template <typename... Arguments>
  vtkShaderProgram* Ready(vtkTransformFeedback* capture, Arguments... arguments);

  vtkOpenGLShaderCache* Watched = nullptr; // the window's own, while a scope lasts
  Report Tell;
};
VTK_ABI_NAMESPACE_END

#endif
