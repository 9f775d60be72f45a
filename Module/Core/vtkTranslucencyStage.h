// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 *
 * One drawing of a technique, as it asks vtkTranslucencyFrame for it: what it puts into the shaders, what it draws to
 * and how that is blended.
 */
#ifndef vtkTranslucencyStage_h
#define vtkTranslucencyStage_h

#include "vtkTranslucencyShader.h" // for defines and uniforms
#include "vtkType.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkTranslucencyTargets;

/// What a technique without lists puts into the mappers' shaders. One text serves all stages of a frame, told apart by
/// its uniform gatherStage: mappers build their shaders anew when the text changes.
struct vtkTranslucencyGathering
{
  std::string File; ///< gives gatherFragment(color, depth), with Outputs a third parameter: out vec4 outputs[Outputs]
  vtkTranslucencyShader::Defines Values;
  int Outputs = 0;       ///< colours that are drawn to targets
  bool Critical = false; ///< whether it changes records of pixels under a critical section
  bool Normals = false;  ///< whether gatherFragment wants the normal behind the depth
  bool Atomic = false;   ///< whether it changes words of them by atomic operations
  bool Rejects =
    false; ///< whether File gives rejectsFragment(depth), too: what it is true for is discarded before it is shaded
};

/// One drawing of the translucent props, or of the screen.
struct vtkTranslucencyStage
{
  enum class Blending
  {
    Replace,         ///< fragments take the place of what is there
    Add,             ///< all channels
    AddAndAttenuate, ///< colour is added, alpha multiplied with 1 - alpha
    Attenuate,       ///< all channels are multiplied with 1 - themselves
    Over,            ///< before what is there: front's colours, multiplied by their opacity, and opacity
    Filter, ///< colour before what is there, which is multiplied by a second source colour (Shaders/Common/Output.glsl)
    Under,  ///< behind it: alpha is what is still seen, from 1 on
    Minimum,
    Maximum
  };

  /// How a buffer takes what is drawn to it, and what it holds before.
  struct Buffer
  {
    Blending Blend;
    std::array<float, 4> Clear;
  };

  /// A buffer that a stage reads, by the name of the sampler (Shaders/Common/Target.glsl).
  struct Input
  {
    std::string Sampler;
    const vtkTranslucencyTargets* From;
    int Index;
  };

  enum class Faces
  {
    All = 0,
    Back = 1,
    Front = 2
  };

  /// A prop that is drawn by itself.
  struct Part
  {
    vtkProp* Prop;
    int Number;               ///< what shaders see as their uniform gatherPart
    Faces Drawn = Faces::All; ///< of its polygons; lines and points have no faces and are drawn in any case
  };

  int Number = 0;
  std::vector<Part> Parts; ///< drawn in this order; empty: all props, in theirs
  vtkTranslucencyTargets* Targets =
    nullptr;               ///< drawn to, and cleared before (but see Cleared); null: colours go over the opaque picture
  bool StoresOnly = false; ///< fragments draw no colours, though the gather has outputs for other stages
  Blending Blend = Blending::Add;
  bool HidesBehind = false; ///< fragments write depth, to a depth buffer of the targets that starts as the opaque one
  std::array<float, 4> Clear{ { 0, 0, 0, 0 } };
  std::vector<Input> Inputs;
  vtkTranslucencyShader::Uniforms Values;
  std::map<int, Buffer> Differing; ///< buffers for which Blend and Clear don't hold
  std::set<int> Masked;            ///< buffers that are not drawn to (vtkTranslucencyDrawings)
  int Cleared = VTK_INT_MAX; ///< how many of Targets are cleared, the first ones; the others keep what is in them, of
                             ///< earlier stages or frames
};
VTK_ABI_NAMESPACE_END

#endif
