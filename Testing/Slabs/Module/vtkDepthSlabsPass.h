// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthSlabsPass
 * @brief   draws translucent surfaces and volumes by plain blending, one slab of depth after the other
 *
 * What techniques are compared with, as the translucent pass of a vtkRenderStepsPass; it draws the volumes, too, so
 * that one has no volumetric pass. The camera's range of depths is divided into slabs of equal thickness. They are
 * drawn one after the other, all props in each of them; of the fragments of a surface, and of the samples of a volume's
 * rays, only those whose depth lies in the slab count. Nothing is peeled, stored or sorted, and no ray is cast from
 * another place than without surfaces. Sums are in 32-bit floats.
 *
 * In a slab that is thin enough no order matters. What shares one in a pixel is blended in the order of drawing;
 * FrontToBack blends it the other way round. So where the two pictures are the same, they are the truth.
 *
 * Samples of a ray are slabs of it only where opacity adds up along it (vtkVolumeMapper::COMPOSITE_BLEND). For a volume
 * that is drawn otherwise no slab may end within it: SetUndivided.
 *
 * Windows of one sample only: the depth of the opaque surfaces is copied.
 */
#ifndef vtkDepthSlabsPass_h
#define vtkDepthSlabsPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkTranslucencySlabsModule.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkCamera;
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkTextureObject;
class vtkTranslucentPass;
class vtkVolumetricPass;

class VTKTRANSLUCENCYSLABS_EXPORT vtkDepthSlabsPass : public vtkOpenGLRenderPass
{
public:
  static vtkDepthSlabsPass* New();
  vtkTypeMacro(vtkDepthSlabsPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// How many slabs a frame is divided into, at least 1. Default: 128.
  vtkSetClampMacro(NumberOfSlabs, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfSlabs, int);
  ///@}

  ///@{
  /// Whether the slabs are drawn from the nearest to the farthest, each under the ones before; else each over them,
  /// from the farthest on. Default: false.
  vtkSetMacro(FrontToBack, bool);
  vtkGetMacro(FrontToBack, bool);
  vtkBooleanMacro(FrontToBack, bool);
  ///@}

  ///@{
  /// Distances from the camera, along the view, between which no slab ends. Default: 0, 0 for none.
  vtkSetVector2Macro(Undivided, double);
  vtkGetVector2Macro(Undivided, double);
  ///@}

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* array = nullptr) override;

protected:
  vtkDepthSlabsPass();
  ~vtkDepthSlabsPass() override;

private:
  vtkDepthSlabsPass(const vtkDepthSlabsPass&) = delete;
  void operator=(const vtkDepthSlabsPass&) = delete;

  std::vector<double> GetBorders(vtkCamera* camera) const;
  void Begin(vtkOpenGLRenderWindow* window, const int area[4]);
  void HideBehind(vtkOpenGLRenderWindow* window, float depth);
  void End(vtkOpenGLRenderWindow* window, const int area[4]);

  int NumberOfSlabs = 128;
  bool FrontToBack = false;
  double Undivided[2] = { 0, 0 };

  float Slab[2];                   // the window depths between which the one that is drawn lies
  vtkOpenGLState* State = nullptr; // of the window that is drawn to
  vtkNew<vtkTranslucentPass> Surfaces;
  vtkNew<vtkVolumetricPass> Volumes;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> OpaqueDepth;
  std::unique_ptr<vtkOpenGLQuadHelper> Hiding;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
