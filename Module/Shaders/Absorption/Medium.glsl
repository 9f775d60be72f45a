// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Medium.glsl: what a fragment carries of the body that its surface bounds: the number of what fills it, 0 for nothing,
// and whether it is a front face.
//
// Fragments have room for it where there are three transmittances: the signs of six half floats that are never
// negative, or the byte that is left. Nobody unpacks the colour before it is taken out again.
//
// Needs: COLOR_FORMAT, TRANSMITTANCE_CHANNELS (3).  Gives: MEDIUM_NUMBERS, mediumWords, mediumOf, withoutMedium.
#ifndef Medium_glsl
#define Medium_glsl
#include "Common/Channels.glsl"
#include "Absorption/MediumNumbers.glsl"

#if COLOR_FORMAT == COLOR_FORMAT_RGBA8
#define MEDIUM_MASK uvec3(0u, 0xff000000u, 0u)

uvec3 mediumWords(uint medium)
{
  return uvec3(0u, medium << 24u, 0u);
}

uint mediumOf(uvec3 words)
{
  return words.y >> 24u;
}
#else
#define MEDIUM_MASK uvec3(0x80008000u)

uvec3 mediumWords(uint medium)
{
  uvec3 pairs = uvec3(medium, medium >> 2u, medium >> 4u);
  return ((pairs & 1u) << 15u) | ((pairs & 2u) << 30u);
}

uint mediumOf(uvec3 words)
{
  uvec3 pairs = ((words >> 15u) & 1u) | ((words >> 30u) & 2u);
  return pairs.x | (pairs.y << 2u) | (pairs.z << 4u);
}
#endif

uvec3 withoutMedium(uvec3 words)
{
  return words & ~MEDIUM_MASK;
}

#endif
