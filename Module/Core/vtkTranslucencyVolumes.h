// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyVolumes
 *
 * Volumes among translucent surfaces: on their way through the lists, rays are cast from fragment to fragment, and what
 * a segment of the ray gathers becomes a fragment of the list, between the two that bound it. Techniques resolve it
 * like any other.
 *
 * vtkDualDepthPeelingPass casts a ray between each two layers that it peels, in every peel, and takes the samples at
 * both ends of each part anew. Here a ray is cast once, whatever the number of surfaces, and takes the samples that it
 * takes without them.
 *
 * That is done by the shader of vtkGPUVolumeRayCastMapper, also behind vtkSmartVolumeMapper, vtkMultiBlockVolumeMapper
 * and vtkMultiVolume, where it draws into the picture itself. Others (ray casters on the CPU, projected tetrahedra, an
 * ImageSampleDistance other than 1) can't be divided: they are drawn over the surfaces, as VTK does without peeling,
 * after a warning, and so are volumes inside of assemblies and vtkLODProp3D.
 *
 * Volumes that overlap are each divided at the others' segments, too.
 */
#ifndef vtkTranslucencyVolumes_h
#define vtkTranslucencyVolumes_h

#include "vtkTranslucencyABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkProp;
class vtkRenderPass;
class vtkRenderState;
class vtkShaderProgram;

class vtkTranslucencyVolumes
{
public:
  /// Looks for volumes among the props. A null pass draws none. Where they are not to be divided, none may be gathered.
  void Find(const vtkRenderState* state, vtkRenderPass* pass, bool divided);

  vtkRenderPass* GetPass() const { return this->Pass; }

  /// Those that may be gathered.
  const std::vector<vtkProp*>& GetProps() const { return this->Props; }

  /// What ray casters' shaders have to declare: Common/GatherVolume.glsl.
  void SetGatherText(const std::string& text) { this->GatherText = text; }

  /// Draws a state of one volume, whose shader stores what it finds, in so many rounds (Common/GatherVolume.glsl).
  void Gather(const vtkRenderState* one, int rounds);

  /// Draws what is not among GetProps() or could not be gathered, over what is there. Gives what it was: empty if
  /// nothing.
  std::string DrawUndivided(const vtkRenderState* state);

  // Of vtkOpenGLRenderPass, for ray casters.
  static bool IsRayCaster(vtkAbstractMapper* mapper);
  bool PreReplaceShaderValues(std::string& fragmentShader, const std::string& who, std::string& error) const;
  bool PostReplaceShaderValues(std::string& fragmentShader, const std::string& who, std::string& error) const;
  void SetShaderParameters(vtkShaderProgram* program);

private:
  std::vector<vtkProp*> Props;
  std::vector<vtkProp*> Others;
  vtkRenderPass* Pass = nullptr;
  std::string GatherText;
  unsigned int Framebuffer = 0; // that is drawn to
  bool Gathered = false;        // the volume that is being drawn
  int Round = 0;
};
VTK_ABI_NAMESPACE_END

#endif
