// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyDisplay
 * @brief   Whether VTK can draw in a window at all, before it tries to
 *
 * VTK up to 9.3, as Debian builds it, ends the process where a window's first frame finds no X display, and later
 * releases draw nothing where they find no display, no EGL and no OSMesa. All of them go on with an OpenGL that is too
 * old, and crash in the middle of it.
 */
#ifndef vtkTranslucencyDisplay_h
#define vtkTranslucencyDisplay_h

#include "vtkObject.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyDisplay : public vtkObject
{
public:
  static vtkTranslucencyDisplay* New();
  vtkTypeMacro(vtkTranslucencyDisplay, vtkObject);

  /**
   * Returns what VTK lacks to draw in a window, as a sentence that says what to do; empty if nothing. Opens another
   * window like it, off-screen, where none of its class has been looked at; says nothing, and leaves the window alone.
   * Of windows that have drawn, and of those whose context VTK does not make (Qt's, for example), there is nothing to
   * say.
   */
  static std::string GetMissing(vtkRenderWindow* window);

protected:
  vtkTranslucencyDisplay() = default;
  ~vtkTranslucencyDisplay() override = default;

private:
  vtkTranslucencyDisplay(const vtkTranslucencyDisplay&) = delete;
  void operator=(const vtkTranslucencyDisplay&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
