// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyFactory
 * @brief   the techniques by name
 *
 * Every user interface (Python, the command, ParaView) finds the techniques here: this module's own, by the names of
 * the field, and VTK's for comparison: "blend" (unsorted blending), "vtk-peel" (dual depth peeling), "vtk-oit" (VTK's
 * weighted pass). A technique is added by one row of the table in vtkTranslucencyFactory.cxx.
 */
#ifndef vtkTranslucencyFactory_h
#define vtkTranslucencyFactory_h

#include "vtkObject.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <string> // for names

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkRenderPass;
class vtkRenderer;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyFactory : public vtkObject
{
public:
  static vtkTranslucencyFactory* New();
  vtkTypeMacro(vtkTranslucencyFactory, vtkObject);

  static int GetNumberOfTechniques();

  ///@{
  /**
   * Name and one-line description of a technique, by its index; empty outside 0..GetNumberOfTechniques()-1.
   */
  static std::string GetTechniqueName(int index);
  static std::string GetTechniqueHelp(int index);
  ///@}

  /**
   * A new pass of the technique, to stand as vtkRenderStepsPass's translucent pass; null, after an error that lists the
   * names, if there is none of that name. This module's own are vtkTranslucencyPass, with options and statistics.
   */
  VTK_NEWINSTANCE static vtkRenderPass* CreateTechnique(const std::string& name);

  ///@{
  /**
   * Makes the renderer draw with the technique, beside everything else that it does: its effects (UseFXAA, UseSSAO,
   * UseShadows, UseHiddenLineRemoval) stay as they are, and in a pass that it has, or a chain of them, the technique
   * takes the place of what draws translucent props there. Both may change afterwards, in any order: before each frame
   * the technique is put into the pass that the renderer has by then, a null one included. A pass in which there is no
   * place for it that is known is replaced here, and left alone if it is set afterwards, with a warning that names it.
   * On a renderer that has a technique, that one is exchanged and nothing else.
   *
   * Returns the technique's pass, owned by the renderer, for its options; null, after an error, if there is none of
   * that name. One that was made before, with its options, can be given instead; then it is returned whether the
   * renderer draws with it. A renderer of ParaView that draws together with those of other processes stays as it was,
   * after an error of its that tells what to do instead.
   */
  static vtkRenderPass* Enable(vtkRenderer* renderer, const std::string& name);
  static bool Enable(vtkRenderer* renderer, vtkRenderPass* technique);
  ///@}

  /**
   * The technique's pass that was put into the renderer by Enable; null where there is none.
   */
  static vtkRenderPass* GetTechnique(vtkRenderer* renderer);

  /**
   * Takes the technique out again: the renderer and its passes are as they would be without. Does nothing where there
   * is none.
   */
  static void Disable(vtkRenderer* renderer);

  ///@{
  /**
   * A new pass that draws all that a renderer draws, with its effects and with the technique where it draws what is
   * translucent; for those who have a camera pass of their own above it, as ParaView's views. What this module's own
   * techniques draw they draw with volumes among it.
   */
  VTK_NEWINSTANCE static vtkRenderPass* CreateSteps(vtkRenderPass* technique);

  /**
   * Empty if the driver behind the window can run the technique, else what is missing. The window must have rendered
   * once. The same of a driver that has an OpenGL of this version, and nothing beyond it.
   */
  static std::string GetMissing(const std::string& name, vtkOpenGLRenderWindow* window);
  static std::string GetMissing(const std::string& name, int major, int minor);
  ///@}

protected:
  vtkTranslucencyFactory() = default;
  ~vtkTranslucencyFactory() override = default;

private:
  vtkTranslucencyFactory(const vtkTranslucencyFactory&) = delete;
  void operator=(const vtkTranslucencyFactory&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
