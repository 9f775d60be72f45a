// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyGeometry
 *
 * Draws the translucent props of a frame with the technique's text in their shaders: those that it reaches together,
 * the others one by one behind them, each layer by layer (vtkTranslucencyLayers).
 */
#ifndef vtkTranslucencyGeometry_h
#define vtkTranslucencyGeometry_h

#include "vtkTranslucencyStage.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderState;
class vtkTranslucencyFrameShaders;
class vtkTranslucencyPass;
struct vtkTranslucencyResources;

class vtkTranslucencyGeometry
{
public:
  vtkTranslucencyGeometry(vtkTranslucencyPass* pass, vtkTranslucencyResources& resources, const vtkRenderState* state,
    vtkOpenGLRenderWindow* window, vtkTranslucencyFrameShaders& shaders);

  /// Draws a stage's props, with colours or for what the shaders store only. If any is given it becomes whether a
  /// fragment was left by the depth test and by the gather; that waits for the drawing's end.
  void Draw(const vtkTranslucencyStage& stage, bool colors, bool* any = nullptr);

  /// Casts rays through the lists of fragments, volume by volume.
  void DrawVolumes();

  /// Makes OpenGL ready to blend a stage's colours.
  void PrepareColors(const vtkTranslucencyStage& stage);

  /// After a drawing: why it was not all drawn by the technique, empty if it was.
  std::string GetObstacle() const;

private:
  bool NeedsDepthTest();
  void PrepareDrawing();
  void Prepare(const vtkTranslucencyStage& stage, bool colors);
  void DrawOnce(const vtkTranslucencyStage& stage, bool colors, bool* any);
  void DrawProps(const vtkRenderState* state, const vtkTranslucencyStage& stage, bool colors, bool* any);
  void DrawUnreached(vtkProp* prop, const vtkTranslucencyStage& stage, bool colors, bool* any);
  bool HandOver(vtkProp* prop, int layer, bool* any);

  vtkTranslucencyPass* Pass;
  vtkTranslucencyResources& Resources;
  const vtkRenderState* State;
  vtkOpenGLRenderWindow* Window;
  vtkTranslucencyFrameShaders& Shaders;
  bool Settled = false; // the samplers, in this frame
};
VTK_ABI_NAMESPACE_END

#endif
