// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyFingerprint.h"

#include "vtkTranslucencyMaterial.h"
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyVTKVersion.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkCollectionIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTimeStamp.h"
#include "vtkUniforms.h"

#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::Add(double number)
{
  vtkTypeUInt64 bits;
  static_assert(sizeof(bits) == sizeof(number), "a number has 64 bits");
  std::memcpy(&bits, &number, sizeof(bits));
  this->Numbers.push_back(bits);
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddObject(vtkObject* object)
{
  this->Numbers.push_back(reinterpret_cast<vtkTypeUInt64>(object));
  this->Numbers.push_back(object ? object->GetMTime() : 0);
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddMatrix(vtkMatrix4x4* matrix)
{
  constexpr int size = 4;
  for (int i = 0; matrix && i < size * size; ++i)
  {
    this->Add(matrix->GetElement(i / size, i % size));
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddView(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  vtkRenderWindow* window = renderer->GetRenderWindow();
  this->AddRenderer(renderer);
  this->Add(window->GetDesiredUpdateRate()); // by which actors choose their level of detail
  for (int i = 0; i < 4; ++i)
  {
    this->Add(window->GetTileViewport()[i]);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  this->AddObject(camera);
  this->AddMatrix(camera->GetModelViewTransformMatrix());
  this->AddMatrix(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  if (renderer->GetPreserveDepthBuffer()) // then what other renderers drew hides fragments: every frame is another
  {
    vtkTimeStamp now;
    now.Modified();
    this->Numbers.push_back(now.GetMTime());
  }
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    this->AddObject(light);
    this->AddMatrix(light->GetTransformMatrix());
  }
  for (int i = 0; i < vtkTranslucencyPropCount(state); ++i)
  {
    this->AddProp(vtkTranslucencyProp(state, i));
  }
}

//------------------------------------------------------------------------------
// Its modification time is another in every frame.
void vtkTranslucencyFingerprint::AddRenderer(vtkRenderer* renderer)
{
  this->Numbers.push_back(reinterpret_cast<vtkTypeUInt64>(renderer));
  for (int i = 0; i < 3; ++i)
  {
    this->Add(renderer->GetAmbient()[i]);
    this->Add(renderer->GetEnvironmentUp()[i]);
    this->Add(renderer->GetEnvironmentRight()[i]);
  }
  this->Add(renderer->GetTwoSidedLighting());
  this->Add(renderer->GetUseShadows());
  this->Add(renderer->GetUseImageBasedLighting());
  this->AddObject(renderer->GetEnvironmentTexture());
  this->AddAlgorithm(renderer->GetEnvironmentTexture());
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddProp(vtkProp* prop)
{
  if (vtkTranslucencyMaterial* material = vtkTranslucencyMaterial::GetMaterial(prop))
  {
    this->AddObject(material);
  }
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    this->AddPath(path);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddPath(vtkAssemblyPath* path)
{
  vtkAssemblyNode* last = path->GetLastNode();
  vtkProp* prop = last->GetViewProp();
  this->AddShaderProperty(prop); // first: it may be made only now, which modifies the prop
  if (path->GetNumberOfItems() == 1)
  {
    this->AddObject(prop);
    this->Numbers.push_back(prop->GetRedrawMTime());
  }
  else
  {
    this->Numbers.push_back(reinterpret_cast<vtkTypeUInt64>(prop));
    this->AddMatrix(last->GetMatrix());
  }
  this->Add(prop->GetVisibility());
  double transmission[3];
  vtkTranslucencyPass::GetTransmissionColor(prop, transmission);
  for (double channel : transmission)
  {
    this->Add(channel);
  }
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    this->AddActor(actor);
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddActor(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  this->AddObject(property);
  this->AddObject(actor->GetBackfaceProperty());
  this->AddObject(actor->GetTexture());
  this->AddAlgorithm(actor->GetTexture());
  for (const auto& texture : property->GetAllTextures())
  {
    this->AddObject(texture.second);
    this->AddAlgorithm(texture.second);
  }
  this->AddObject(actor->GetMapper());
  this->AddAlgorithm(actor->GetMapper());
}

//------------------------------------------------------------------------------
// Values of uniforms do not count as changes of the prop.
void vtkTranslucencyFingerprint::AddShaderProperty(vtkProp* prop)
{
  vtkShaderProperty* shaders = prop->GetShaderProperty();
  this->AddObject(shaders);
  if (shaders)
  {
    this->AddObject(shaders->GetVertexCustomUniforms());
    this->AddObject(shaders->GetGeometryCustomUniforms());
    this->AddObject(shaders->GetFragmentCustomUniforms());
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddAlgorithm(vtkAlgorithm* algorithm)
{
  if (!algorithm || algorithm->GetTotalNumberOfInputConnections() == 0)
  {
    return;
  }
  algorithm->Update();
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      this->AddData(algorithm->GetInputDataObject(port, i));
    }
  }
}

//------------------------------------------------------------------------------
void vtkTranslucencyFingerprint::AddData(vtkDataObject* data)
{
  this->AddObject(data);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      this->AddObject(leaf->GetCurrentDataObject());
    }
  }
}
VTK_ABI_NAMESPACE_END
