// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLayerPeeling
 *
 * Peels a layer of each pixel in a drawing of the geometry, or the nearest and the farthest one: FrontToBack and Dual
 * of vtkDepthPeelPass, which tells how.
 */
#ifndef vtkLayerPeeling_h
#define vtkLayerPeeling_h

#include "vtkPeelingSettings.h"
#include "vtkTranslucencyStage.h"
#include "vtkTranslucencyTargets.h"

#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkTranslucencyFrame;

class vtkLayerPeeling
{
public:
  /// Draws the current tile. Where layers are kept, from front to back only, each becomes one more image.
  bool Render(vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings, bool dual, bool keepLayers);

  std::vector<vtkSmartPointer<vtkImageData>>& GetImages() { return this->Images; }

  vtkTypeInt64 GetBytes() const { return this->Peeled.GetBytes() + this->Merged.GetBytes(); }
  void Release(bool contextAlive);

private:
  bool Peel(vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings, bool keepLayers,
    bool& left); // left becomes whether fragments are
  bool KeepLayer(vtkTranslucencyFrame& frame);
  bool AddTail(vtkTranslucencyFrame& frame);
  vtkTranslucencyShader::Defines GetMethod() const;
  vtkTranslucencyGathering GetGathering() const;

  bool Dual = false;
  vtkTranslucencyTargets
    Peeled; // by the last drawing: bounds of the next layers (Shaders/Peel/Methods.glsl), front layer, back layer
  vtkTranslucencyTargets Merged; // bounds of these layers, layers from the front, layers from the back
  std::vector<vtkSmartPointer<vtkImageData>> Images;
};
VTK_ABI_NAMESPACE_END

#endif
