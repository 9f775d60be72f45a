// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Tile.glsl: which pixels are drawn now, and which samples they have.
//
// Needs: SAMPLES (1 to 8), TARGET_SAMPLES.  Gives: ALL_SAMPLES, inTile.
#ifndef Tile_glsl
#define Tile_glsl
#include "Common/Frame.glsl"
#ifndef SAMPLES
#error "Tile.glsl needs SAMPLES"
#endif
#ifndef TARGET_SAMPLES
#error "Tile.glsl needs TARGET_SAMPLES"
#endif

#define ALL_SAMPLES ((1u << SAMPLES) - 1u)

// Whether a pixel belongs to the tile. The scissor test should see to it; with several samples llvmpipe also shades
// pixels beside the rectangle, whose fragments would end up in other pixels' lists, and whose colours would be drawn
// twice.
bool inTile(ivec2 pixel)
{
#if SAMPLES > 1 || TARGET_SAMPLES > 1
  ivec2 at = pixel - frameTile.xy;
  return all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, frameTile.zw));
#else
  return true;
#endif
}

#endif
