// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// SampleColors.glsl: the resolved colours of a pixel's samples, on their way into the framebuffer.
//
// Half floats of the colour, multiplied by the opacity, and of what is hidden; all 0, which changes nothing when it is
// blended, until a resolve has written them and again after Common/CompositeSamples.glsl has taken them.
//
// Needs: SAMPLES, TRANSMITTANCE_CHANNELS.  Gives: storeSample; takeSample, false where there is nothing.
#ifndef SampleColors_glsl
#define SampleColors_glsl
#include "Common/Bindings.glsl"
#include "Common/Channels.glsl"
#include "Common/Frame.glsl"
#include "Common/HalfFloat.glsl"

layout(std430, binding = STORAGE_BINDING_SAMPLES) buffer SampleColors
{
#if TRANSMITTANCE_CHANNELS == 3
  uvec4 sampleColors[];
#else
  uvec2 sampleColors[];
#endif
};

uint sampleIndex(ivec2 pixel, int index)
{
  ivec2 at = pixel - frameTile.xy;
  return uint((at.y * frameTile.z + at.x) * SAMPLES + index);
}

#if SAMPLES > 1
#if TRANSMITTANCE_CHANNELS == 3
void storeSample(ivec2 pixel, int index, vec3 color, Channels transmittance)
{
  vec3 hidden = 1.0 - transmittance;
  sampleColors[sampleIndex(pixel, index)] =
    uvec4(packHalves(vec4(color, hidden.r)), packHalves(vec4(hidden.gb, 0.0, 0.0)));
}

bool takeSample(ivec2 pixel, int index, out vec3 color, out Channels transmittance)
{
  uint at = sampleIndex(pixel, index);
  vec4 first = unpackHalves(sampleColors[at].xy);
  vec4 second = unpackHalves(sampleColors[at].zw);
  sampleColors[at] = uvec4(0u);
  color = first.rgb;
  transmittance = 1.0 - vec3(first.a, second.xy);
  return first != vec4(0.0) || second != vec4(0.0);
}
#else
void storeSample(ivec2 pixel, int index, vec3 color, Channels transmittance)
{
  sampleColors[sampleIndex(pixel, index)] = packHalves(vec4(color, 1.0 - transmittance));
}

bool takeSample(ivec2 pixel, int index, out vec3 color, out Channels transmittance)
{
  uint at = sampleIndex(pixel, index);
  vec4 stored = unpackHalves(sampleColors[at]);
  sampleColors[at] = uvec2(0u);
  color = stored.rgb;
  transmittance = 1.0 - stored.a;
  return stored != vec4(0.0);
}
#endif
#endif

#endif
