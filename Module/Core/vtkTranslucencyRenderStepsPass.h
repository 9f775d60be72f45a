/**
 * @class   vtkTranslucencyRenderStepsPass
 * @brief   vtkRenderStepsPass with what a renderer does without a pass and that one leaves out
 *
 * - Stereo: vtkRenderer lets its camera set itself up before it draws, which tells the camera whether the window is in stereo. VTK's
 *   camera pass does not: under it both eyes see the picture from the middle between them.
 * - Selection: vtkHardwareSelector draws the props itself, to give each its number. Under VTK's passes it is not asked to, and selects
 *   nothing.
 */
#ifndef vtkTranslucencyRenderStepsPass_h
#define vtkTranslucencyRenderStepsPass_h

#include "vtkRenderStepsPass.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyRenderStepsPass : public vtkRenderStepsPass
{
public:
  static vtkTranslucencyRenderStepsPass* New();
  vtkTypeMacro(vtkTranslucencyRenderStepsPass, vtkRenderStepsPass);

  void Render(const vtkRenderState* state) override;

protected:
  vtkTranslucencyRenderStepsPass();
  ~vtkTranslucencyRenderStepsPass() override = default;

private:
  vtkTranslucencyRenderStepsPass(const vtkTranslucencyRenderStepsPass&) = delete;
  void operator=(const vtkTranslucencyRenderStepsPass&) = delete;
};

#endif
