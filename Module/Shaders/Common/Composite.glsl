// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Composite.glsl: the main function of the last stage of techniques without lists; the technique's file includes it
// last.
//
// It runs once a pixel, or a sample where the window has several.
//
// Needs: resolvePixel(pixel, color, transmittance), false where nothing is to be drawn; TRANSMITTANCE_CHANNELS.  Gives:
// main.
#include "Common/Output.glsl"
#include "Common/Tile.glsl"

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = vec3(0.0);
  Channels transmittance = Channels(1.0);
  if (!inTile(pixel) || !resolvePixel(pixel, color, transmittance))
  {
    discard;
  }
  writeOutput(color, transmittance);
}
