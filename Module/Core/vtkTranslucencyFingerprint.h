// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyFingerprint
 *
 * What a picture is drawn from, as numbers: mostly the modification times of all objects that take part, which VTK
 * never gives twice, and whose addresses tell which they are. Two frames of equal numbers show the same. Brings the
 * pipelines up to date, as drawing would.
 *
 * Actors within assemblies are modified by being drawn: of those it is matrix, visibility, property, textures and
 * mapper that count.
 */
#ifndef vtkTranslucencyFingerprint_h
#define vtkTranslucencyFingerprint_h

#include "vtkTranslucencyABINamespace.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkAlgorithm;
class vtkAssemblyPath;
class vtkDataObject;
class vtkMatrix4x4;
class vtkObject;
class vtkProp;
class vtkRenderState;
class vtkRenderer;
class vtkTexture;

class vtkTranslucencyFingerprint
{
public:
  void Add(double number);
  void AddView(const vtkRenderState* state);

  const std::vector<vtkTypeUInt64>& GetNumbers() const { return this->Numbers; }

private:
  void AddObject(vtkObject* object);
  void AddMatrix(vtkMatrix4x4* matrix);
  void AddData(vtkDataObject* data);
  void AddAlgorithm(vtkAlgorithm* algorithm);
  void AddRenderer(vtkRenderer* renderer);
  void AddProp(vtkProp* prop);
  void AddPath(vtkAssemblyPath* path);
  void AddActor(vtkActor* actor);
  void AddShaderProperty(vtkProp* prop);

  std::vector<vtkTypeUInt64> Numbers;
};
VTK_ABI_NAMESPACE_END

#endif
