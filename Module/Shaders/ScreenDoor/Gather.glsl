// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ScreenDoor/Gather.glsl: screen-door transparency: a fragment is dropped, or opaque.
//
// The mask is a square of maskSize * maskSize ranks, repeated over the window. A fragment is kept where opacity > (rank
// + 1/2) / cells so that a flat one is kept in round(opacity * cells) cells of each period.
//
// With MASK_OFFSET, layers have the mask in different places: an object's front and back faces, or each primitive, are
// numbered, and steps of the plastic number (a sequence without large gaps in two dimensions) move the mask for each
// number. Layers that are handed over (Common/HandOver.glsl) are numbered themselves, whatever the mask: they come
// without faces and primitives.
//
// Needs: MASK_OFFSET; maskSize is a power of 2, up to 256.  Gives: gatherFragment.
#ifndef MASK_OFFSET
#error "ScreenDoor/Gather.glsl needs MASK_OFFSET"
#endif

#define NO_OFFSET 0
#define OBJECT_OFFSET 1
#define PRIMITIVE_OFFSET 2

uniform usampler2D maskRanks;
uniform int maskSize;
uniform int gatherPart;
uniform int gatherLayer;

// Which of the places of the mask is this fragment's.
uint maskPlace()
{
#if MASK_OFFSET == OBJECT_OFFSET
  return 2u * uint(gatherPart) + (gl_FrontFacing ? 0u : 1u) + uint(gatherLayer);
#elif MASK_OFFSET == PRIMITIVE_OFFSET
  return uint(gatherPart) + uint(gl_PrimitiveID) + uint(gatherLayer);
#else
  return 0u;
#endif
}

float threshold(uvec2 pixel)
{
  const uvec2 steps = uvec2(12664745u, 9560334u); // 2^24 / p and 2^24 / p^2, where p^3 = p + 1
  uvec2 place = (maskPlace() * steps & 0xffffffu) * uint(maskSize) >> 24u;
  uvec2 cell = (pixel + place) & uint(maskSize - 1);
  uint cells = uint(maskSize * maskSize);
  return (float(texelFetch(maskRanks, ivec2(cell), 0).r) + 0.5) / float(cells);
}

void gatherFragment(vec4 color, float depth, out vec4 outputs[1])
{
  if (color.a <= threshold(uvec2(gl_FragCoord.xy)))
  {
    discard;
  }
  outputs[0] = vec4(color.rgb, 1.0);
}
