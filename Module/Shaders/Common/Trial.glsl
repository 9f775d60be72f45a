// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Trial.glsl: a shader that is compiled once for each window and never drawn: whether the compiler takes, in shaders of
// VTK's version of GLSL, what its driver says that it has. By their specifications some extensions may be refused there
// (Documentation/Drivers.md).
//
// Needs: TRIAL (TRIAL_STORAGE: what every shader of this module asks for; TRIAL_MASKS: coverage masks behind the depth
// test; TRIAL_FETCH: colours that fragments fetch; TRIAL_INTERLOCK: critical sections of the hardware, with
// CriticalSection/Interlock.glsl selected, elsewhere None.glsl).  Gives: main.
#ifndef TRIAL
#error "Trial.glsl needs TRIAL"
#endif
#define TRIAL_STORAGE 0
#define TRIAL_MASKS 1
#define TRIAL_FETCH 2
#define TRIAL_INTERLOCK 3
#include "Common/Bindings.glsl"
#include "CriticalSection/Selected.glsl"

layout(early_fragment_tests) in;

#if TRIAL == TRIAL_MASKS
#ifndef GL_ARB_post_depth_coverage
#error "the compiler does not know GL_ARB_post_depth_coverage in this version of GLSL"
#endif
layout(post_depth_coverage) in;
#endif

#if TRIAL == TRIAL_FETCH
#ifndef GL_EXT_shader_framebuffer_fetch
#error "the compiler does not know GL_EXT_shader_framebuffer_fetch in this version of GLSL"
#endif
layout(location = 0) inout uvec4 trialColor;
#else
out uvec4 trialColor;
#endif

layout(std140, binding = UNIFORM_BINDING_STORAGE) uniform TrialBlock
{
  uint trialPlace;
};

layout(std430, binding = STORAGE_BINDING_TABLE) coherent buffer TrialTable
{
  uint trialTable[];
};

layout(std430, binding = STORAGE_BINDING_FRAGMENTS) buffer TrialFragments
{
  uvec4 trialFragments[];
};

uniform usamplerBuffer trialTexels;

void main()
{
  uint mask = uint(gl_SampleMaskIn[0]) >> uint(gl_SampleID);
  uint place = 0u;
  BEGIN_CRITICAL_SECTION
  if (atomicCompSwap(trialTable[trialPlace], 0u, 1u) == 0u)
  {
    memoryBarrier();
    place = atomicAdd(trialTable[trialPlace + 1u], uint(findLSB(mask) + bitCount(mask)));
    atomicExchange(trialTable[trialPlace], 0u);
  }
  END_CRITICAL_SECTION
  if (place < uint(trialFragments.length()))
  {
    trialFragments[place] = uvec4(packUnorm4x8(gl_FragCoord), packUnorm2x16(gl_FragCoord.xy),
      floatBitsToUint(gl_FragCoord.z), texelFetch(trialTexels, int(place)).x);
  }
  trialColor = uvec4(place);
}
